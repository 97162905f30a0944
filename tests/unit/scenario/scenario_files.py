"""Scenario files of the tests: written beside a plant of one drive, prepared or run."""

from pathlib import Path

from fbgen.catalog import load_catalog
from fbgen.diagnostics import Diagnostic, DiagnosticError
from harness.scenario import ScenarioResult, prepare, run_case, scenario_cases
from harness.scenario.runner import ScenarioRun

ROOT = Path(__file__).parents[3]
PLANT = ROOT / "tests" / "scenarios" / "one_drive.yaml"
"""Gateway gw1 with the drive pump, INV-NO 11, polled by nobody."""
READ = "plc.TOS_Plant.gw1.pump.read_status"
FIRST_READ = (
    '- {telegrams: [{output: "xx xx FF 0B 47 FC 90 00 00", input: "xx 00 0B 47 FC 90 00 00"}], '
    "gateway: gw1}"
)
"""What goes out before anything else."""


def written(folder: Path, text: str, plant: str = str(PLANT)) -> Path:
    """A scenario file with these lines behind its head: steps, or more before them."""
    path = folder / "tried.scenario.yaml"
    head = f"version: 1\ntitle: Tried out\nplant: {plant}\n"
    path.write_text(head + text, encoding="utf-8")
    return path


def steps(*lines: str) -> str:
    """Steps from their lines; a line that begins a step begins with a dash."""
    return "steps:\n" + "".join(f"  {line}\n" for line in lines)


def prepared(folder: Path, text: str) -> ScenarioRun:
    """The first case of a scenario, ready to run."""
    return prepare(scenario_cases(written(folder, text))[0], load_catalog())


def ran(folder: Path, text: str, seed: int | None = None) -> ScenarioResult:
    """The result of the first case of a scenario."""
    return run_case(scenario_cases(written(folder, text))[0], load_catalog(), seed)


def findings(folder: Path, text: str) -> tuple[Diagnostic, ...]:
    """What is wrong with a scenario before it runs."""
    try:
        prepared(folder, text)
    except DiagnosticError as wrong:
        return wrong.diagnostics
    return ()


def marked(diagnostic: Diagnostic) -> str:
    """The text that the carets stand under."""
    assert diagnostic.span is not None
    return diagnostic.span.text
