// The timing diagram: labels on the left, tracks on a canvas, one time axis above them.

const RULER_PX = 44;
const HEADING_PX = 24;
/** How far left of its instant a flag stands that leaves room for that of a cursor. */
const ASIDE_PX = 9;

class Diagram {
  constructor(host, trace) {
    this.host = host;
    this.trace = trace;
    this.view = new View(trace);
    this.tracks = tracksOf(trace);
    this.level = ALWAYS;
    this.filter = "";
    this.closed = new Set();
    this.kept = new Set(trace.failures().map((mark) => mark.target.toLowerCase()));
    this.cursors = { A: null, B: null };
    this.selected = null;
    this.onPaper = false;
    this._build();
    this._firstView();
    this.arrange();
    new ResizeObserver(() => this.resized()).observe(this.stage);
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.recolour());
  }

  // --- parts of the page --------------------------------------------------------------------

  _build() {
    this.labels = make("div", { className: "labels" });
    this.ruler = make("canvas", { className: "ruler", "aria-hidden": "true" });
    this.canvas = make("canvas", { className: "waves" });
    this.overview = make("canvas", { className: "overview", "aria-hidden": "true" });
    this.corner = make("div", { className: "corner" });
    this.stage = make("div", {
      className: "stage",
      tabIndex: 0,
      role: "application",
      "aria-label": `Timing diagram of ${this.trace.title}`,
      "aria-keyshortcuts": "ArrowLeft ArrowRight ArrowUp ArrowDown + - 0 n p f b x ?",
    }, this.canvas);
    this.scroller = make("div", { className: "scroller" }, this.corner, this.ruler, this.labels, this.stage);
    this.tip = make("div", { className: "tip", hidden: true });
    this.inspector = make("aside", { className: "inspector", "aria-label": "At the cursor" });
    this.live = make("p", { className: "hidden", "aria-live": "polite" });
    this.toolbar = buildToolbar(this);
    const body = make("div", { className: "diagram-body" }, this.scroller, this.inspector);
    this.events = new EventTable(this);
    this.host.append(this.toolbar.element, this.overview, body, this.tip, this.live, this.events.element);
    this.colours = coloursOf(this.host);
    followPointer(this);
    followKeys(this);
    this.scroller.addEventListener("scroll", () => this.changed());
  }

  /** What failed first, with what went before it; without failures the whole run. */
  _firstView() {
    const [failure] = this.trace.failures();
    if (failure === undefined) {
      this.cursors.A = this.trace.start;
      return;
    }
    const lasted = Math.max(failure.end - failure.start, 50e6);
    this.view.show(failure.start - lasted * 0.25, failure.end + lasted * 0.15);
    this.cursors.A = failure.end;
    this.selected = this._trackOf(failure.target);
  }

  _trackOf(path) {
    const wanted = path.toLowerCase();
    return this.tracks.find((track) => track.path.toLowerCase() === wanted) ?? null;
  }

  // --- which tracks are shown ---------------------------------------------------------------

  /** The tracks that the filter and the level let through, and where each is. */
  arrange() {
    const words = this.filter.toLowerCase().split(/\s+/).filter(Boolean);
    const fits = (track) => {
      const text = `${track.heading} ${track.path} ${track.title}`.toLowerCase();
      if (words.length) return words.every((word) => text.includes(word)) && track.level <= Math.max(this.level, CHANGING);
      return track.level <= this.level || this.kept.has(track.path.toLowerCase()) || track === this.selected;
    };
    this.rows = [];
    let top = 0;
    let heading = null;
    for (const track of this.tracks.filter(fits)) {
      if (track.heading !== heading) {
        heading = track.heading;
        this.rows.push({ heading, top, height: HEADING_PX });
        top += HEADING_PX;
      }
      if (this.closed.has(heading)) continue;
      this.rows.push({ track, top, height: track.height });
      top += track.height;
    }
    this.height = top;
    this._label();
    this.resized();
  }

  get shown() {
    return this.rows.filter((row) => row.track).map((row) => row.track);
  }

  _label() {
    this.labels.replaceChildren(...this.rows.map((row) => (row.track ? this._trackLabel(row) : this._heading(row))));
    if (!this.rows.length) this.labels.append(make("p", { className: "nothing", textContent: "Nothing fits the filter." }));
  }

  _heading({ heading, height }) {
    const open = !this.closed.has(heading);
    const button = make("button", { type: "button", className: "heading", textContent: heading, "aria-expanded": String(open) });
    button.style.height = `${height}px`;
    button.addEventListener("click", () => {
      if (open) this.closed.add(heading);
      else this.closed.delete(heading);
      this.arrange();
    });
    return button;
  }

  _trackLabel(row) {
    const { track } = row;
    const value = make("span", { className: "now" });
    const name = make("span", { className: "name", textContent: track.name });
    const label = make("button", { type: "button", className: "label", title: `${track.path}: ${track.title}`, tabIndex: -1 }, name, value);
    label.style.height = `${row.height}px`;
    label.addEventListener("click", () => {
      this.select(track);
      this.stage.focus({ preventScroll: true });
    });
    row.value = value;
    row.label = label;
    return label;
  }

  // --- what the reader does -----------------------------------------------------------------

  select(track) {
    this.selected = track;
    const row = this.rows.find((item) => item.track === track);
    if (row) {
      const room = this.scroller.clientHeight - RULER_PX;
      const { scrollTop } = this.scroller;
      if (row.top < scrollTop) this.scroller.scrollTop = row.top;
      else if (row.top + row.height > scrollTop + room) this.scroller.scrollTop = row.top + row.height - room;
    }
    this.changed();
    this.tell();
  }

  /** Put a cursor somewhere; None takes it away. */
  setCursor(name, time) {
    this.cursors[name] = time === null ? null : clamp(time, this.trace.start, this.trace.end);
    if (time !== null) this.view.reveal(this.cursors[name]);
    this.changed();
    this.tell();
  }

  /** Say what is at the cursor, for those who do not see it. */
  tell() {
    if (this.selected !== null && this.cursors.A !== null) {
      this.live.textContent = spoken(this.selected, this.cursors.A, this.view);
    }
  }

  /** The row at a height of the stage. */
  rowAt(y) {
    return this.rows.find((row) => y >= row.top && y < row.top + row.height) ?? null;
  }

  /** Paper does not scroll: it gets all rows, in the colours that the page has then. */
  setOnPaper(onPaper) {
    this.onPaper = onPaper;
    this.resized();
    this.colours = coloursOf(this.host);
    this.draw();
  }

  recolour() {
    this.colours = coloursOf(this.host);
    this.changed();
  }

  // --- drawing ------------------------------------------------------------------------------

  resized() {
    const width = this.stage.clientWidth;
    if (width === 0) return;
    this.view.width = width;
    const limit = this.onPaper ? this.height + RULER_PX : Math.max(280, Math.round(innerHeight * 0.64));
    this.scroller.style.maxHeight = `${limit}px`;
    this.stage.style.height = `${this.height}px`;
    this.sight = Math.min(limit - RULER_PX, Math.max(this.height, 60));
    fit(this.canvas, width, this.sight);
    fit(this.ruler, width, RULER_PX);
    fit(this.overview, this.host.clientWidth, 34);
    this.changed();
  }

  /** Something is to be drawn anew, once for all that happens until the next picture. */
  changed() {
    if (this.due) return;
    this.due = true;
    requestAnimationFrame(() => {
      this.due = false;
      this.draw();
    });
  }

  draw() {
    const begin = performance.now();
    this._drawWaves();
    this._drawRuler();
    this._drawOverview();
    performance.clearMeasures("fbgen draw");
    performance.measure("fbgen draw", { start: begin, end: performance.now() });
    this._showValues();
    this.toolbar.update();
    this.events.update();
  }

  _drawWaves() {
    const { view, colours, scroller } = this;
    const context = this.canvas.getContext("2d");
    const offset = this.onPaper ? 0 : scroller.scrollTop;
    context.clearRect(0, 0, view.width, this.sight);
    this._shadeFaults(context, this.sight);
    this._grid(context, this.sight);
    const painter = new Painter(context, view, colours);
    for (const row of this.rows) {
      const top = row.top - offset;
      if (top > this.sight || top + row.height < 0) continue;
      if (row.heading) {
        context.fillStyle = colours.heading;
        context.fillRect(0, top, view.width, row.height);
        continue;
      }
      if (row.track === this.selected) {
        context.fillStyle = colours.selected;
        context.fillRect(0, top, view.width, row.height);
      }
      painter.track(row.track, top);
      context.fillStyle = colours.grid;
      context.fillRect(0, top + row.height - 1, view.width, 1);
    }
    this._cursorLines(context, 0, this.sight);
  }

  _shadeFaults(context, height) {
    for (const mark of this.trace.marks) {
      if (mark.kind !== "fault" || mark.end < this.view.begin || mark.start > this.view.end) continue;
      const from = Math.max(this.view.x(mark.start), -1);
      context.fillStyle = this.colours["fault-shade"];
      context.fillRect(from, 0, Math.max(1, Math.min(this.view.x(mark.end), this.view.width + 1) - from), height);
    }
  }

  _grid(context, height) {
    const { ticks } = ticksBetween(this.view.begin, this.view.end, this.view.resolution * 110);
    context.fillStyle = this.colours.grid;
    for (const tick of ticks) context.fillRect(Math.round(this.view.x(tick)), 0, 1, height);
  }

  _cursorLines(context, top, height) {
    const line = (time, colour, dashes) => {
      const x = Math.round(this.view.x(time)) + 0.5;
      if (x < 0 || x > this.view.width) return;
      context.strokeStyle = colour;
      context.lineWidth = 1;
      context.setLineDash(dashes);
      context.beginPath();
      context.moveTo(x, top);
      context.lineTo(x, height);
      context.stroke();
      context.setLineDash([]);
    };
    for (const mark of this.trace.failures()) line(mark.end, this.colours.red, [2, 2]);
    if (this.cursors.A !== null) line(this.cursors.A, this.colours["cursor-a"], []);
    if (this.cursors.B !== null) line(this.cursors.B, this.colours["cursor-b"], []);
  }

  _drawRuler() {
    const { view, colours } = this;
    const context = this.ruler.getContext("2d");
    context.clearRect(0, 0, view.width, RULER_PX);
    const { step, ticks } = ticksBetween(view.begin, view.end, view.resolution * 110);
    context.font = FONT;
    context.textBaseline = "alphabetic";
    context.fillStyle = colours.muted;
    for (const tick of ticks) {
      const x = Math.round(view.x(tick));
      context.fillRect(x, RULER_PX - 7, 1, 7);
      context.fillText(tickText(tick, step), x + 4, RULER_PX - 6);
    }
    for (let at = Math.ceil(view.begin / (step / 5)) * (step / 5); at <= view.end; at += step / 5) {
      context.fillRect(Math.round(view.x(at)), RULER_PX - 3, 1, 3);
    }
    this._cursorLines(context, 18, RULER_PX);
    for (const mark of this.trace.failures()) this._flag(context, mark.end, "failed", colours.red, ASIDE_PX);
    for (const name of ["B", "A"]) {
      if (this.cursors[name] !== null) {
        this._flag(context, this.cursors[name], name, colours[`cursor-${name.toLowerCase()}`], 0);
      }
    }
  }

  /** A text on the ruler over its instant, or so far left of it. */
  _flag(context, time, text, colour, aside) {
    const x = this.view.x(time);
    if (x < 0 || x > this.view.width) return;
    context.font = SMALL;
    const width = text.length * 6 + 8;
    const middle = clamp(x - width / 2, 0, this.view.width - width);
    const left = aside ? Math.max(0, Math.min(x, this.view.width - aside) - width - aside) : middle;
    context.fillStyle = colour;
    context.beginPath();
    context.roundRect(left, 3, width, 15, 3);
    context.fill();
    context.fillStyle = this.colours["on-strong"];
    context.textBaseline = "middle";
    context.fillText(text, left + 4, 11);
  }

  _drawOverview() {
    const { trace, view, colours } = this;
    const width = this.host.clientWidth;
    const context = this.overview.getContext("2d");
    context.clearRect(0, 0, width, 34);
    const x = (time) => ((time - trace.start) / (trace.end - trace.start)) * width;
    this.activity ??= activityOf(trace, 400);
    context.fillStyle = colours["signal-busy"];
    this.activity.forEach((share, column) => {
      const height = share * 24;
      context.fillRect((column / this.activity.length) * width, 30 - height, width / this.activity.length + 0.5, height);
    });
    for (const mark of trace.marks) {
      if (mark.kind !== "fault") continue;
      context.fillStyle = colours["fault-shade"];
      context.fillRect(x(mark.start), 0, Math.max(2, x(mark.end) - x(mark.start)), 34);
    }
    context.fillStyle = colours.red;
    for (const mark of trace.failures()) context.fillRect(clamp(x(mark.end) - 1, 0, width - 2), 0, 2, 34);
    const from = x(view.begin);
    const to = Math.max(x(view.end), from + 3);
    context.fillStyle = colours["outside"];
    context.fillRect(0, 0, from, 34);
    context.fillRect(to, 0, width - to, 34);
    context.strokeStyle = colours["cursor-a"];
    context.lineWidth = 1.5;
    context.strokeRect(clamp(from, 1, width) , 1, Math.max(2, Math.min(to, width - 1) - clamp(from, 1, width)), 32);
  }

  /** The values at cursor A beside the names, and all about the selected one beside the diagram. */
  _showValues() {
    const time = this.cursors.A;
    for (const row of this.rows) {
      if (!row.track) continue;
      row.label.setAttribute("aria-pressed", String(row.track === this.selected));
      if (row.track.drawn === "spans" || time === null) row.value.textContent = "";
      else {
        const index = row.track.indexAt(time);
        row.value.textContent = index < 0 ? "" : row.track.text(index, true);
      }
    }
    this.inspector.replaceChildren(...this._details(this.selected, time));
  }

  _details(track, time) {
    if (track === null || time === null) {
      return [make("p", { className: "about", textContent: "Click into the diagram, or choose a name: what is at the cursor stands here." })];
    }
    if (track.drawn === "spans") {
      const item = track.itemAt(time, 0, this.view.resolution * 3);
      if (item) return spanDetails(item, this.view);
      return [make("h4", { textContent: track.name }), make("p", { className: "about", textContent: `${track.title}; nothing at the cursor` })];
    }
    const index = track.indexAt(time);
    if (index < 0) return [make("h4", { textContent: track.path })];
    return channelDetails(track, index, time, this.view, this.trace);
  }
}

/** Give a canvas as many dots as the screen has in this place. */
function fit(canvas, width, height) {
  const ratio = devicePixelRatio || 1;
  canvas.style.width = `${width}px`;
  canvas.style.height = `${height}px`;
  canvas.width = Math.round(width * ratio);
  canvas.height = Math.round(height * ratio);
  canvas.getContext("2d").setTransform(ratio, 0, 0, ratio, 0, 0);
}

/** How much happens in each part of a run, from 0 to 1. */
function activityOf(trace, columns) {
  const counts = new Float64Array(columns);
  const scale = columns / (trace.end - trace.start);
  const count = (time) => {
    counts[clamp(Math.floor((time - trace.start) * scale), 0, columns - 1)] += 1;
  };
  for (const channel of trace.channels) {
    for (let index = 1; index < channel.times.length; index++) count(channel.times[index]);
  }
  for (const frame of trace.frames) count(frame.start);
  const most = Math.max(1, ...counts);
  return Array.from(counts, (number) => Math.sqrt(number / most));
}
