// The trace of a run, read from the columns that harness/report/trace_columns.py has written.

/** Ascending times from their differences. */
function timesOf(differences) {
  const times = new Float64Array(differences.length);
  let now = 0;
  for (let index = 0; index < differences.length; index++) {
    now += differences[index];
    times[index] = now;
  }
  return times;
}

class Trace {
  constructor(data) {
    this.title = data.title;
    this.start = data.start;
    this.end = Math.max(data.end, data.start + 1);
    this.texts = data.texts;
    this.words = data.words.map(([title, fields]) => new Word(title, fields));
    this.places = data.places.map((place) => this._place(place));
    this.channels = data.channels.map((channel) => this._channel(channel));
    this.frames = this._frames(data.frames);
    this.telegrams = this._telegrams(data.telegrams);
    this.marks = data.marks.map((mark) => this._mark(mark));
  }

  _text(number) {
    return number < 0 ? null : this.texts[number];
  }

  _place([file, line, column, text, block, instance]) {
    return {
      file: this._text(file),
      line,
      column,
      text: this._text(text),
      block: this._text(block),
      instance: this._text(instance),
    };
  }

  _channel(data) {
    const [path, title, kind, group, owner, unit, word] = data.is;
    const texts = data.s?.map((number) => this.texts[number]);
    const values = data.v ?? (kind === "real" ? texts.map(Number) : texts);
    const known = word < 0 ? null : this.words[word];
    const writers = data.w ?? null;
    return { path, title, kind, group, owner, unit, word: known, writers, values, times: timesOf(data.t) };
  }

  _frames(data) {
    const starts = timesOf(data.t);
    return Array.from(starts, (start, index) => ({
      start,
      end: start + data.d[index],
      line: this._text(data.line[index]),
      sender: this._text(data.from[index]),
      toDrives: data.down[index] === 1,
      kind: this._text(data.kind[index]),
      bytes: this._text(data.data[index]),
      heard: this._text(data.heard[index]),
      damaged: (data.hurt[index] & 1) !== 0,
      collided: (data.hurt[index] & 2) !== 0,
      meaning: this._text(data.says[index]),
      identifier: data.id[index] < 0 ? null : data.id[index],
    }));
  }

  _telegrams(data) {
    const starts = timesOf(data.t);
    return Array.from(starts, (start, index) => ({
      start,
      end: data.d[index] < 0 ? null : start + data.d[index],
      gateway: this._text(data.gateway[index]),
      output: this._text(data.out[index]),
      input: this._text(data.in[index]),
      meaning: this._text(data.says[index]),
      place: this.places[data.w[index]] ?? null,
    }));
  }

  _mark([start, end, kind, title, target, place, verdict]) {
    return { start, end: end ?? this.end, open: end === null, kind, title, target, verdict, place: this.places[place] ?? null };
  }

  /** Checks, steps and faults that failed, in the order of when that was found. */
  failures() {
    const failed = this.marks.filter((mark) => mark.verdict === "failed");
    const checks = failed.filter((mark) => mark.kind === "check");
    return (checks.length ? checks : failed).sort((one, other) => one.end - other.end);
  }
}

/** A word of the catalogue: which bits are called what. */
class Word {
  constructor(title, fields) {
    this.title = title;
    this.fields = fields.map(([name, text, low, high, meanings]) => ({
      name,
      title: text,
      low,
      high,
      meanings: meanings ?? {},
    }));
  }

  /** Every field with its value in a word, highest bit first; `changed` against the word before. */
  decode(value, before) {
    const word = BigInt(value);
    const old = before === null ? word : BigInt(before);
    return this.fields.map((field) => {
      const mask = (1n << BigInt(field.high - field.low + 1)) - 1n;
      const found = (word >> BigInt(field.low)) & mask;
      return {
        field,
        value: found,
        meaning: field.meanings[found] ?? "",
        changed: found !== ((old >> BigInt(field.low)) & mask),
      };
    });
  }

  /** The fields that are not 0, by name; of single bits the name says enough. */
  describe(value) {
    const set = this.decode(value, null).filter((item) => item.value !== 0n);
    const named = set.map(({ field, value: found, meaning }) => {
      if (field.low === field.high) return field.name;
      return meaning ? `${field.name} (${meaning})` : `${field.name}=${found}`;
    });
    return named.join(", ") || "no bit is set";
  }
}
