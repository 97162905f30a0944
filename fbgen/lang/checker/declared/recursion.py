"""Blocks that call themselves, directly or over others: no controller has a stack for that.

Sources: IEC 61131-3 third edition, section 6.6.1; TIA Portal help, "Block calls" (nesting depth).
"""

from collections.abc import Mapping

from fbgen.lang.checked import Block
from fbgen.lang.checker.library import Library


def report_recursive_calls(library: Library, blocks: Mapping[str, Block]) -> None:
    """Report each call that closes a circle."""
    done: set[Block] = set()
    for start in blocks.values():
        if start in done:
            continue
        path: list[Block] = [start]
        on_path = {start}
        pending = [iter(library.context_of(start).calls.items())]
        while path:
            step = next(pending[-1], None)
            if step is None:
                done.add(path[-1])
                on_path.discard(path.pop())
                pending.pop()
                continue
            called, span = step
            if called in on_path:
                names = [block.name for block in path[path.index(called) :]]
                library.findings.error(
                    "FB4051",
                    f"recursive call: {' -> '.join([*names, called.name])}",
                    span,
                    "use a loop instead",
                )
            elif called not in done:
                path.append(called)
                on_path.add(called)
                pending.append(iter(library.context_of(called).calls.items()))
