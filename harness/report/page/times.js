// Times of the plant, in nanoseconds: how they are written, and where an axis has its ticks.

const UNITS = [
  { name: "s", ns: 1e9 },
  { name: "ms", ns: 1e6 },
  { name: "us", ns: 1e3 },
  { name: "ns", ns: 1 },
];

/** The largest unit of which the time is at least one. */
function unitOf(ns) {
  return UNITS.find((unit) => Math.abs(ns) >= unit.ns) ?? UNITS[UNITS.length - 1];
}

/** A duration with up to four digits that count: `12.5 ms`. */
function durationText(ns) {
  if (ns === 0) return "0 s";
  const unit = unitOf(ns);
  const digits = unit.ns === 1 ? 0 : clamp(3 - Math.floor(Math.log10(Math.abs(ns) / unit.ns)), 0, 3);
  return `${Number((ns / unit.ns).toFixed(digits))} ${unit.name}`;
}

/** An instant, in the unit and with the digits that tell it from one `resolution` ns away. */
function instantText(ns, resolution) {
  const digits = clamp(Math.ceil(-Math.log10(Math.max(resolution, 1) / 1e9)), 3, 9);
  return `${(ns / 1e9).toFixed(digits)} s`;
}

/** The instants of an axis between two times: round ones, at least `room` ns apart. */
function ticksBetween(begin, end, room) {
  const power = 10 ** Math.floor(Math.log10(Math.max(room, 1)));
  const step = [1, 2, 5, 10].map((factor) => factor * power).find((size) => size >= room);
  const ticks = [];
  for (let at = Math.ceil(begin / step) * step; at <= end; at += step) ticks.push(at);
  return { step, ticks };
}

/** The text of a tick, with only the digits that its step needs. */
function tickText(ns, step) {
  const digits = clamp(Math.ceil(-Math.log10(step / 1e9)), 0, 9);
  return `${(ns / 1e9).toFixed(digits)} s`;
}
