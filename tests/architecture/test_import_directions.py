"""Who may import whom. A part that is changed must not shake what lies below it."""

import ast

import pytest

from tests.architecture.sources import Import, imports, modules, tree

BASE = {
    "fbgen",
    "fbgen.diagnostics",
    "fbgen.excerpt",
    "fbgen.faces",
    "fbgen.kept_folder",
    "fbgen.nearest",
    "fbgen.resources",
    "fbgen.source",
    "fbgen.workers",
    "fbgen.writing",
}
BASE |= {"fbgen.pages"}
DEVICES = {"harness.drives", "harness.fieldbus", "harness.gateways", "harness.line"}
PLANT = {*DEVICES, "harness.engine", "harness.kernel", "harness.installation", "harness.plc"}
TEXT = {"fbgen.blocks", "fbgen.catalog", "fbgen.emit", "fbgen.lang", "fbgen.plant", "fbgen.wire"}

EVERYWHERE = {"fbgen.dataclass"}
"""What stands in for something of the standard library."""

MAY_IMPORT: dict[str, set[str]] = {
    "fbgen": set(),
    "fbgen.dataclass": set(),
    "fbgen.source": set(),
    "fbgen.resources": set(),
    "fbgen.faces": set(),
    "fbgen.nearest": set(),
    "fbgen.writing": set(),
    "fbgen.kept_folder": {"fbgen.diagnostics", "fbgen.writing"},
    "fbgen.cache": {"fbgen", "fbgen.source", "fbgen.writing"},
    "fbgen.workers": {"fbgen.worker_pool"},
    "fbgen.worker_pool": {"fbgen.diagnostics"},
    "fbgen.diagnostics": {"fbgen.excerpt", "fbgen.source"},
    "fbgen.excerpt": {"fbgen.source"},
    "fbgen.columns": set(),
    "fbgen.named_modules": set(),
    "fbgen.pages": {"fbgen.diagnostics", "fbgen.resources"},
    "fbgen.wire": BASE,
    "fbgen.lang": BASE,
    "fbgen.catalog": BASE | {"fbgen.cache", "fbgen.wire"},
    "fbgen.plant": BASE | {"fbgen.cache", "fbgen.catalog", "fbgen.lang", "fbgen.wire"},
    "fbgen.blocks": BASE | {"fbgen.catalog", "fbgen.lang", "fbgen.plant", "fbgen.wire"},
    "fbgen.emit": BASE | TEXT,
    "fbgen.artefacts": BASE | TEXT,
    "fbgen.docs": BASE | TEXT,
    "fbgen.cli": BASE | TEXT | {"fbgen.artefacts", "fbgen.columns", "fbgen.docs"},
    "harness": BASE | TEXT | PLANT | {"harness.trace"},
    "harness.kernel": set(),
    "harness.line": BASE | {"fbgen.wire", "harness.kernel"},
    "harness.fieldbus": BASE | {"fbgen.catalog", "fbgen.wire", "harness.kernel"},
    "harness.drives": BASE | {"fbgen.catalog", "fbgen.wire", "harness.kernel", "harness.line"},
    "harness.gateways": BASE
    | {"fbgen.catalog", "fbgen.wire", "harness.kernel", "harness.line", "harness.fieldbus"},
    "harness.engine": BASE | {"fbgen.lang", "harness.kernel"},
    "harness.plc": BASE
    | {"fbgen.lang", "fbgen.wire", "harness.engine", "harness.fieldbus", "harness.kernel"}
    | {"harness.line"},
    "harness.trace": BASE | TEXT | PLANT,
    "harness.report": BASE | {"harness.results", "harness.trace"},
    "harness.installation": BASE | TEXT | PLANT | {"fbgen.cache", "harness.trace"},
    "harness.not_modelled": set(),
    "harness.durations": {"harness.kernel"},
    "harness.faults": BASE | TEXT | PLANT | {"fbgen.named_modules", "harness.durations"},
    "harness.rules": BASE | TEXT | PLANT | {"fbgen.named_modules"},
    "harness.journal": {"fbgen.source"},
    "harness.sweep": BASE | TEXT | PLANT | {"harness.journal", "harness.rules"},
    "harness.trial": BASE | {"fbgen.lang", "harness.engine", "harness.kernel"},
    "harness.pytest_plugin": BASE
    | TEXT
    | PLANT
    | {"fbgen.columns", "harness.faults", "harness.results", "harness.scenario", "harness.verify"},
    "harness.results": BASE,
    "harness.serial": BASE | TEXT | PLANT | {"harness.durations", "harness.faults"},
    "harness.scenario": BASE
    | TEXT
    | PLANT
    | {"fbgen.cache", "harness.durations", "harness.faults", "harness.results", "harness.rules"}
    | {"harness.serial", "harness.trace", "harness.trial"},
    "harness.verify": BASE
    | TEXT
    | PLANT
    | {"harness.durations", "harness.faults", "harness.journal"}
    | {"harness.results", "harness.scenario", "harness.trace"},
    "harness.demo": BASE | TEXT | PLANT | {"harness.scenario", "harness.trace"},
}
"""Part -> the parts that it may import. A new part gets a line of its own here."""

