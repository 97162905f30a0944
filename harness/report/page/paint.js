// Draws tracks on a canvas. Where changes lie closer than a few pixels, they become one calm band
// with their number: what cannot be told apart is not drawn apart. So a picture takes as long as it
// has pixels, however many events there are.

/** Spans below this width stand in no row of their own while they are close to each other. */
const NARROW_PX = 24;
const CLOSE_PX = { bool: 3, bus: 12, spans: 9 };
const FONT = '11px ui-monospace, "SF Mono", Menlo, Consolas, "DejaVu Sans Mono", monospace';
const SMALL = '10px ui-sans-serif, system-ui, "Segoe UI", "DejaVu Sans", sans-serif';
const GLYPH_PX = 6.7;
/** So many letters of a text that is cut say more than a short one. */
const ENOUGH = 26;
const FRAME_COLOURS = {
  request: "blue",
  reply: "green",
  heartbeat: "violet",
  answer: "violet",
  refusal: "orange",
  output: "blue",
  input: "green",
  acknowledge: "violet",
  fragment: "violet",
  check: "violet",
  unknown: "grey",
};
const GOOD = new Set(["RUN", "OPERATE", "green", "running", "established"]);
const BAD = new Set(["STOP", "CLEAR", "IDLE", "red", "lost", "timed_out", "fault", "faulted"]);

class Painter {
  constructor(context, view, colours) {
    this.context = context;
    this.view = view;
    this.colours = colours;
  }

  /** A track whose upper edge is at `top`. */
  track(track, top) {
    const { context, view } = this;
    context.save();
    context.beginPath();
    context.rect(0, top, view.width, track.height);
    context.clip();
    if (track.drawn === "spans") this._spans(track, top);
    else if (track.drawn === "analog") this._analog(track, top);
    else this._steps(track, top);
    context.restore();
  }

  // --- steps --------------------------------------------------------------------------------

  _steps(track, top) {
    const { view } = this;
    const close = CLOSE_PX[track.drawn] * view.resolution;
    const upper = top + 5;
    const lower = top + track.height - 5;
    const single = track.drawn === "bool" ? this._level : this._value;
    let index = Math.max(0, track.indexAt(view.begin));
    let before = null;
    while (index < track.count && track.startOf(index) < view.end) {
      const start = track.startOf(index);
      const next = this._endOfRun(track, index, close);
      if (next === index) {
        const end = track.endOf(index);
        single.call(this, track, index, view.x(start), view.x(end), upper, lower, before);
        before = track.values[index];
        index++;
      } else {
        const end = next < track.count ? track.startOf(next) : track.end;
        this._busy(view.x(start), view.x(end), upper, lower, next - index, "signal");
        before = null;
        index = next;
      }
    }
  }

  /** The first change behind `index` that stands for `close` ns or longer; `index` if it does. */
  _endOfRun(track, index, close) {
    let at = index;
    while (at < track.count) {
      if (track.endOf(at) - track.startOf(at) >= close) return at;
      if (track.startOf(at) > this.view.end) return at;
      at = Math.max(at + 1, track.indexAt(track.startOf(at) + close));
    }
    return at;
  }

  _level(track, index, from, to, upper, lower, before) {
    const { context, colours } = this;
    const left = Math.max(from, -2);
    const right = Math.min(to, this.view.width + 2);
    const high = Boolean(track.values[index]);
    if (high) {
      context.fillStyle = colours["signal-fill"];
      context.fillRect(left, upper, right - left, lower - upper);
    }
    context.strokeStyle = high ? colours.signal : colours["signal-low"];
    context.lineWidth = 1.5;
    context.beginPath();
    if (before !== null && from >= -2) {
      context.moveTo(from, high ? lower : upper);
      context.lineTo(from, high ? upper : lower);
    }
    context.moveTo(left, high ? upper : lower);
    context.lineTo(right, high ? upper : lower);
    context.stroke();
  }

  _value(track, index, from, to, upper, lower) {
    const { context, colours } = this;
    const left = Math.max(from, -8);
    const right = Math.min(to, this.view.width + 8);
    const middle = (upper + lower) / 2;
    context.lineWidth = 1;
    if (track.idle(index)) {
      context.strokeStyle = colours["signal-low"];
      context.beginPath();
      context.moveTo(left, middle);
      context.lineTo(right, middle);
      context.stroke();
    } else {
      const tone = this._tone(track.values[index]);
      const slope = Math.min(4, (to - from) / 2);
      context.beginPath();
      context.moveTo(left, middle);
      context.lineTo(left + slope, upper);
      context.lineTo(right - slope, upper);
      context.lineTo(right, middle);
      context.lineTo(right - slope, lower);
      context.lineTo(left + slope, lower);
      context.closePath();
      context.fillStyle = colours[`${tone}-fill`];
      context.fill();
      context.strokeStyle = colours[tone];
      context.stroke();
    }
    this._label(this._texts(track, index), left + 7, right - 6, middle, FONT, colours.ink, track.idle(index));
  }

