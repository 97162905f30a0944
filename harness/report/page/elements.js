// Small tools for everything that follows: elements of the page, sorted times, colours.

/** An element with properties, attributes (`aria-...`, `data-...`, `role`) and children. */
function make(tag, properties = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(properties)) {
    if (name in element && !name.includes("-")) element[name] = value;
    else element.setAttribute(name, value);
  }
  element.append(...children.filter((child) => child !== null));
  return element;
}

/** The number of the last of the ascending times that is not after `time`; -1 if there is none. */
function lastNotAfter(times, time) {
  let low = 0;
  let high = times.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (times[middle] <= time) low = middle + 1;
    else high = middle;
  }
  return low - 1;
}

function clamp(value, low, high) {
  return Math.max(low, Math.min(high, value));
}

/** The colours of the page as the style sheets give them now; they differ by day and night. */
function coloursOf(host) {
  const probe = make("span", { hidden: true });
  host.append(probe);
  const found = {};
  for (const name of COLOURS) {
    probe.style.color = `var(--${name})`;
    found[name] = getComputedStyle(probe).color;
  }
  probe.remove();
  return found;
}

const TONES = ["blue", "green", "violet", "orange", "red", "grey", "signal"];
const COLOURS = [
  ...["panel", "ink", "muted", "line", "grid", "heading", "selected", "outside", "on-strong"],
  ...["signal-low", "signal-faint", "fault-shade", "cursor-a", "cursor-b"],
  ...TONES.flatMap((tone) => [tone, `${tone}-fill`, `${tone}-busy`]),
];
