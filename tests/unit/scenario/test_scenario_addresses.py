"""Blocks on their own that work on addresses, or on hardware by instructions."""

from pathlib import Path

import pytest

from fbgen.catalog import load_catalog
from fbgen.diagnostics import Diagnostic
from harness.scenario import ScenarioResult, run_case, scenario_cases
from tests.unit.scenario.scenario_files import marked

VALVE = """\
FUNCTION_BLOCK "Valve"
BEGIN
  %Q2.7 := %I0.3 AND NOT %I0.2;
  %QW4 := %IW6;
  %QB9 := %MB11;
  %MD12 := 16#1234_5678;
END_FUNCTION_BLOCK
"""
RECORD = """\
FUNCTION_BLOCK "Record"
VAR_OUTPUT
  status : INT;
END_VAR
VAR
  bytes : ARRAY[0..3] OF BYTE;
END_VAR
BEGIN
  #status := DPRD_DAT(LADDR := 260, RECORD => #bytes);
END_FUNCTION_BLOCK
"""


def ran(folder: Path, source: str, block: str, text: str) -> ScenarioResult:
    (folder / "block.scl").write_text(source, "utf-8")
    path = folder / "block.scenario.yaml"
    path.write_text(f"version: 1\ntitle: T\nsources: [block.scl]\nblock: {block}\n{text}", "utf-8")
    return run_case(scenario_cases(path)[0], load_catalog())


def failure(result: ScenarioResult) -> Diagnostic:
    (found,) = result.failures
    return found


@pytest.mark.parametrize("engine", ["compiled", "reference"])
def test_what_has_no_name_has_its_address(tmp_path: Path, engine: str) -> None:
    text = """\
steps:
  - set: {address.I0.3: true, address.IB6: 16#12, address.IB7: 16#34, address.QB2: 16#01, address.MB11: 7}
  - call: 1
  - expect: {address.Q2.7: true, address.QB2: 16#81, address.QW4: 16#1234, address.QB9: 7}
  - expect: {address.MD12: 16#12345678, address.mw14: 16#5678, address.I0.2: false}
  - set: {address.I0.3: false}
  - call: 1
  - expect: {address.Q2.7: false, address.QB2: 16#01}
"""  # noqa: E501 - a line of a scenario file
    result = ran(tmp_path, VALVE, "Valve", f"engine: {engine}\n{text}")
    assert result.passed, result.render()


@pytest.mark.parametrize(
    ("address", "advice"),
    [("IX", "IB256"), ("DB3", "IB256"), ("QW1023", "1024 bytes"), ("I0.8", "I0.3")],
)
def test_an_address_that_is_not_there_is_marked(tmp_path: Path, address: str, advice: str) -> None:
    text = f"steps:\n  - expect: {{address.{address}: 1}}\n"
    found = failure(ran(tmp_path, VALVE, "Valve", text))
    assert (found.code, marked(found)) == ("FB8003", f"address.{address}")
    assert advice in (found.help or "")


@pytest.mark.parametrize("engine", ["compiled", "reference"])
@pytest.mark.parametrize(("given", "shown"), [("16#8090", -32624), ("-1", -1), ("0", 0)])
def test_a_stub_carries_out_an_instruction_of_the_hardware(
    tmp_path: Path, engine: str, given: str, shown: int
) -> None:
    text = f"""\
engine: {engine}
stubs: {{DPRD_DAT: {{RET_VAL: {given}, RECORD: DF 00 0B}}}}
steps:
  - set: {{"block.bytes[3]": 9}}
  - call: 1
  - expect: {{block.status: {shown}, "block.bytes[0]": 16#DF, "block.bytes[2]": 16#0B, "block.bytes[3]": 9}}
"""  # noqa: E501 - a line of a scenario file
    result = ran(tmp_path, RECORD, "Record", text)
    assert result.passed, result.render()


@pytest.mark.parametrize(
    ("outputs", "message"),
    [
        ("RECORD: DG", "takes bytes"),
        ("COUNT: 2", "'count', which the call does not ask for"),
        ("RET_VAL: 70000", "has an INT"),
    ],
)
def test_a_stub_that_gives_what_an_instruction_does_not_take_is_told(
    tmp_path: Path, outputs: str, message: str
) -> None:
    steps = "steps:\n  - call: 1\n  - expect: {block.status: 0}\n"
    text = f"stubs: {{DPRD_DAT: {{{outputs}}}}}\n{steps}"
    found = failure(ran(tmp_path, RECORD, "Record", text))
    assert found.code == "FB6071"
    assert message in found.message
