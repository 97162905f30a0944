"""Steps `check:`: what a sequence does with a ComNo that is not as it is to be."""

from pathlib import Path

import pytest

from fbgen.catalog import Catalog, load_catalog, with_own_sequences
from fbgen.diagnostics import DiagnosticError

SEQUENCE = """
version: 1
id: look
title: Look
description: Looks.
does_not_protect: This is no safety function.
source: written for this test
series: [vf-s11]
steps:
{steps}
"""


def own(folder: Path, *steps: str) -> Catalog:
    (folder / "sequences").mkdir()
    text = SEQUENCE.format(steps="\n".join(f"  - {step}" for step in steps))
    (folder / "sequences" / "look.yaml").write_text(text, encoding="utf-8")
    return with_own_sequences(load_catalog(), folder)


def finding(folder: Path, *steps: str) -> tuple[str, int, str]:
    with pytest.raises(DiagnosticError) as caught:
        own(folder, *steps)
    (found,) = caught.value.diagnostics
    assert found.span is not None
    return found.code, found.span.line - 10, found.message


def test_what_is_set_at_every_inverter_needs_no_value(tmp_path: Path) -> None:
    assert own(tmp_path, "check: baud_rate", "check: F802".replace("F802", "0802"))


def test_anything_else_needs_one(tmp_path: Path) -> None:
    code, line, message = finding(tmp_path, "check: parity", "check: acceleration_time")
    assert (code, line) == ("FB1107", 1)
    assert "acceleration_time" in message


def test_a_setting_that_is_not_for_all_needs_one_too(tmp_path: Path) -> None:
    assert finding(tmp_path, "check: input_function_res")[0] == "FB1107"


def test_a_value_has_to_be_one_of_the_comno(tmp_path: Path) -> None:
    assert finding(tmp_path, "{check: acceleration_time, equals: 7000.0}")[:2] == ("FB1107", 0)


def test_one_comno_is_checked_once(tmp_path: Path) -> None:
    code, line, message = finding(tmp_path, "check: parity", 'check: "0801"')
    assert (code, line) == ("FB1102", 1)
    assert "twice" in message


def test_a_comno_has_to_be_there(tmp_path: Path) -> None:
    assert finding(tmp_path, "check: no_such_comno")[:2] == ("FB1105", 0)
