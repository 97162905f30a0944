// What the diagram shows, each thing on a track of its own: a channel with its steps, or spans.

const ALWAYS = 0;
const CHANGING = 1;
const EVERYTHING = 2;

/** Heights in pixels, by what is drawn. */
const HEIGHTS = { bool: 24, bus: 26, analog: 66, lane: 24 };

/** What of the devices is worth a look first. Of the PLC: how far blocks are. */
const ESSENTIAL =
  /^(cpu\.mode|bus\.mode|gateway\..+\.(control|status|trigger|online)|devicenet\..+\.(mode|exchanging|scanner|state|(output|input)\..+|connection\..+)|drive\..+\.(frequency|set_point|running|tripped|trip|word\..+)|plc\..+\.(busy|done|error|status|step|state|execute|online|ready|running|trip|alarms?|valid|atSetPoint|run|reverse|reset|enable))$/i;

/** A channel: it has one value at any time, from one change to the next. */
class ChannelTrack {
  constructor(channel, end) {
    Object.assign(this, channel);
    this.id = channel.path;
    this.end = end;
    [this.heading, this.name] = namesOf(channel);
    this.drawn = channel.kind === "bool" ? "bool" : channel.kind === "real" ? "analog" : "bus";
    this.height = HEIGHTS[this.drawn];
    const changes = channel.times.length > 1;
    const wanted = ESSENTIAL.test(channel.path) && (changes || /^(cpu|bus)\./.test(channel.path));
    this.level = wanted ? ALWAYS : changes ? CHANGING : EVERYTHING;
    this.scale = null;
  }

  indexAt(time) {
    return lastNotAfter(this.times, time);
  }

  startOf(index) {
    return this.times[index];
  }

  endOf(index) {
    return index + 1 < this.times.length ? this.times[index + 1] : this.end;
  }

  get count() {
    return this.times.length;
  }

  /** The value as people write it; `short` where there is little room. */
  text(index, short = false) {
    const value = this.values[index];
    if (this.kind === "bool") return value ? "TRUE" : "FALSE";
    if (this.kind === "word") return short ? hex(value, this.word) : `16#${hex(value, this.word)}`;
    if (this.kind === "text") return short ? value : `"${value}"`;
    const shown = typeof value === "number" ? String(Number(value.toPrecision(9))) : value;
    return this.unit ? `${shown} ${this.unit}` : shown;
  }

  meaning(index) {
    return this.word === null ? "" : this.word.describe(this.values[index]);
  }

  place(index, places) {
    const number = this.writers === null ? -1 : this.writers[index];
    return number < 0 ? null : places[number];
  }

  /** Nothing is there: 0, an empty text. */
  idle(index) {
    const value = this.values[index];
    return value === 0 || value === "" || value === "0";
  }
}

/** Spans of one kind, in as many lanes as it takes so that none lies over another. */
class SpanTrack {
  constructor(id, name, title, heading, items) {
    Object.assign(this, { id, name, title, heading, items });
    this.path = id;
    this.drawn = "spans";
    this.level = items.length ? ALWAYS : EVERYTHING;
    this.lanes = inLanes(items);
    this.height = HEIGHTS.lane * Math.max(1, this.lanes.length);
  }

  /** The item at a time and a height below the upper edge. */
  itemAt(time, y, slack) {
    const lane = this.lanes[clamp(Math.floor(y / HEIGHTS.lane), 0, this.lanes.length - 1)];
    if (lane === undefined) return null;
    const index = lastNotAfter(lane.starts, time + slack);
    for (const candidate of [index, index - 1]) {
      const item = lane.items[candidate];
      if (item && time >= item.start - slack && time <= item.end + slack) return item;
    }
    return null;
  }

  /** The number of items, and where they begin: what next and previous go through. */
  get times() {
    return (this._times ??= Float64Array.from(this.items, (item) => item.start));
  }
}

function inLanes(items) {
  const lanes = [];
  for (const item of items) {
    let lane = lanes.find((known) => known.free <= item.start);
    if (lane === undefined) {
      lane = { free: 0, items: [] };
      lanes.push(lane);
    }
    lane.items.push(item);
    lane.free = Math.max(item.end, item.start + 1);
  }
  for (const lane of lanes) {
    lane.starts = Float64Array.from(lane.items, (item) => item.start);
    lane.ends = Float64Array.from(lane.items, (item) => item.end);
  }
  return lanes;
}

function hex(value, word) {
  const bits = word === null ? 16 : Math.max(...word.fields.map((field) => field.high)) + 1;
  return BigInt(value).toString(16).toUpperCase().padStart(Math.ceil(bits / 4), "0");
}

