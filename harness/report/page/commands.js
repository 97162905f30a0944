// What can be done with the diagram, once: each command with its key and its button.

const COMMANDS = [
  { keys: ["0", "Home"], sign: "Fit", text: "show the whole run", run: (d) => d.view.show(d.view.min, d.view.max) },
  { keys: ["+", "="], sign: "+", text: "zoom in at cursor A", run: (d) => d.view.zoom(0.5, middleOf(d)) },
  { keys: ["-"], sign: "\u2212", text: "zoom out", run: (d) => d.view.zoom(2, middleOf(d)) },
  { keys: ["Shift+ArrowLeft"], text: "go back in time", run: (d) => d.view.pan(-0.25) },
  { keys: ["Shift+ArrowRight"], text: "go on in time", run: (d) => d.view.pan(0.25) },
  { keys: ["ArrowLeft"], sign: "\u2039", text: "cursor to the change before", run: (d) => toChange(d, -1) },
  { keys: ["ArrowRight"], sign: "\u203a", text: "cursor to the next change", run: (d) => toChange(d, 1) },
  { keys: ["ArrowUp"], text: "the channel above", run: (d) => toTrack(d, -1) },
  { keys: ["ArrowDown"], text: "the channel below", run: (d) => toTrack(d, 1) },
  { keys: ["p"], sign: "\u2039 mark", text: "step, check or fault before", run: (d) => toMark(d, -1, d.trace.marks) },
  { keys: ["n"], sign: "mark \u203a", text: "next step, check or fault", run: (d) => toMark(d, 1, d.trace.marks) },
  { keys: ["f"], sign: "failure", text: "next failure", run: (d) => toMark(d, 1, d.trace.failures(), true) },
  { keys: ["b"], sign: "B", text: "put cursor B where A is, or take it away", run: toggleB },
  { keys: ["x"], text: "exchange the cursors", run: exchange },
];

function middleOf({ view, cursors }) {
  const { A } = cursors;
  return A !== null && A >= view.begin && A <= view.end ? A : (view.begin + view.end) / 2;
}

function toChange(diagram, direction) {
  const track = diagram.selected ?? diagram.shown[0];
  if (!track) return;
  diagram.selected = track;
  const now = diagram.cursors.A ?? diagram.view.begin;
  const { times } = track;
  const last = lastNotAfter(times, now);
  const index = direction > 0 ? last + 1 : times[last] === now ? last - 1 : last;
  if (index >= 0 && index < times.length) diagram.setCursor("A", times[index]);
}

function toTrack(diagram, direction) {
  const tracks = diagram.shown;
  if (!tracks.length) return;
  const index = tracks.indexOf(diagram.selected);
  diagram.select(tracks[index < 0 ? 0 : clamp(index + direction, 0, tracks.length - 1)]);
}

/** To where the next of some marks begins, or failures were found; round and round with those. */
function toMark(diagram, direction, marks, round = false) {
  const times = [...new Set(marks.map((mark) => (round ? mark.end : mark.start)))].sort((a, b) => a - b);
  const now = diagram.cursors.A ?? diagram.view.begin;
  const found = direction > 0 ? times.find((time) => time > now) : times.findLast((time) => time < now);
  const time = found ?? (round ? times[0] : undefined);
  if (time === undefined) return;
  diagram.setCursor("A", time);
  const mark = marks.find((item) => (round ? item.end : item.start) === time);
  diagram.live.textContent = `${mark.kind}: ${mark.title} ${mark.verdict ?? ""}`;
}

function toggleB(diagram) {
  diagram.setCursor("B", diagram.cursors.B === null ? diagram.cursors.A : null);
}

function exchange(diagram) {
  const { A, B } = diagram.cursors;
  if (B === null) return;
  diagram.cursors.B = A;
  diagram.setCursor("A", B);
}

function followKeys(diagram) {
  diagram.stage.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key === "?") {
      diagram.toolbar.help();
      return;
    }
    const key = event.shiftKey && event.key.startsWith("Arrow") ? `Shift+${event.key}` : event.key;
    const command = COMMANDS.find(({ keys }) => keys.includes(key));
    if (command === undefined) return;
    event.preventDefault();
    command.run(diagram);
    diagram.changed();
  });
}

/** Buttons, filter, and what the cursors say. */
function buildToolbar(diagram) {
  const buttons = COMMANDS.filter(({ sign }) => sign).map((command) => {
    const title = `${command.text} (${command.keys.join(", ")})`;
    const button = make("button", { type: "button", textContent: command.sign, title, "aria-label": command.text });
    button.addEventListener("click", () => {
      command.run(diagram);
      diagram.changed();
    });
    if (command.sign === "failure") button.hidden = diagram.trace.failures().length === 0;
    return button;
  });
  const filter = make("input", { type: "search", placeholder: "filter channels", "aria-label": "filter channels" });
  filter.addEventListener("input", () => {
    diagram.filter = filter.value;
    diagram.arrange();
  });
  const level = make(
    "select",
    { "aria-label": "which channels" },
    make("option", { textContent: "essential", value: ALWAYS }),
    make("option", { textContent: "all that change", value: CHANGING }),
    make("option", { textContent: "all", value: EVERYTHING }),
  );
  level.addEventListener("change", () => {
    diagram.level = Number(level.value);
    diagram.arrange();
  });
  const readout = make("output", { className: "readout" });
  const help = make("button", { type: "button", textContent: "?", title: "keys (?)", "aria-label": "keys" });
  const keys = keyList();
  help.addEventListener("click", () => keys.showModal());
  const element = make("div", { className: "toolbar", role: "toolbar", "aria-label": "diagram" },
    make("span", { className: "group" }, ...buttons), level, filter, readout, help, keys);
  return {
    element,
    help: () => keys.showModal(),
    update() {
      const { A, B } = diagram.cursors;
      const resolution = diagram.view.resolution;
      const parts = [];
      if (A !== null) parts.push(`A ${instantText(A, resolution)}`);
      if (B !== null) parts.push(`B ${instantText(B, resolution)}`, `B\u2212A ${durationText(B - (A ?? 0))}`);
      parts.push(`${durationText(diagram.view.span)} in sight`);
      readout.textContent = parts.join("   ");
    },
  };
}

/** What the colours of spans say. */
const LEGEND = [
  ["blue", "telegram, request of the gateway"],
  ["green", "reply of a drive; step or check that held"],
  ["violet", "heartbeat of the gateway, and the answer to it"],
  ["orange", "refusal, telegram without a reply, fault"],
  ["red", "damaged or collided frame; what failed"],
];

/** All keys and what the mouse does, as a dialog. */
function keyList() {
  const rows = [
    ...COMMANDS.map(({ keys, text }) => [keys.join(", "), text]),
    ["wheel, pinch", "zoom at the pointer"],
    ["Shift + wheel, drag", "go back and on in time"],
    ["Alt + wheel", "scroll the channels"],
    ["Shift + drag", "zoom to a range"],
    ["click", "cursor A, at a change if one is near"],
    ["Shift + click", "cursor B"],
    ["double click", "zoom to a value"],
  ].map(([key, text]) => make("tr", {}, make("th", { textContent: key }), make("td", { textContent: text })));
  for (const [tone, text] of LEGEND) {
    const sample = make("span", { className: `sample ${tone}`, "aria-label": tone });
    rows.push(make("tr", {}, make("th", {}, sample), make("td", { textContent: text })));
  }
  const close = make("button", { textContent: "Close" });
  return make("dialog", { className: "keys", "aria-label": "keys" },
    make("table", {}, make("tbody", {}, ...rows)), make("form", { method: "dialog" }, close));
}
