"""LCOV tracefiles, which genhtml and CI servers read (geninfo(1), "FILES").

A block is a function there. MC/DC is left to our own formats: only LCOV 2.2 and newer knows it.
"""

from collections.abc import Iterator, Sequence

from harness.verify.coverage.collecting import Coverage
from harness.verify.coverage.lines import BlockLines, LineCounts, lines_by_file
from harness.verify.coverage.naming import report_names


def lcov(coverage: Coverage) -> str:
    """The whole tracefile."""
    names = report_names(coverage)
    parts: list[str] = []
    found = lines_by_file(coverage)
    for key in sorted(found, key=names.__getitem__):
        blocks = found[key]
        lines = [line for block in blocks for line in block.lines]
        parts += [
            "TN:",
            f"SF:{names[key]}",
            *_functions(blocks),
            *_branches(lines),
            *(f"DA:{line.number},{line.hits}" for line in lines),
            f"LF:{len(lines)}",
            f"LH:{sum(line.hits > 0 for line in lines)}",
            "end_of_record",
        ]
    return "\n".join(parts) + "\n"


def _functions(blocks: Sequence[BlockLines]) -> Iterator[str]:
    for block in blocks:
        yield f"FN:{block.first_line},{block.name}"
    for block in blocks:
        yield f"FNDA:{block.calls},{block.name}"
    yield f"FNF:{len(blocks)}"
    yield f"FNH:{sum(block.calls > 0 for block in blocks)}"


def _branches(lines: Sequence[LineCounts]) -> Iterator[str]:
    found = [
        (line.number, number, place, way.hits)
        for line in lines
        for number, ways in enumerate(line.branchings)
        for place, way in enumerate(ways)
    ]
    for line_number, number, place, hits in found:
        yield f"BRDA:{line_number},{number},{place},{'-' if hits is None else hits}"
    yield f"BRF:{len(found)}"
    yield f"BRH:{sum(bool(hits) for *_, hits in found)}"