/** Heading and name of a channel; the variables of one structure of the PLC stand together. */
function namesOf({ path, group, owner }) {
  if (group === "cpu" || group === "bus") return ["CPU and PROFIBUS", path];
  if (group === "plc") {
    const [front, cut] = [`plc.${owner}.`, path.lastIndexOf(".")];
    return [`PLC ${path.slice(front.length, cut) || owner}`, path.slice(cut + 1)];
  }
  const named = group === "devicenet" ? "DeviceNet" : group[0].toUpperCase() + group.slice(1);
  const [heading, front] = [`${named} ${owner}`, `${group}.${owner}.`];
  return [heading, path.startsWith(front) ? path.slice(front.length) : path];
}

/** All tracks of a trace in the order in which people look at a plant, under their headings. */
function tracksOf(trace) {
  const marks = (kind, name, title) =>
    new SpanTrack(kind, name, title, "Scenario", spansOf(trace, kind));
  const tracks = [
    marks("step", "steps", "what the scenario does"),
    marks("check", "checks", "what the scenario demands"),
    marks("fault", "faults", "what is broken"),
  ];
  const channels = trace.channels.map((channel) => new ChannelTrack(channel, trace.end));
  shareScales(channels);
  const of = (group) => channels.filter((channel) => channel.group === group);
  tracks.push(...of("cpu"), ...of("bus"));
  for (const gateway of owners(of("gateway"))) {
    tracks.push(telegramTrack(trace, gateway), ...of("gateway").filter((c) => c.owner === gateway));
    tracks.push(...lineTracks(trace, gateway, "gateway"));
  }
  for (const line of owners(of("line"))) {
    tracks.push(...of("line").filter((c) => c.owner === line), ...lineTracks(trace, line, "module"));
  }
  for (const owner of owners(of("devicenet"))) {
    tracks.push(...of("devicenet").filter((c) => c.owner === owner));
    if (trace.frames.some((frame) => frame.line === owner)) tracks.push(...lineTracks(trace, owner, "scanner"));
  }
  tracks.push(...inOrder(of("drive")), ...underHeadings(of("plc")));
  return tracks;
}

function spansOf(trace, kind) {
  return trace.marks.filter((mark) => mark.kind === kind).map((mark) => ({ ...mark, type: "mark" }));
}

function owners(channels) {
  return [...new Set(channels.map((channel) => channel.owner))];
}

function telegramTrack(trace, gateway) {
  const items = trace.telegrams
    .filter((telegram) => telegram.gateway === gateway)
    .map((telegram) => ({ ...telegram, type: "telegram", end: telegram.end ?? telegram.start + 1e6 }));
  const heading = `Gateway ${gateway}`;
  return new SpanTrack(`telegrams.${gateway}`, "telegrams", "telegrams with their replies", heading, items);
}

/** What goes each way on a line or a network; `master` is what asks there. */
function lineTracks(trace, line, master) {
  const heading = { gateway: `Line of ${line}`, module: `Line ${line}`, scanner: `DeviceNet ${line}` }[master];
  const frames = trace.frames.filter((frame) => frame.line === line);
  const side = (toDrives, id, name, title) => {
    const items = frames
      .filter((frame) => frame.toDrives === toDrives)
      .map((frame) => ({ ...frame, type: "frame" }));
    return new SpanTrack(`line.${line}.${id}`, name, title, heading, items);
  };
  return [
    side(true, "to_drives", "to drives", `frames from the ${master} to the drives`),
    side(false, "from_drives", "from drives", `frames from the drives to the ${master}`),
  ];
}

/** Drives with their frequency and set-point first. */
function inOrder(channels) {
  const rank = ({ path }) => {
    const found = [".frequency", ".set_point", ".running", ".word."].findIndex((end) => path.includes(end));
    return found < 0 ? 9 : found;
  };
  return owners(channels).flatMap((owner) =>
    channels
      .filter((channel) => channel.owner === owner)
      .sort((one, other) => rank(one) - rank(other)),
  );
}

/** Those with one heading behind each other, headings in the order of their first. */
function underHeadings(tracks) {
  const found = new Map();
  for (const track of tracks) {
    if (!found.has(track.heading)) found.set(track.heading, []);
    found.get(track.heading).push(track);
  }
  return [...found.values()].flat();
}

/** Values of one owner in one unit have one scale, so that they can be compared. */
function shareScales(channels) {
  const scales = new Map();
  for (const channel of channels) {
    if (channel.drawn !== "analog") continue;
    const key = channel.unit ? `${channel.owner} ${channel.unit}` : channel.path;
    const scale = scales.get(key) ?? { low: 0, high: 0, whole: true };
    for (const value of channel.values) {
      if (!Number.isFinite(value)) {
        scale.whole = false;
        continue;
      }
      scale.low = Math.min(scale.low, value);
      scale.high = Math.max(scale.high, value);
    }
    scales.set(key, scale);
    channel.scale = scale;
  }
}
