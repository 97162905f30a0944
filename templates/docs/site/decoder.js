/* A word: type it in, or switch its bits; what it says, and the bytes that carry it. */
function element(name, attributes, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes ?? {})) {
    if (key === "text") made.textContent = value;
    else if (key.startsWith("on")) made.addEventListener(key.slice(2), value);
    else if (value !== false && value !== undefined) made.setAttribute(key, value === true ? "" : value);
  }
  made.append(...children);
  return made;
}

function labelled(text, control) {
  return element("label", {}, text, control);
}

function decoder(place, data) {
  const state = { value: 0, number: 11, control: 0, trigger: 1, comno: (data.comnos ?? [])[0] };
  const input = element("input", { class: "word fixed", type: "text", spellcheck: "false", autocomplete: "off", "aria-describedby": "decoder-wrong" });
  const wrong = element("p", { class: "wrong", id: "decoder-wrong", role: "status" });
  const shown = element("span", { class: "fixed spellings" });
  const bits = element("div", { class: "bits", role: "group", "aria-label": "Bits" });
  const buttons = [];
  for (let bit = 15; bit >= 0; bit -= 1) {
    const field = data.fields.find((one) => one.high >= bit && bit >= one.low);
    const button = element("button", {
      type: "button", class: field ? "" : "unnamed", title: field ? `${field.name}: ${field.title}` : "no document gives it a meaning",
      onclick: () => change(state.value ^ (1 << bit)),
    }, element("span", { class: "unseen", text: "bit " }), `${bit}`, element("span", { class: "unseen", text: field ? ` ${field.name}` : "" }), element("b", { text: "0", "aria-hidden": "true" }));
    buttons[bit] = button;
    bits.append(button);
  }
  const body = element("tbody");
  const fields = element("table", { class: "fields" },
    element("thead", {}, element("tr", {}, ...["Bit", "Name", "Value", "Meaning"].map((text) => element("th", { scope: "col", text })))), body);
  const telegrams = element("dl");
  input.addEventListener("input", () => {
    const value = parseWord(input.value);
    input.setAttribute("aria-invalid", value === null ? "true" : "false");
    wrong.textContent = value === null ? "This is no 16-bit number: write 9F00, 16#9F00, 2#1001_1111_0000_0000 or 10#40704." : "";
    if (value !== null) show(value);
  });
  const rows = [element("div", { class: "row" }, labelled("Value: hexadecimal, 2#... or 10#...", input), shown), wrong, bits];
  if (data.telegrams) rows.push(telegramInputs(data, state, () => show(state.value)));
  place.append(...rows, element("div", { class: "wide" }, fields), telegrams);

  function change(value) {
    input.value = wordHex(value);
    input.setAttribute("aria-invalid", "false");
    wrong.textContent = "";
    show(value);
  }

  function show(value) {
    state.value = value;
    shown.textContent = spellings(value);
    buttons.forEach((button, bit) => {
      const set = (value >> bit) & 1;
      button.setAttribute("aria-pressed", set ? "true" : "false");
      button.querySelector("b").textContent = set;
    });
    body.replaceChildren(...data.fields.map((field) => meaning(field, value)));
    if (data.telegrams) telegrams.replaceChildren(...carriers(data, state));
    keep(state);
  }

  change(remembered(state));
  addEventListener("hashchange", () => {
    if (!location.hash.startsWith("#v=")) return;
    change(remembered(state));
    place.scrollIntoView({ block: "center" });
    input.focus({ preventScroll: true });
  });
}

function meaning(field, value) {
  const wide = field.high - field.low + 1;
  const part = (value >> field.low) & (2 ** wide - 1);
  const bit = wide > 1 ? `${field.high}..${field.low}` : `${field.high}`;
  const text = field.values[part] ? `${field.title}: ${field.values[part]}` : field.title;
  const cells = [bit, field.name, wide > 1 ? hex(part, Math.ceil(wide / 4)) : `${part}`, text];
  return element("tr", { class: part ? "set" : "" }, ...cells.map((cell) => element("td", { text: cell })));
}

/* What else a telegram holds. */
function telegramInputs(data, state, changed) {
  const row = element("div", { class: "row" });
  const take = (name, text, digits, most, radix) => {
    const control = element("input", { class: "short fixed", type: "text", value: radix === 16 ? hex(state[name], digits) : `${state[name]}`, "data-part": name });
    control.addEventListener("input", () => {
      const value = parseInt(control.value, radix);
      const right = /^[0-9a-f]+$/i.test(control.value.trim()) && value >= 0 && value <= most;
      control.setAttribute("aria-invalid", right ? "false" : "true");
      if (right) { state[name] = value; changed(); }
    });
    row.append(labelled(text, control));
  };
  take("number", "INV-NO, 0 to 63, or 255 for all", 2, 255, 10);
  if (data.comnos.length > 1) {
    const select = element("select", { "data-part": "comno" }, ...data.comnos.map((comno) => element("option", { text: comno })));
    select.addEventListener("change", () => { state.comno = select.value; changed(); });
    row.append(labelled("ComNo", select));
  }
  if (data.telegrams.length) {
    take("control", data.writes ? "Control word, hexadecimal" : "Status word of the gateway, hexadecimal", 4, 0xffff, 16);
    if (data.writes) take("trigger", "Trigger, hexadecimal", 2, 255, 16);
  }
  return row;
}

/* Frame on the line and cyclic data, for the word as it is. */
function carriers(data, state) {
  const comno = parseInt(state.comno, 16);
  const parts = [];
  const add = (title, bytes, name) => parts.push(element("dt", { text: title }), element("dd", { class: "fixed bytes", "data-frame": name, text: byteText(bytes) }));
  if (data.writes) {
    add("Frame on the line, RAM (P)", binaryFrame(state.number, 0x50, comno, [state.value]), "ram");
    add("Frame on the line, RAM and EEPROM (W)", binaryFrame(state.number, 0x57, comno, [state.value]), "eeprom");
  } else {
    add("Request on the line", binaryFrame(state.number, 0x52, comno, []), "request");
    add("Reply on the line", binaryFrame(state.number, 0x52, comno, [state.value]), "reply");
  }
  for (const telegram of data.telegrams) {
    const values = { control: state.control, status: state.control, trigger: state.trigger, inv_no: state.number, cmd: data.writes ? 0x50 : 0x47, comno, data: state.value };
    add(`${telegram.gateway}, ${data.writes ? "output" : "input"} bytes (${telegram.layout})`, cyclicData(telegram.fields, values), telegram.gateway);
  }
  return parts;
}

/* The address keeps the state, so that a link shows the same. */
function keep(state) {
  const parts = [`v=${wordHex(state.value)}`, `n=${state.number}`];
  if (state.control) parts.push(`c=${wordHex(state.control)}`);
  if (decoder.ready || state.value) history.replaceState(null, "", `#${parts.join("&")}`);
  decoder.ready = true;
}

function remembered(state) {
  const parts = new Map(location.hash.slice(1).split("&").map((part) => part.split("=")));
  const value = parts.has("v") ? parseWord(parts.get("v")) : 0;
  const number = parseInt(parts.get("n") ?? "", 10);
  if (number >= 0 && number <= 255) state.number = number;
  const control = parts.has("c") ? parseWord(parts.get("c")) : null;
  if (control !== null) state.control = control;
  return value ?? 0;
}
