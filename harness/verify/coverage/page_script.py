"""What the page with the annotated source does: the list of blocks, one block, moving about.

All text gets in as text, never as HTML. The address behind `#` says which block and line is shown,
so that places can be linked to.
"""

SCRIPT = """
"use strict";
const data = JSON.parse(document.getElementById("data").textContent);
const kinds = [["statement", "statements"], ["branch", "branches"], ["mcdc", "MC/DC"]];
const make = (tag, cls, text) => {
  const one = document.createElement(tag);
  if (cls) one.className = cls;
  if (text !== undefined) one.textContent = text;
  return one;
};
const percent = ([reached, total]) => total ? 100 * reached / total : 100;
const shown = count => count[1] ? Math.floor(percent(count)) + " %" : "-";
const main = document.querySelector("main");
let order = { key: "name", up: true };

function bar(count) {
  const outer = make("div", "bar"), inner = make("i");
  const value = percent(count);
  inner.style.width = value + "%";
  inner.className = value >= 90 ? "" : value >= 60 ? "middle" : "low";
  outer.append(inner);
  return outer;
}

function cards(totals, catalogue) {
  const all = make("div", "cards");
  const names = kinds.map(([key, name]) => [name, totals[key]]);
  if (catalogue) names.push(["catalogue", catalogue.total]);
  for (const [name, count] of names) {
    const card = make("div", "card");
    card.append(make("b", "", shown(count)),
      make("span", "", `${name}: ${count[0]} of ${count[1]}`));
    card.append(bar(count));
    all.append(card);
  }
  return all;
}

function overview() {
  main.replaceChildren(cards(data.totals, data.catalogue));
  const tools = make("div", "tools"), filter = make("input"), only = make("input");
  filter.type = "search"; filter.placeholder = "block, dialect or plant"; filter.id = "filter";
  only.type = "checkbox"; only.id = "only";
  const label = make("label", "", " with something missing"); label.prepend(only);
  const title = make("label", "", "show "); title.append(filter);
  tools.append(title, label);
  main.append(tools);
  const scroll = make("div", "scroll"), table = make("table");
  scroll.append(table); main.append(scroll);
  const draw = () => rows(table, filter.value.toLowerCase(), only.checked);
  filter.oninput = draw; only.onchange = draw;
  draw();
  if (data.catalogue) catalogue(data.catalogue);
}

function rows(table, words, only) {
  const head = make("tr"), body = make("tbody"), top = make("thead");
  const columns = [["name", "block"], ["dialects", "dialects"], ...kinds, ["plants", "plants"]];
  for (const [key, name] of columns) {
    const cell = make("th"), press = make("button", "", name);
    if (order.key === key) {
      cell.ariaSort = order.up ? "ascending" : "descending";
      press.append(order.up ? " \\u25b2" : " \\u25bc");
    }
    press.onclick = () => { order = { key, up: order.key === key ? !order.up : true };
      rows(table, words, only); };
    cell.append(press); head.append(cell);
  }
  const value = block => Array.isArray(block[order.key]) && order.key !== "plants"
    ? percent(block[order.key]) : String(block[order.key]).toLowerCase();
  const sorted = data.blocks.map((block, index) => ({ block, index }));
  sorted.sort((a, b) => (value(a.block) < value(b.block) ? -1 : value(a.block) > value(b.block) ? 1
    : a.index - b.index) * (order.up ? 1 : -1));
  for (const { block } of sorted) {
    const text = [block.name, block.dialects, ...block.plants].join(" ").toLowerCase();
    if (!text.includes(words)) continue;
    if (only && kinds.every(([key]) => percent(block[key]) === 100)) continue;
    const row = make("tr"), name = make("td"), link = make("a", "", block.name);
    link.href = "#" + block.texts[0];
    name.append(link);
    if (block.texts.length > 1) name.append(make("span", "soft", ` ${block.texts.length} texts`));
    row.append(name, make("td", "", block.dialects));
    for (const [key] of kinds) {
      const cell = make("td", "n", `${shown(block[key])}`);
      cell.title = `${block[key][0]} of ${block[key][1]}`;
      if (block[key][1]) cell.append(bar(block[key]));
      row.append(cell);
    }
    row.append(make("td", "soft", block.plants.join(", ") || data.texts[block.texts[0]].file));
    body.append(row);
  }
  top.append(head);
  table.replaceChildren(top, body);
}

function catalogue(all) {
  for (const group of all.groups) {
    main.append(make("h2", "", `${group.name}: ${shown(group.exercised)} ` +
      `(${group.exercised[0]} of ${group.exercised[1]})`));
    main.append(bar(group.exercised));
    if (!group.missing.length) continue;
    const more = make("details"), list = make("ul", "missing");
    more.append(make("summary", "soft", `${group.missing.length} that no test has exercised`));
    for (const one of group.missing) list.append(make("li", "", one));
    more.append(list); main.append(more);
  }
}

function states(block) {
  const lines = new Map();
  const at = number => lines.get(number) ||
    lines.set(number, { hits: null, state: "", notes: [], decisions: [] }).get(number);
  for (const [first, last, hits, reached] of block.statements) {
    for (let number = first; number <= last; number++) {
      const line = at(number);
      if (number === first) line.hits = Math.max(line.hits ?? 0, hits);
      const state = hits ? "yes" : reached ? "other" : "no";
      const both = [line.state || state, state];
      line.state = both[0] === both[1] ? state : both.includes("no") ? "part" : "yes";
    }
  }
  for (const [number, kind, what] of block.missing) {
    const line = at(number);
    if (kind !== "statement") {
      if (line.state !== "no") line.state = "part";
      if (kind === "branch") line.notes.push(what);
    }
  }
  for (const decision of block.decisions) at(decision.line).decisions.push(decision);
  return lines;
}

function one(index, target) {
  const block = data.texts[index];
  const whole = data.blocks.find(one => one.texts.includes(index));
  const back = make("p"), home = make("a", "", "\\u2190 all blocks");
  home.href = "#"; back.append(home);
  const title = make("h2", "", `${block.name} `);
  title.append(make("span", "soft", `${block.kind}, ${block.dialect}, ${block.file}` +
    (block.plants.length ? `, generated for ${block.plants.join(", ")}` : "")));
  const help = make("p", "soft");
  help.append(make("kbd", "", "n"), " and ", make("kbd", "", "p"),
    " go to the next and previous place that is missing, ", make("kbd", "", "u"), " goes up.");
  main.replaceChildren(back, title, cards(whole));
  if (whole.texts.length > 1) main.append(texts(whole, index));
  main.append(help);
  const lines = states(block), source = make("div", "source");
  block.text.forEach((text, offset) => {
    const number = block.first + offset, known = lines.get(number);
    const row = make("div", `line ${known ? known.state : ""}`);
    row.id = `line-${number}`;
    row.append(make("span", "number", number));
    row.append(make("span", "hits", known && known.hits !== null ? times(known.hits) : ""));
    if (known && known.state === "other") row.title = "has run in another text of the block";
    row.append(make("span", "code", text || " "));
    source.append(row);
    if (!known) return;
    for (const note of known.notes) source.append(make("div", "note", note));
    for (const decision of known.decisions) decide(source, decision);
  });
  main.append(source);
  const wanted = target && document.getElementById(`line-${target}`);
  if (wanted) { wanted.classList.add("here"); wanted.scrollIntoView({ block: "center" }); }
  else window.scrollTo(0, 0);
}

function texts(whole, index) {
  const box = make("p", "texts soft");
  box.append(`All ${whole.texts.length} texts of the block count together; what has run in ` +
    "another one is marked so. ");
  for (const number of whole.texts) {
    const { dialect, plants, file } = data.texts[number];
    const name = `${plants.join(", ") || file} ${dialect}`;
    const link = make(number === index ? "b" : "a", "", name);
    if (number !== index) link.href = "#" + number;
    box.append(link, " ");
  }
  return box;
}

const times = hits => hits < 1e6 ? String(hits) : (hits / 1e6).toFixed(1) + " M";

function decide(source, decision) {
  const good = decision.conditions.filter(one => one.shown).length;
  const total = decision.conditions.filter(one => !one.excluded).length;
  const note = make("div", good < total ? "note" : "note soft");
  const press = make("button", "", `MC/DC ${good}/${total}`);
  press.ariaExpanded = "false";
  note.append(press); source.append(note);
  press.onclick = () => {
    const open = press.ariaExpanded === "true";
    press.ariaExpanded = String(!open);
    if (open) note.nextSibling.remove(); else note.after(vectors(decision));
  };
}

function vectors(decision) {
  const box = make("div", "decision"), list = make("table"), seen = make("table");
  const letter = number => number < 26 ? String.fromCharCode(65 + number) : "C" + (number + 1);
  decision.conditions.forEach((one, number) => {
    const row = make("tr"), text = make("td");
    text.append(make("code", "", one.text));
    const state = one.excluded ? "excluded: " + one.excluded
      : one.shown ? `shown by ${one.shown[0]} and ${one.shown[1]}` +
        (one.shown[2] ? "" : " (masking)")
      : one.wanted;
    row.append(make("th", "", letter(number)), text,
      make("td", one.excluded ? "soft" : one.shown ? "ok" : "bad", state));
    list.append(row);
  });
  const head = make("tr");
  head.append(make("th", "", "#"));
  decision.conditions.forEach((_, number) => head.append(make("th", "", letter(number))));
  head.append(make("th", "", "result"));
  seen.append(head);
  decision.vectors.forEach(([values, result], number) => {
    const row = make("tr");
    row.append(make("td", "soft", number + 1));
    for (const value of values) row.append(make("td", value === "-" ? "soft" : "", value));
    row.append(make("td", "", result));
    seen.append(row);
  });
  box.append(list);
  if (decision.vectors.length) box.append(make("p", "soft", "seen:"), seen);
  else box.append(make("p", "bad", "never made"));
  return box;
}

function show() {
  const [index, line] = location.hash.slice(1).split(":");
  if (index !== "" && data.texts[index]) one(Number(index), line); else overview();
}

let place = -1;
addEventListener("keydown", event => {
  if (event.target.matches("input") || event.ctrlKey || event.metaKey || event.altKey) return;
  const places = [...document.querySelectorAll(".line.no, .line.part")];
  const index = location.hash.slice(1).split(":")[0];
  if (event.key === "u" && index !== "") location.hash = "";
  else if ((event.key === "n" || event.key === "p") && places.length) {
    place = (place + (event.key === "n" ? 1 : -1) + places.length) % places.length;
    document.querySelectorAll(".here").forEach(one => one.classList.remove("here"));
    places[place].classList.add("here");
    places[place].scrollIntoView({ block: "center" });
    history.replaceState(null, "", `#${index}:${places[place].id.slice(5)}`);
  }
});
addEventListener("hashchange", () => { place = -1; show(); });
document.getElementById("theme").onclick = () => {
  const root = document.documentElement;
  const dark = root.dataset.theme ? root.dataset.theme === "dark"
    : matchMedia("(prefers-color-scheme: dark)").matches;
  root.dataset.theme = dark ? "light" : "dark";
};
show();
"""
