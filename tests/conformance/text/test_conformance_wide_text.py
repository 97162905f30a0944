"""WSTRING and WCHAR: 16 bits a character, and what becomes of them in 8 bits.

Sources: TIA Portal help, "WSTRING", "Explicit conversion of WSTRING" and "of WCHAR": characters
above 255 have no place in a STRING. IEC 61131-3 third edition, tables 26 and 34.
"""

from collections.abc import Callable

import pytest

from fbgen.diagnostics import DiagnosticError
from fbgen.source import Source
from harness import LoadedProgram, load_program

Load = Callable[[str], LoadedProgram]

_LAMBDA = chr(0x3BB)
_E_ACUTE = chr(0xE9)
_EXPECTED = {
    "widened": "ab",
    "narrowed": f"a?b{_E_ACUTE}",
    "widenedChar": "A",
    "narrowedChar": "?",
    "ofChar": _LAMBDA,
    "codeOfWide": 0x3BB,
    "wideOfCode": _LAMBDA,
    "size": 4,
    "joined": f"a{_LAMBDA}b{_E_ACUTE}!",
    "found": 3,
    "equal": False,
    "number": "955",
    "back": 955,
}


@pytest.mark.parametrize("output", _EXPECTED)
def test_wide_text(load: Load, output: str) -> None:
    block = load("wide.scl").instance("Wide")
    block(text="ab", wide=f"a{_LAMBDA}b{_E_ACUTE}", wchar=_LAMBDA, code=0x3BB)
    assert block[output] == _EXPECTED[output]


@pytest.mark.parametrize(
    ("target", "source"),
    [
        ("String", "WString"),
        ("WString", "String"),
        ("Char", "WChar"),
        ("WChar", "Char"),
        ("WString", "Char"),
        ("String", "WChar"),
    ],
)
def test_wide_and_narrow_text_do_not_mix_by_themselves(target: str, source: str) -> None:
    text = (
        f'FUNCTION_BLOCK "F"\nVAR x : {target}; y : {source}; END_VAR\nBEGIN\n  #x := #y;\n'
        "END_FUNCTION_BLOCK\n"
    )
    with pytest.raises(DiagnosticError) as caught:
        load_program([Source("f.scl", text)])
    assert {one.code for one in caught.value.diagnostics} <= {"FB4010", "FB4011"}
