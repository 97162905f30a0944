/* Search over everything, in the index that lies beside the pages. */
const MOST_FOUND = 40;

function matches(words, text) {
  let rank = 0;
  for (const word of words) {
    const at = text.indexOf(word);
    if (at < 0) return -1;
    const whole = (at === 0 || !/[a-z0-9]/.test(text[at - 1])) && !/[a-z0-9]/.test(text[at + word.length] ?? " ");
    rank += whole ? 0 : at === 0 || !/[a-z0-9]/.test(text[at - 1]) ? 1 : 2;
  }
  return rank;
}

function find(query) {
  const words = query.toLowerCase().split(/\s+/).filter(Boolean);
  if (!words.length) return [];
  const found = [];
  find.texts ??= window.fbgenIndex.map((entry) => entry[0].toLowerCase());
  find.texts.forEach((text, index) => {
    const rank = matches(words, text);
    if (rank >= 0) found.push([rank, text.length, index]);
  });
  found.sort((one, other) => one[0] - other[0] || one[1] - other[1] || one[2] - other[2]);
  return found.slice(0, MOST_FOUND).map((entry) => window.fbgenIndex[entry[2]]);
}

function search() {
  const input = document.getElementById("search");
  const list = document.getElementById("found");
  let selected = -1;

  function show() {
    const query = input.value.trim();
    const entries = find(query);
    selected = -1;
    list.replaceChildren(...entries.map(([text, place, where], index) =>
      element("li", { role: "option", id: `found-${index}`, "aria-selected": "false" },
        element("a", { href: place, tabindex: "-1" }, text, element("span", { class: "where", text: where })))));
    if (query && !entries.length) list.append(element("li", { class: "none", text: "Nothing found. Try a name, a ComNo or a code." }));
    open(Boolean(query));
  }

  function open(visible) {
    list.hidden = !visible;
    input.setAttribute("aria-expanded", visible ? "true" : "false");
  }

  function select(index) {
    const items = [...list.querySelectorAll("[role=option]")];
    if (!items.length) return;
    selected = (index + items.length) % items.length;
    items.forEach((item, place) => item.setAttribute("aria-selected", place === selected ? "true" : "false"));
    items[selected].scrollIntoView({ block: "nearest" });
    input.setAttribute("aria-activedescendant", items[selected].id);
  }

  input.addEventListener("input", show);
  input.addEventListener("focus", () => { if (input.value.trim()) show(); });
  input.addEventListener("keydown", (event) => {
    if (event.key === "ArrowDown") { event.preventDefault(); select(selected + 1); }
    else if (event.key === "ArrowUp") { event.preventDefault(); select(selected - 1); }
    else if (event.key === "Escape") { input.value = ""; open(false); }
    else if (event.key === "Enter") {
      const links = list.querySelectorAll("a");
      const link = links[Math.max(selected, 0)];
      if (link) { open(false); location.href = link.href; }
    }
  });
  document.addEventListener("click", (event) => { if (!event.target.closest(".search")) open(false); });
  document.addEventListener("keydown", (event) => {
    const typing = /^(INPUT|SELECT|TEXTAREA)$/.test(document.activeElement.tagName);
    if (event.key === "/" && !typing) { event.preventDefault(); input.focus(); }
  });
}
