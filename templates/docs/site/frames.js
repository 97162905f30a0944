/* Binary frames of the Toshiba protocol and the cyclic data in which a gateway carries them. */
const START = 0x2f;

function highAndLow(word) {
  return [word >> 8, word & 0xff];
}

/* Start code, number, command, ComNo, data words, and the low byte of the sum of all of them. */
function binaryFrame(number, command, comno, words) {
  const bytes = [START, number, command, ...highAndLow(comno), ...words.flatMap(highAndLow)];
  return [...bytes, bytes.reduce((sum, byte) => sum + byte, 0) & 0xff];
}

/* The bytes of a layout: `fields` are [name, offset, length], `values` by name; the rest is 0. */
function cyclicData(fields, values) {
  const bytes = [];
  for (const [name, offset, length] of fields) {
    const value = values[name] ?? 0;
    for (let index = 0; index < length; index += 1) {
      bytes[offset + index] = (value >> (8 * (length - 1 - index))) & 0xff;
    }
  }
  return bytes;
}