  _tone(value) {
    if (GOOD.has(value)) return "green";
    return BAD.has(value) ? "red" : "signal";
  }

  /** What can be written in a segment, the longest first. */
  *_texts(track, index) {
    if (track.word !== null) yield `${track.text(index, true)}  ${track.meaning(index)}`;
    yield track.text(index, true);
  }

  // --- what is too close to be told apart --------------------------------------------------

  _busy(from, to, upper, lower, number, tone) {
    const { context, colours, view } = this;
    const left = Math.max(from, -2);
    const right = Math.max(Math.min(to, view.width + 2), left + 1.5);
    context.fillStyle = colours[`${tone}-busy`];
    context.fillRect(left, upper, right - left, lower - upper);
    context.fillStyle = colours[tone];
    context.fillRect(left, upper, right - left, 1);
    context.fillRect(left, lower - 1, right - left, 1);
    this._label([`${number} changes`, `${number}`], left + 4, right - 3, (upper + lower) / 2, SMALL, colours.ink);
  }

  /** The first of the texts that fits; a long one is cut if it is the last. */
  _label(texts, left, right, middle, font, colour, plain = false) {
    const from = Math.max(left, 4);
    const room = Math.min(right, this.view.width - 2) - from;
    if (room < 12) return;
    const { context } = this;
    context.font = font;
    context.textBaseline = "middle";
    const most = Math.floor(room / (font === FONT ? GLYPH_PX : 5.6));
    let last = "";
    for (const text of texts) {
      last = text;
      if (text.length <= most || most >= ENOUGH) break;
    }
    if (!last || (last.length > most && most < 4)) return;
    const shown = last.length > most ? `${last.slice(0, most - 1)}\u2026` : last;
    if (plain) {
      context.fillStyle = this.colours.panel;
      context.fillRect(from - 3, middle - 6, shown.length * GLYPH_PX + 6, 12);
    }
    context.fillStyle = plain ? this.colours.muted : colour;
    context.fillText(shown, from, middle + 0.5);
  }

  // --- analogue values ----------------------------------------------------------------------

  _analog(track, top) {
    const { context, view, colours } = this;
    const { low, high } = track.scale;
    const upper = top + 15;
    const lower = top + track.height - 7;
    const size = high - low || 1;
    const y = (value) => lower - ((value - low) / size) * (lower - upper);
    const smooth = /\.(frequency|current)$/.test(track.path) ? SMOOTH_NS : 0;
    context.strokeStyle = colours.grid;
    context.lineWidth = 1;
    context.strokeRect(-2, Math.round(y(0)) + 0.5, view.width + 4, 0);
    const first = Math.max(0, track.indexAt(view.begin));
    const last = Math.min(track.count - 1, track.indexAt(view.end) + 1);
    const dashed = track.path.endsWith(".set_point");
    context.strokeStyle = dashed ? colours.orange : colours.signal;
    context.lineWidth = 1.5;
    context.beginPath();
    this._course(track, first, last, y, smooth);
    context.stroke();
    if (!dashed && track.scale.whole) {
      context.lineTo(view.x(track.endOf(last)), y(0));
      context.lineTo(view.x(track.startOf(first)), y(0));
      context.fillStyle = colours["signal-faint"];
      context.fill();
    }
    context.font = SMALL;
    context.textBaseline = "middle";
    context.fillStyle = colours.muted;
    const unit = track.unit ? ` ${track.unit}` : "";
    context.fillText(`${Number(high.toPrecision(4))}${unit}`, 4, top + 7);
    if (low < 0) context.fillText(`${Number(low.toPrecision(4))}${unit}`, 4, lower + 2);
  }

