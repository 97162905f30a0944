"""SCL of STEP 7 V5 and of TIA Portal in files of the same suffix."""

from pathlib import Path

import pytest

from fbgen.cli.sources.plc_files import programs_of
from fbgen.lang.containers import read_document
from fbgen.lang.containers.age import Age, age_of

_CLASSIC = "FUNCTION_BLOCK FB1\nCONST\n   TOP := 3;\nEND_CONST\nBEGIN\nEND_FUNCTION_BLOCK\n"
_EITHER = "FUNCTION FC2 : VOID\nVAR_TEMP x : INT; END_VAR\nBEGIN\nx := 1;\nEND_FUNCTION\n"
_TIA = "FUNCTION \"F\" : Void\n{ S7_Optimized_Access := 'TRUE' }\nVERSION : 0.1\nEND_FUNCTION\n"


@pytest.mark.parametrize(
    ("text", "age"),
    [
        (_CLASSIC, Age.CLASSIC),
        (_TIA, Age.TIA),
        (_EITHER, Age.EITHER),
        ("x := E1.0 AND NOT M 3;", Age.CLASSIC),
        ("x := PEW256;", Age.CLASSIC),
        ("x := %E1.0; // E1.0", Age.EITHER),
        ("x := #s.E1.0 + 2.5E1; (* A1.0\nM2.0 *) y := 'M2.0';", Age.EITHER),
        ("VERSION : '1.0'\nLABEL a; END_LABEL", Age.CLASSIC),
        ("{ Scl_ResetOptions ; Scl_SetOKFlag:= 'n' }\nFUNCTION_BLOCK FB7", Age.CLASSIC),
        ("x := PIB[WORD_TO_DINT(port) + 0];", Age.CLASSIC),
        ("VAR delay : SFB4; END_VAR delay(IN := on);", Age.CLASSIC),
        ("VAR delay : SFB4; END_VAR #delay(IN := #on);", Age.EITHER),
    ],
)
def test_the_age_of_a_text(text: str, age: Age) -> None:
    assert age_of(text.encode()) is age
    assert age_of(text.encode("utf-16")) is age


def test_a_classic_file_is_read_as_such(tmp_path: Path) -> None:
    path = tmp_path / "old.scl"
    path.write_text(_CLASSIC)
    assert read_document(path).dialect == "step7"
    assert read_document(path, "tia").findings != ()


@pytest.mark.parametrize(
    ("texts", "programs"),
    [
        ((_EITHER, _TIA), {"tia": 2}),
        ((_EITHER, _EITHER), {"tia": 2}),
        ((_EITHER, _CLASSIC), {"step7": 2}),
        ((_EITHER, _TIA, _CLASSIC), {"tia": 2, "step7": 1}),
    ],
)
def test_what_can_be_either_goes_with_the_others(
    tmp_path: Path, texts: tuple[str, ...], programs: dict[str, int]
) -> None:
    paths = [tmp_path / f"{number}.scl" for number in range(len(texts))]
    for path, text in zip(paths, texts, strict=True):
        path.write_text(text)
    assert {one.dialect: len(one.paths) for one in programs_of(paths, None)} == programs
