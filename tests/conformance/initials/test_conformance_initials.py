"""Initial values of structures and arrays.

Sources: TIA Portal help, "Declaring local tags" and "Default values"; IEC 61131-3 third edition,
tables 11 and 13: an empty place keeps the default of the type, `n(...)` repeats what is in it.
"""

from collections.abc import Callable
from pathlib import Path

import pytest

from fbgen.diagnostics import DiagnosticError
from fbgen.lang.parser import parse
from fbgen.lang.printer import print_file
from fbgen.source import Source
from harness import LoadedProgram, load_program

Load = Callable[[str], LoadedProgram]

_OF_INNER = {"a": 3, "b": 4}


def _outer(first: dict[str, int], second: int, third: list[int]) -> dict[str, object]:
    return {"first": first, "second": second, "third": third}


_EXPECTED = {
    "empty": _outer(_OF_INNER, 9, [-1] * 10),
    "lone": _outer({"a": 7, "b": 4}, 8, [0] * 10),
    "firstOnly": _outer({"a": 5, "b": 6}, 9, [0] * 10),
    "list": [
        _outer({"a": 1, "b": 2}, 3, [5, 5] + [6] * 8),
        _outer(_OF_INNER, 9, [1, 2] * 5),
        _outer(_OF_INNER, 9, [1, 2] * 5),
    ],
    "grid": [1, 1, 2, 2] * 2,
    "nested": [1, 1, 1, 2] * 2,
    "short": [7, 7, 0, 0],
    "anonymous": {"p": True, "q": [1, 2]},
}


@pytest.mark.parametrize("name", _EXPECTED)
def test_a_variable_starts_with_what_stands_there(load: Load, name: str) -> None:
    assert load("initials.scl").instance("Initials")[name] == _EXPECTED[name]


def test_printed_text_means_the_same(engine_name: str) -> None:
    path = Path(__file__).parent / "initials.scl"
    tree = parse(Source("x.scl", path.read_text(encoding="utf-8")), "tia")
    printed = Source("y.scl", print_file(tree).text)
    block = load_program([printed], engine=engine_name).instance("Initials")
    assert {name: block[name] == _EXPECTED[name] for name in _EXPECTED} == dict.fromkeys(
        _EXPECTED, True
    )


@pytest.mark.parametrize("value", ["[5(1, 2)]", "[9(9(9(1)))]", "[3(3(1))]", "[-1(2)]"])
def test_more_values_than_elements_are_refused(value: str) -> None:
    text = f'FUNCTION_BLOCK "F"\nVAR x : Array[0..7] of Int := {value}; END_VAR\nBEGIN\n;\n'
    with pytest.raises(DiagnosticError) as caught:
        load_program([Source("f.scl", text + "END_FUNCTION_BLOCK\n")])
    assert {one.code for one in caught.value.diagnostics} <= {"FB4057", "FB3001"}
