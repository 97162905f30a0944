// What is at a place of the diagram, in words: for the pointer, the cursor, and screen readers.

/** A list of names and what they are; what is empty is left out. */
function facts(pairs) {
  const rows = pairs
    .filter(([, value]) => value !== null && value !== "" && value !== undefined)
    .map(([name, value]) => make("div", {}, make("dt", { textContent: name }), make("dd", {}, value)));
  return make("dl", { className: "facts" }, ...rows);
}

/** Everything about the value of a channel from one change on. */
function channelDetails(track, index, time, view, trace) {
  const start = track.startOf(index);
  const end = track.endOf(index);
  const parts = [
    make("h4", { textContent: track.path }),
    make("p", { className: "about", textContent: track.title }),
    make("p", { className: "value", textContent: track.text(index) }),
  ];
  if (track.word !== null) parts.push(fieldTable(track, index));
  const before = index > 0 ? track.text(index - 1) : null;
  parts.push(
    facts([
      ["at", instantText(time, view.resolution)],
      ["since", instantText(start, 1000)],
      ["for", end >= trace.end ? `${durationText(end - start)}, to the end` : durationText(end - start)],
      ["before", before],
      ...placeFacts(track.place(index, trace.places), "written by"),
    ]),
  );
  return parts;
}

/** The fields of a word; those that differ from the value before are marked. */
function fieldTable(track, index) {
  const before = index > 0 ? track.values[index - 1] : null;
  const rows = track.word.decode(track.values[index], before).map(({ field, value, meaning, changed }) => {
    const bits = field.low === field.high ? `${field.low}` : `${field.high}..${field.low}`;
    const classes = [value ? "set" : "", changed ? "changed" : ""].join(" ").trim();
    return make(
      "tr",
      { className: classes },
      make("td", { textContent: bits }),
      make("td", { textContent: String(value) }),
      make("td", { textContent: field.name, title: field.title }),
      make("td", { textContent: meaning || (changed ? "changed" : "") }),
    );
  });
  return make("table", { className: "fields" }, make("tbody", {}, ...rows));
}

function placeFacts(place, label) {
  if (place === null) return [];
  const where = `${place.file}:${place.line}${place.instance ? ` in ${place.instance}` : ""}`;
  return [
    [label, where],
    ["", make("code", { textContent: place.text })],
  ];
}

/** Everything about a span: a mark of the scenario, a telegram, a frame. */
function spanDetails(item, view) {
  const resolution = Math.min(view.resolution, 1000);
  const times = [
    ["from", instantText(item.start, resolution)],
    ["to", item.open ? "still there at the end" : instantText(item.end, resolution)],
    ["for", durationText(item.end - item.start)],
  ];
  if (item.type === "mark") {
    const verdict = item.verdict ? `: ${item.verdict}` : "";
    return [
      make("h4", { textContent: `${item.kind}${verdict}` }),
      make("p", { className: "value", textContent: item.title }),
      facts([["on", item.target], ...times, ...placeFacts(item.place, "scenario")]),
    ];
  }
  if (item.type === "telegram") {
    return [
      make("h4", { textContent: `telegram of ${item.gateway}` }),
      make("p", { className: "value", textContent: item.meaning }),
      facts([
        ["sent", item.output],
        ["received", item.input ?? "no reply"],
        ...times,
        ...placeFacts(item.place, "written by"),
      ]),
    ];
  }
  const trouble = [item.damaged ? "damaged" : "", item.collided ? "collided" : ""].filter(Boolean);
  return [
    make("h4", { textContent: `${item.kind} from ${item.sender ?? "outside"}` }),
    make("p", { className: "value", textContent: item.meaning || "no frame of the protocol" }),
    facts([
      ["identifier", item.identifier === null ? null : item.identifier.toString(16).toUpperCase().padStart(3, "0")],
      ["bytes", item.bytes || "none"],
      ["heard as", item.heard],
      ["trouble", trouble.join(", ")],
      ...times,
    ]),
  ];
}

/** One line of text for what is at a time on a track. */
function spoken(track, time, view) {
  const at = instantText(time, view.resolution);
  if (track.drawn === "spans") {
    const item = track.itemAt(time, 0, view.resolution * 3);
    return `${track.name} at ${at}: ${item ? item.title ?? item.meaning : "nothing"}`;
  }
  const index = track.indexAt(time);
  if (index < 0) return `${track.path} at ${at}: not yet recorded`;
  const meaning = track.meaning(index);
  return `${track.path} at ${at}: ${track.text(index)}${meaning ? `, ${meaning}` : ""}`;
}
