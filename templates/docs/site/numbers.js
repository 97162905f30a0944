/* Words as people write them; the same rules as `fbgen decode`. */
const HEXADECIMAL = /^(?:(?:16#|0x|\$)([0-9a-f]{1,4})|([0-9a-f]{1,4})h|([0-9a-f]{1,4}))$/;
const BINARY = /^(?:2#|0b)([01]{1,16})$/;
const DECIMAL = /^(?:10#([0-9]{1,5})|([0-9]{5}))$/;

/* The number that a text stands for, null if it is none. */
function parseWord(text) {
  const plain = text.replace(/[_\s]/g, "").toLowerCase();
  let match = HEXADECIMAL.exec(plain);
  if (match) return parseInt(match[1] ?? match[2] ?? match[3], 16);
  match = BINARY.exec(plain);
  if (match) return parseInt(match[1], 2);
  match = DECIMAL.exec(plain);
  const value = match ? parseInt(match[1] ?? match[2], 10) : NaN;
  return value <= 0xffff ? value : null;
}

function hex(value, digits) {
  return value.toString(16).toUpperCase().padStart(digits, "0");
}

function wordHex(value) {
  return hex(value, 4);
}

function wordBinary(value) {
  return value.toString(2).padStart(16, "0").replace(/(.{4})(?=.)/g, "$1_");
}

function spellings(value) {
  return `16#${wordHex(value)}   2#${wordBinary(value)}   ${value}`;
}

function byteText(bytes) {
  return bytes.map((byte) => hex(byte, 2)).join(" ");
}
