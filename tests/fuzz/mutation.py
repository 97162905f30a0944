"""Changes to a corpus of real inputs: bits, bytes, pieces, lines, and pieces of other inputs."""

from collections.abc import Callable, Sequence
from random import Random

_TOKENS = (
    b"IF", b"END_IF;", b"CASE", b"OF", b"(*", b"*)", b"//", b"'", b'"', b"#", b"%", b":=", b"..",
    b"16#", b"T#", b"{", b"}", b"[", b"]", b"(", b")", b"\x00", b"\xff", b"\r", b"&", b"*", b"!!",
    b"- ", b": ", b"|", b">", b"\t", b"\xe2\x80\xae", b"\xee\x80\x80", b"VAR", b"END_VAR",
    b"REGION", b"END_REGION", b":P", b"^", b"?=", b"P#", b"B#(", b"M0.", b"DB1.", b"%DB1.",
    b"CONST", b"LABEL", b"GOTO", b"TITLE =", b"VERSION", b"\xc2\xa0", b"(/*",
)  # fmt: skip
_MOST_BYTES = 20_000

Mutator = Callable[[bytearray, Random, Sequence[bytes]], None]


def mutated(random: Random, corpus: Sequence[bytes]) -> bytes:
    """One input of the corpus after one to eight changes."""
    data = bytearray(random.choice(corpus)[:_MOST_BYTES])
    for _ in range(random.randint(1, 8)):
        random.choice(_MUTATORS)(data, random, corpus)
    return bytes(data[:_MOST_BYTES])


def _flip_bit(data: bytearray, random: Random, corpus: Sequence[bytes]) -> None:
    if data:
        data[random.randrange(len(data))] ^= 1 << random.randrange(8)


def _set_byte(data: bytearray, random: Random, corpus: Sequence[bytes]) -> None:
    if data:
        data[random.randrange(len(data))] = random.randrange(256)


def _insert_token(data: bytearray, random: Random, corpus: Sequence[bytes]) -> None:
    at = random.randint(0, len(data))
    data[at:at] = random.choice(_TOKENS) * random.choice((1, 1, 1, 2, 400))


def _remove_piece(data: bytearray, random: Random, corpus: Sequence[bytes]) -> None:
    at = random.randint(0, len(data))
    del data[at : at + random.choice((1, 2, 10, 100))]


def _repeat_piece(data: bytearray, random: Random, corpus: Sequence[bytes]) -> None:
    at = random.randint(0, len(data))
    data[at:at] = bytes(data[at : at + random.randint(1, 60)]) * random.choice((1, 3, 50))


def _cut(data: bytearray, random: Random, corpus: Sequence[bytes]) -> None:
    del data[random.randint(0, len(data)) :]


def _swap_lines(data: bytearray, random: Random, corpus: Sequence[bytes]) -> None:
    lines = bytes(data).split(b"\n")
    first, second = random.randrange(len(lines)), random.randrange(len(lines))
    lines[first], lines[second] = lines[second], lines[first]
    data[:] = b"\n".join(lines)


def _take_from_another(data: bytearray, random: Random, corpus: Sequence[bytes]) -> None:
    other = random.choice(corpus)
    at, start = random.randint(0, len(data)), random.randint(0, len(other))
    data[at:at] = other[start : start + random.randint(1, 200)]


_MUTATORS: tuple[Mutator, ...] = (
    _flip_bit, _set_byte, _insert_token, _remove_piece, _repeat_piece, _cut, _swap_lines,
    _take_from_another,
)  # fmt: skip
