"""Cobertura XML, which GitLab, Jenkins and Azure show (the DTD is coverage-04.dtd of Cobertura).

A file is a class there, a block a method, a dialect a package. `timestamp` is 0: the same runs give
the same file.
"""

from collections.abc import Iterable, Sequence
from itertools import groupby
from xml.etree.ElementTree import Element, SubElement, indent, tostring

from fbgen import __version__
from harness.verify.coverage.collecting import Coverage
from harness.verify.coverage.lines import BlockLines, LineCounts, lines_by_file
from harness.verify.coverage.naming import report_names

_HEAD = (
    '<?xml version="1.0" encoding="UTF-8"?>\n'
    '<!DOCTYPE coverage SYSTEM "http://cobertura.sourceforge.net/xml/coverage-04.dtd">\n'
)


def cobertura(coverage: Coverage, source: str = ".") -> str:
    """The whole file; `source` is the folder that the names of the files are seen from."""
    names = report_names(coverage)
    blocks = lines_by_file(coverage)
    keys = sorted(blocks, key=lambda key: (key.dialect, names[key]))
    everything = [line for key in keys for line in _lines(blocks[key])]
    root = Element("coverage", _rates(everything, whole=True))
    root.set("version", f"fbgen {__version__}")
    root.set("timestamp", "0")
    SubElement(SubElement(root, "sources"), "source").text = source
    packages = SubElement(root, "packages")
    for dialect, group in groupby(keys, key=lambda key: key.dialect):
        files = list(group)
        inside = [line for key in files for line in _lines(blocks[key])]
        package = SubElement(packages, "package", {"name": dialect, **_rates(inside)})
        classes = SubElement(package, "classes")
        for key in files:
            _class(classes, names[key], blocks[key])
    indent(root)
    return _HEAD + tostring(root, encoding="unicode") + "\n"


def _lines(blocks: Iterable[BlockLines]) -> list[LineCounts]:
    return [line for block in blocks for line in block.lines]


def _class(classes: Element, name: str, blocks: Sequence[BlockLines]) -> None:
    lines = _lines(blocks)
    title = name.rpartition("/")[2].rpartition(".")[0] or name
    attributes = {"name": title, "filename": name, **_rates(lines)}
    element = SubElement(classes, "class", attributes)
    methods = SubElement(element, "methods")
    for block in blocks:
        attributes = {"name": block.name, "signature": "", **_rates(block.lines)}
        _write_lines(SubElement(methods, "method", attributes), block.lines)
    _write_lines(element, lines)


def _write_lines(element: Element, lines: Iterable[LineCounts]) -> None:
    parent = SubElement(element, "lines")
    for line in lines:
        attributes = {"number": str(line.number), "hits": str(line.hits)}
        ways = [way for ways in line.branchings for way in ways]
        if not ways:
            SubElement(parent, "line", {**attributes, "branch": "false"})
            continue
        taken = sum(bool(way.hits) for way in ways)
        shown = f"{100 * taken // len(ways)}% ({taken}/{len(ways)})"
        one = SubElement(
            parent, "line", {**attributes, "branch": "true", "condition-coverage": shown}
        )
        conditions = SubElement(one, "conditions")
        for number, group in enumerate(line.branchings):
            part = 100 * sum(bool(way.hits) for way in group) // len(group)
            kind = "jump" if len(group) == 2 else "switch"
            SubElement(
                conditions,
                "condition",
                {"number": str(number), "type": kind, "coverage": f"{part}%"},
            )


def _rates(lines: Sequence[LineCounts], *, whole: bool = False) -> dict[str, str]:
    ways = [way for line in lines for group in line.branchings for way in group]
    run = sum(line.hits > 0 for line in lines)
    taken = sum(bool(way.hits) for way in ways)
    rates = {"line-rate": _rate(run, len(lines)), "branch-rate": _rate(taken, len(ways))}
    if whole:
        rates |= {
            "lines-covered": str(run),
            "lines-valid": str(len(lines)),
            "branches-covered": str(taken),
            "branches-valid": str(len(ways)),
        }
    return {**rates, "complexity": "0"}


def _rate(reached: int, total: int) -> str:
    return f"{reached / total:.4f}" if total else "1.0"
