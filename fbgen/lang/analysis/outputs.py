"""Output addresses that two blocks write: the one that runs later wins, in every cycle."""

from collections.abc import Iterator, Sequence

from fbgen.diagnostics import Note
from fbgen.lang.analysis.flow import Flow
from fbgen.lang.checked import Address, Block
from fbgen.source import Span

_Written = tuple[int, int, Address, Span, Flow]


def check_outputs(flows: Sequence[Flow]) -> None:
    """FB4224."""
    written = sorted(
        (one for flow in flows for one in _outputs_of(flow)), key=lambda one: (one[0], one[1])
    )
    reported: set[tuple[Block, Block]] = set()
    open_: list[_Written] = []
    for item in written:
        open_ = [earlier for earlier in open_ if earlier[1] > item[0]]
        for earlier in open_:
            pair = (earlier[4].block, item[4].block)
            if earlier[4] is item[4] or pair in reported:
                continue
            reported |= {pair, (pair[1], pair[0])}
            item[4].report.warning(
                "FB4224",
                f"output {_spelled(item[2])} is written by {earlier[4].block.name} too",
                item[3],
                "write an output in one block only, and let the others set variables for it",
                notes=(Note("the other place is here", earlier[3]),),
            )
        open_.append(item)


def _outputs_of(flow: Flow) -> Iterator[_Written]:
    """Each address once: from bit, to bit (not included), the address, where, by whom."""
    seen: set[tuple[int, int]] = set()
    places = [(ref.address, ref.span) for ref in flow.facts.addresses_written]
    places += [
        (variable.address, span)
        for variable, span in flow.facts.written.items()
        if variable.address is not None
    ]
    for address, span in places:
        start = address.byte * 8 + address.bit
        if address.area == "Q" and (start, address.bits) not in seen:
            seen.add((start, address.bits))
            yield start, start + address.bits, address, span, flow


def _spelled(address: Address) -> str:
    if address.bits == 1:
        return f"%Q{address.byte}.{address.bit}"
    return f"%Q{ {8: 'B', 16: 'W', 32: 'D', 64: 'L'}[address.bits] }{address.byte}"