ONLY_INSIDE_FUNCTIONS = {"fbgen.cli": "harness"}
"""Part -> what it may import beside that, but only when a command runs."""

WITHOUT_TIME_AND_PORTS = {*DEVICES, "fbgen.wire", "harness.engine", "harness.kernel", "harness.plc"}
OUTER_WORLD = {"asyncio", "multiprocessing", "select", "serial", "socket", "subprocess"}
OUTER_WORLD |= {"threading", "time"}


def part(module: str) -> str:
    """`fbgen.catalog.words` belongs to `fbgen.catalog`."""
    return ".".join(module.split(".")[:2])


def allowed(item: Import) -> bool:
    importer, imported = part(item.importer), part(item.imported)
    if importer == imported or imported in EVERYWHERE | MAY_IMPORT.get(importer, set()):
        return True
    lazily = ONLY_INSIDE_FUNCTIONS.get(importer)
    return item.lazily and lazily is not None and imported.split(".")[0] == lazily


def test_every_part_has_its_directions() -> None:
    assert {part(name) for name in modules()} <= set(MAY_IMPORT)


def test_imports_go_in_the_allowed_directions() -> None:
    wrong = [f"{i.importer}:{i.line} imports {i.imported}" for i in imports() if not allowed(i)]
    assert wrong == []


@pytest.mark.parametrize(
    ("item", "expected"),
    [
        (Import("fbgen.cli.demo", "harness.demo", 1, lazily=True), True),
        (Import("fbgen.cli.demo", "harness.demo", 1, lazily=False), False),
        (Import("fbgen.emit.generator", "harness.demo", 1, lazily=True), False),
        (Import("harness.plc.cpu", "fbgen.cli.output", 1, lazily=True), False),
        (Import("fbgen.lang.parser", "fbgen.catalog.words", 1, lazily=False), False),
        (Import("fbgen.catalog.words", "fbgen.catalog.named", 1, lazily=False), True),
    ],
)
def test_the_rule_tells_right_from_wrong(item: Import, expected: bool) -> None:
    assert allowed(item) is expected


def test_dataclasses_write_their_methods_late() -> None:
    """What the decorator of the standard library costs is paid by every start of every command."""
    wrong = [
        f"{name}:{node.lineno}"
        for name, path in modules().items()
        if name != "fbgen.dataclass"
        for node in ast.walk(tree(path))
        if isinstance(node, ast.ImportFrom) and node.module == "dataclasses"
        if any(alias.name in {"dataclass", "make_dataclass"} for alias in node.names)
    ]
    assert wrong == []


def test_devices_and_codecs_know_no_real_time_and_no_ports() -> None:
    wrong = [
        f"{name}:{node.lineno} imports {target}"
        for name, path in modules().items()
        if part(name) in WITHOUT_TIME_AND_PORTS
        for node in ast.walk(tree(path))
        if isinstance(node, (ast.Import, ast.ImportFrom))
        for target in (
            [alias.name for alias in node.names]
            if isinstance(node, ast.Import)
            else [node.module or ""]
        )
        if target.split(".")[0] in OUTER_WORLD
        or (target == "random" and name != "harness.kernel" and "Random" not in ast.unparse(node))
    ]
    assert wrong == []
