/* A value to the word of a ComNo and back. */
function converter(place, data) {
  const select = element("select", {}, ...data.comnos.map(([number, name]) => element("option", { value: number, text: `${number} ${name}` })));
  select.value = data.first;
  const value = element("input", { class: "short fixed", type: "text", inputmode: "decimal", value: "50" });
  const word = element("input", { class: "short fixed", type: "text" });
  const unit = element("span");
  const shown = element("p", { class: "fixed spellings", role: "status" });
  const wrong = element("p", { class: "wrong", role: "alert" });
  place.append(element("div", { class: "row" }, labelled("ComNo", select), element("label", {}, element("span", {}, "Value ", unit), value), labelled("Word", word)), shown, wrong);

  const chosen = () => data.comnos.find(([number]) => number === select.value);

  function fromValue() {
    const [, , unitText, count, least, most] = chosen();
    unit.textContent = unitText ? `in ${unitText}` : "";
    const number = Number(value.value.replace(",", "."));
    if (value.value.trim() === "" || !Number.isFinite(number)) return fail("The value is a number, such as 50 or 12.5.");
    const made = roundHalfEven(number / count);
    if (made < 0 || made > 0xffff) return fail(`The word would be ${made}: a word is 0 to 65535.`);
    word.value = wordHex(made);
    return tell(made, least, most);
  }

  function fromWord() {
    const [, , , count, least, most] = chosen();
    const number = parseWord(word.value);
    if (number === null) return fail("The word is no 16-bit number: write 1388 or 10#5000.");
    value.value = plainNumber(number * count);
    return tell(number, least, most);
  }

  function tell(number, least, most) {
    const [, , unitText, count] = chosen();
    shown.textContent = `${plainNumber(number * count)} ${unitText} = ${spellings(number)}`;
    const limits = `${plainNumber(least * count)} to ${plainNumber(most * count)} ${unitText}`;
    wrong.textContent = number < least || number > most ? `Outside the range of the inverter, ${limits}: it answers with error 0001.` : "";
  }

  function fail(text) {
    shown.textContent = "";
    wrong.textContent = text;
  }

  select.addEventListener("change", fromValue);
  value.addEventListener("input", fromValue);
  word.addEventListener("input", fromWord);
  fromValue();
}

/* As Python rounds: a half goes to the even neighbour. */
function roundHalfEven(number) {
  const below = Math.floor(number);
  const rest = number - below;
  if (rest !== 0.5) return Math.round(number);
  return below % 2 === 0 ? below : below + 1;
}

function plainNumber(number) {
  return `${Number(number.toFixed(6))}`;
}
