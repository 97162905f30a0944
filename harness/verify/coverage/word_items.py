"""The bits of a word as items of catalogue coverage: `vf-s11.command.run = 1`."""

from collections.abc import Iterator

from fbgen.catalog import Word


def values_of(name: str, word: Word) -> Iterator[str]:
    """Each bit as 0 and as 1; a wider field with each value that has a meaning."""
    for field in word.bits:
        values = (0, 1) if field.low == field.high else field.values
        yield from (f"{name}.{field.name} = {value}" for value in values)


def values_in(name: str, word: Word, data: int) -> Iterator[str]:
    """Those of them that this word shows."""
    return (f"{name}.{one.field.name} = {one.value}" for one in word.decode(data))
