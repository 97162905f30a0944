// What is in sight as a table: for screen readers, for searching, for copying.

const MOST_ROWS = 500;

class EventTable {
  constructor(diagram) {
    this.diagram = diagram;
    this.body = make("tbody");
    this.count = make("span", { className: "about" });
    this.copied = make("button", { type: "button", textContent: "Copy" });
    this.copied.addEventListener("click", () => this._copy());
    const head = ["time", "channel", "value", "meaning", "written by"].map((name) => make("th", { scope: "col", textContent: name }));
    const table = make("table", { className: "events" }, make("thead", {}, make("tr", {}, ...head)), this.body);
    this.element = make("details", { className: "event-list" },
      make("summary", { textContent: "Events in sight as a table" }),
      make("p", {}, this.copied, " ", this.count), make("div", { className: "wide", tabIndex: 0 }, table));
    this.element.addEventListener("toggle", () => this.update());
  }

  /** Soon, once, and only while it is open. */
  update() {
    clearTimeout(this.later);
    if (this.element.open) this.later = setTimeout(() => this._fill(), 120);
  }

  _fill() {
    const rows = this._rows();
    this.count.textContent = rows.length > MOST_ROWS ? `the first ${MOST_ROWS} of ${rows.length} events: zoom in for the others` : `${rows.length} events`;
    this.body.replaceChildren(...rows.slice(0, MOST_ROWS).map((row) => {
      const cells = this._cells(row).map((text) => make("td", { textContent: text }));
      const line = make("tr", {}, ...cells);
      line.addEventListener("click", () => {
        this.diagram.selected = row.track;
        this.diagram.setCursor("A", row.time);
      });
      return line;
    }));
  }

  /** What begins in sight on the tracks that are shown, in the order of its time. */
  _rows() {
    const { view, shown } = this.diagram;
    const rows = [];
    for (const track of shown) {
      const { times } = track;
      for (let index = lastNotAfter(times, view.begin - 1) + 1; index < times.length && times[index] <= view.end; index++) {
        rows.push({ time: times[index], track, index });
      }
    }
    return rows.sort((one, other) => one.time - other.time);
  }

  _cells({ time, track, index }) {
    const at = instantText(time, 1000);
    if (track.drawn === "spans") {
      const item = track.items[index];
      const text = item.title ?? item.meaning;
      const bytes = item.bytes ?? item.output ?? item.verdict ?? "";
      return [at, `${track.heading}: ${track.name}`, bytes, text, whereText(item.place ?? null)];
    }
    return [at, track.path, track.text(index), track.meaning(index), whereText(track.place(index, this.diagram.trace.places))];
  }

  async _copy() {
    const lines = this._rows().map((row) => this._cells(row).join("\t"));
    const text = ["time\tchannel\tvalue\tmeaning\twritten by", ...lines].join("\n");
    try {
      await navigator.clipboard.writeText(text);
      this.copied.textContent = "Copied";
    } catch {
      this.copied.textContent = "The browser does not allow it: mark the table and copy";
    }
  }
}

function whereText(place) {
  if (place === null) return "";
  return `${place.file}:${place.line}${place.instance ? ` in ${place.instance}` : ""}: ${place.text}`;
}
