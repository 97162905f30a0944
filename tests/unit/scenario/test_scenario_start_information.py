"""A scenario of an organization block sets what the operating system tells it."""

from pathlib import Path

from fbgen.catalog import load_catalog
from harness.scenario import ScenarioResult, run_case, scenario_cases

ERROR_BLOCK = """\
DATA_BLOCK "Seen"
STRUCT
  class : BYTE;
  station : DWORD;
  own : INT;
END_STRUCT;
BEGIN
END_DATA_BLOCK
ORGANIZATION_BLOCK "OB86"
VAR_TEMP
  EV_CLASS : BYTE;
  HEAD : ARRAY[1..7] OF BYTE;
  Z23 : DWORD;
  STAMP : DATE_AND_TIME;
  own : INT;
END_VAR
BEGIN
  #own := "Seen".own + 1;
  "Seen".own := #own;
  "Seen".class := #EV_CLASS;
  "Seen".station := #Z23;
END_ORGANIZATION_BLOCK
"""


def ran(folder: Path, steps: str) -> ScenarioResult:
    (folder / "ob86.scl").write_text(ERROR_BLOCK, "utf-8")
    path = folder / "ob86.scenario.yaml"
    head = "version: 1\ntitle: T\nsources: [ob86.scl]\nblock: OB86\nsteps:\n"
    path.write_text(head + steps, "utf-8")
    (case,) = scenario_cases(path)
    return run_case(case, load_catalog())


def test_what_is_set_is_there_in_each_call_from_then_on(tmp_path: Path) -> None:
    result = ran(
        tmp_path,
        "  - call: 1\n"
        "  - expect: {plc.Seen.class: 0, plc.Seen.station: 0, plc.Seen.own: 1}\n"
        "  - set: {block.EV_CLASS: 16#39, block.Z23: 16#00000102}\n"
        "  - expect: {block.EV_CLASS: 16#39}\n"
        "  - call: 2\n"
        "  - expect: {plc.Seen.class: 16#39, plc.Seen.station: 16#00000102, plc.Seen.own: 3}\n"
        "  - set: {block.ev_class: 16#38}\n"
        "  - call: 1\n"
        "  - expect: {plc.Seen.class: 16#38, plc.Seen.station: 16#00000102}\n",
    )
    assert result.failures == ()


def test_a_temporary_of_its_own_cannot_be_set(tmp_path: Path) -> None:
    result = ran(tmp_path, "  - set: {block.own: 1}\n  - expect: {plc.Seen.own: 0}\n")
    assert [failure.code for failure in result.failures] == ["FB8003"]


def test_a_value_that_does_not_fit_is_a_mistake_at_its_place(tmp_path: Path) -> None:
    result = ran(tmp_path, "  - set: {block.EV_CLASS: 300}\n  - expect: {plc.Seen.own: 0}\n")
    (failure,) = result.failures
    assert failure.span is not None
    assert failure.span.text == "300"
