"""Slots of a modular station: which modules may be plugged where (GSD revision 3 and later)."""

from collections.abc import Iterator

from fbgen.diagnostics import Diagnostic
from fbgen.wire.gsd.lines import Kind, Token
from fbgen.wire.gsd.statements import Tree, number_of
from fbgen.wire.gsd.station import SlotDefinition
from fbgen.wire.gsd.values import not_a


def slot_definitions(tree: Tree, findings: list[Diagnostic]) -> Iterator[SlotDefinition]:
    """The slots: `Slot(1) = "name" 3 1-5` or `... 3 3,5,9`: the default, and what may be there."""
    for block in tree.blocks_of("SlotDefinition"):
        for line in block.statements:
            if line.key != "slot":
                continue
            texts = [token for token in line.value if token.kind is Kind.TEXT]
            ranges = _ranges([token for token in line.value if token.kind is not Kind.TEXT])
            if not line.index or not texts or not ranges:
                findings.append(
                    not_a("a name, the default and the allowed references of modules", line)
                )
                continue
            default, *allowed = ranges
            yield SlotDefinition(
                line.index[0], texts[0].text.strip(), default[0], tuple(allowed) or (default,)
            )


def _ranges(tokens: list[Token]) -> list[tuple[int, int]]:
    """`3 1-5,7` -> (3, 3), (1, 5), (7, 7)."""
    found: list[tuple[int, int]] = []
    until = False
    for token in tokens:
        value = number_of(token.text) if token.kind is Kind.WORD else None
        if value is None:
            until = token.text == "-" and bool(found)
        elif until:
            low = found[-1][0]
            found[-1] = (min(low, value), max(low, value))
            until = False
        else:
            found.append((value, value))
    return found
