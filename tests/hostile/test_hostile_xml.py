"""XML of somebody else's: each attack ends with a diagnostic at once, nothing is fetched."""

import time
from pathlib import Path

import pytest

from fbgen.diagnostics import DiagnosticError
from fbgen.lang.containers import read_document

_ENTITIES = "".join(f'<!ENTITY l{number} "{f"&l{number - 1};" * 10}">' for number in range(1, 12))
ATTACKS = {
    "billion_laughs": f'<!DOCTYPE p [<!ENTITY l0 "ha">{_ENTITIES}]><project>&l11;</project>',
    "quadratic": f'<!DOCTYPE p [<!ENTITY a "{"a" * 50_000}">]><project>{"&a;" * 5_000}</project>',
    "file": '<!DOCTYPE p [<!ENTITY a SYSTEM "file:///etc/passwd">]><project>&a;</project>',
    "address": '<!DOCTYPE p SYSTEM "http://127.0.0.1:1/p.dtd"><project/>',
    "parameter_entity": '<!DOCTYPE p [<!ENTITY % a SYSTEM "file:///etc/passwd"> %a;]><project/>',
    "deep": "<a>" * 200_000,
    "deep_and_closed": "<a>" * 5_000 + "</a>" * 5_000,
    "unknown_entity": "<project>&nothing;</project>",
    "cut_off": "<TcPlcObject><POU><Declaration><![CDATA[PROGRAM p",
    "nothing": "",
    "no_xml": "PROGRAM p END_PROGRAM",
    "zero": "<project>\x00</project>",
    "wide_attribute": f'<project a="{">" * 1_000_000}"',
}


@pytest.mark.parametrize("name", ATTACKS)
def test_hostile_xml_ends_with_a_diagnostic(name: str, tmp_path: Path) -> None:
    path = tmp_path / "attack.xml"
    path.write_text(ATTACKS[name], encoding="utf-8")
    begin = time.perf_counter()
    with pytest.raises(DiagnosticError) as refused:
        read_document(path)
    assert time.perf_counter() - begin < 5
    assert {found.code for found in refused.value.diagnostics} == {"FB3016"}
    assert "root:" not in str(refused.value)


def test_an_encoding_that_lies_changes_nothing(tmp_path: Path) -> None:
    path = tmp_path / "a.TcGVL"
    path.write_text(
        '<?xml version="1.0" encoding="utf-16"?><TcPlcObject><GVL Name="g"><Declaration>'
        "VAR_GLOBAL größe : INT; END_VAR</Declaration></GVL></TcPlcObject>",
        encoding="utf-8",
    )
    assert read_document(path).findings == ()