  /** One path for all changes in sight; of those in one pixel the first, least, most and last. */
  _course(track, first, last, y, smooth) {
    const { context, view } = this;
    let before = null;
    let column = null;
    for (let index = first; index <= last; index++) {
      const value = track.values[index];
      if (!Number.isFinite(value)) {
        if (before !== null) context.lineTo(view.x(track.startOf(index)), before.height);
        before = null;
        continue;
      }
      const time = track.startOf(index);
      const x = view.x(time);
      const height = y(value);
      if (before === null) context.moveTo(x, height);
      else {
        if (column !== null && Math.floor(x) === column) {
          context.lineTo(column + 0.5, height);
          before = { time, height };
          continue;
        }
        if (time - before.time > smooth) context.lineTo(x, before.height);
        context.lineTo(x, height);
      }
      before = { time, height };
      column = Math.floor(x);
    }
    if (before !== null) context.lineTo(view.x(track.endOf(last)), before.height);
  }

  // --- spans --------------------------------------------------------------------------------

  _spans(track, top) {
    track.lanes.forEach((lane, number) => this._lane(lane, top + number * HEIGHTS.lane));
  }

  _lane(lane, top) {
    const { view } = this;
    const close = CLOSE_PX.spans * view.resolution;
    const upper = top + 3;
    const lower = top + HEIGHTS.lane - 3;
    let index = Math.max(0, lastNotAfter(lane.starts, view.begin));
    while (index < lane.items.length && lane.starts[index] < view.end) {
      const next = this._endOfCrowd(lane, index, close);
      if (next - index > 1) this._crowd(lane, index, next, upper, lower);
      else this._span(lane.items[index], upper, lower, view.x(lane.starts[index + 1] ?? Infinity));
      index = Math.max(next, index + 1);
    }
  }

  /** Short spans in a row with short gaps between them: the number of the first behind them. */
  _endOfCrowd(lane, index, close) {
    const wide = NARROW_PX * this.view.resolution;
    let at = index;
    while (at < lane.items.length && lane.ends[at] - lane.starts[at] < wide) {
      if (at + 1 < lane.items.length && lane.starts[at + 1] - lane.ends[at] > close) return at + 1;
      if (lane.starts[at] > this.view.end) return at;
      at++;
    }
    return at;
  }

  /** A band in the colour of the first; below its edge, where something went wrong in it. */
  _crowd(lane, first, behind, upper, lower) {
    const { context, colours, view } = this;
    const tone = toneOf(lane.items[first]);
    const left = Math.max(view.x(lane.starts[first]), -2);
    const right = Math.max(Math.min(view.x(lane.ends[behind - 1]), view.width + 2), left + 2);
    context.fillStyle = colours[`${tone === "red" || tone === "orange" ? "grey" : tone}-busy`];
    context.fillRect(left, upper, right - left, lower - upper);
    let drawn = -Infinity;
    for (let index = first; index < behind; index++) {
      const found = toneOf(lane.items[index]);
      const x = Math.floor(view.x(lane.starts[index]));
      if ((found !== "red" && found !== "orange") || x <= drawn) continue;
      context.fillStyle = colours[found];
      context.fillRect(x, lower - 3, 2, 3);
      drawn = x + 1;
    }
    const number = behind - first;
    this._label([`${number} in a row`, `${number}`], left + 4, right - 3, (upper + lower) / 2, SMALL, colours.ink);
  }

  _span(item, upper, lower, next) {
    const { context, colours, view } = this;
    const tone = toneOf(item);
    const left = Math.max(view.x(item.start), -4);
    const right = Math.max(Math.min(view.x(item.end), view.width + 4), left + 2);
    context.fillStyle = colours[`${tone}-fill`];
    context.strokeStyle = colours[tone];
    context.lineWidth = 1;
    context.beginPath();
    context.roundRect(left, upper, right - left, lower - upper, Math.min(3, (right - left) / 2));
    context.fill();
    context.stroke();
    const text = [item.title ?? item.meaning ?? ""];
    const middle = (upper + lower) / 2;
    if (right - left >= 40) this._label(text, left + 5, right - 4, middle, SMALL, colours.ink);
    else if (right > 0 && next - right > 60) this._label(text, right + 4, Math.min(next, right + 420) - 4, middle, SMALL, colours.muted);
  }
}

/** How long the inverters' frequency runs straight at most: the recorder looks every 10 ms. */
const SMOOTH_NS = 10_500_000;

/** The colour of a span: what failed or was disturbed is red. */
function toneOf(item) {
  if (item.type === "mark") {
    if (item.verdict === "failed") return "red";
    return item.kind === "fault" ? "orange" : item.verdict === "passed" ? "green" : "grey";
  }
  if (item.type === "telegram") return item.input === null ? "orange" : "blue";
  return item.damaged || item.collided ? "red" : FRAME_COLOURS[item.kind];
}
