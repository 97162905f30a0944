"""Scenarios of a block on its own: a tank whose pump runs while it is not full."""

from pathlib import Path

from fbgen.catalog import load_catalog
from fbgen.diagnostics import Diagnostic
from harness.scenario import ScenarioResult, run_case, scenario_cases

TANK = """\
FUNCTION_BLOCK "Tank"
VAR_INPUT
  start : BOOL;
  level : INT;
END_VAR
VAR_OUTPUT
  pump : BOOL;
  calls : INT;
  state : WORD;
END_VAR
VAR
  delay : TON_TIME;
END_VAR
BEGIN
  #delay(IN := #start AND #level < 80, PT := T#50ms);
  #pump := #delay.Q;
  #calls := #calls + 1;
  #state := W#16#8000;
END_FUNCTION_BLOCK
"""
HEAD = "version: 1\ntitle: Tank\nsources: [tank.scl]\n"


def tank_file(folder: Path, text: str, source: str = TANK) -> Path:
    """A scenario of the tank, with these lines behind its head."""
    (folder / "tank.scl").write_text(source, "utf-8")
    path = folder / "tank.scenario.yaml"
    path.write_text(HEAD + text, "utf-8")
    return path


def tanks(folder: Path, text: str, source: str = TANK) -> list[ScenarioResult]:
    """What comes of all its runs."""
    cases = scenario_cases(tank_file(folder, text, source))
    return [run_case(case, load_catalog()) for case in cases]


def tank(folder: Path, text: str, source: str = TANK) -> ScenarioResult:
    """What comes of its only run."""
    (result,) = tanks(folder, text, source)
    return result


def only_failure(result: ScenarioResult) -> Diagnostic:
    """The only thing that is wrong."""
    (failure,) = result.failures
    return failure
