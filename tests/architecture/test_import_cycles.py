"""Any module can be the first one that a process imports: no imports in a circle."""

from collections.abc import Iterable
from graphlib import CycleError, TopologicalSorter

from tests.architecture.sources import Import, imports, modules


def circle(found: Iterable[Import], known: Iterable[str]) -> list[str]:
    """The modules of one circle, empty if there is none.

    Importing `a.b.c` imports `a` and `a.b` too, unless the importer lies in them itself.
    """
    names = set(known)
    graph: dict[str, set[str]] = {name: set() for name in names}
    for item in found:
        if item.lazily:
            continue
        steps = item.imported.split(".")
        for length in range(1, len(steps) + 1):
            target = ".".join(steps[:length])
            if target in names and not f"{item.importer}.".startswith(f"{target}."):
                graph[item.importer].add(target)
    try:
        TopologicalSorter(graph).prepare()
    except CycleError as error:
        return list(error.args[1])
    return []


def test_no_modules_import_each_other_in_a_circle() -> None:
    assert circle(imports(), modules()) == []


def test_a_circle_through_a_package_is_seen() -> None:
    known = ("p", "p.a", "p.a.one", "p.b", "p.b.two")
    found = [
        Import("p.a", "p.a.one", 1, lazily=False),
        Import("p.a.one", "p.b.two", 1, lazily=False),
        Import("p.b", "p.a", 1, lazily=False),
    ]
    assert circle(found, known) != []
    assert circle(found[:2], known) == []
    assert circle([*found[:2], Import("p.b", "p.a", 1, lazily=True)], known) == []
