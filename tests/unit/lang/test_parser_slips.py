"""Help for what is written as in another language."""

import pytest

from fbgen.lang.parser import parse_recovering
from fbgen.source import Source

SLIPS = {
    "IF #a == 1 THEN #x := 1; END_IF;": "one '=' compares",
    "IF #a =< 1 THEN #x := 1; END_IF;": "write <=",
    "IF #a => 1 THEN #x := 1; END_IF;": "write >=",
    "IF #a >< 1 THEN #x := 1; END_IF;": "<>",
    "IF #a && #b THEN #x := 1; END_IF;": "AND",
    "IF #a || #b THEN #x := 1; END_IF;": "OR",
    "IF #a != #b THEN #x := 1; END_IF;": "<>",
    "#x := !#a;": "NOT",
    "#x := ~#a;": "NOT",
    "#x++;": "x := x + 1",
    "#x--;": "x := x - 1",
    "IF #a THEN #x := 1; ELSEIF #b THEN #x := 2; END_IF;": "write ELSIF",
    "IF #a THEN #x := 1; ELIF #b THEN #x := 2; END_IF;": "write ELSIF",
    "IF #a THEN #x := 1; ENDIF;": "write END_IF",
    "FOR #i := 1 TO 3 DO #x := 1; ENDFOR;": "write END_FOR",
    "IF #a THEN #x := 1; END IF;": "write END_IF",
    "IF #a := 1 THEN #x := 1; END_IF;": "written '='",
    "WHILE #a := 1 DO #x := 1; END_WHILE;": "written '='",
    "#r := 1,5;": "decimal sign",
    "FOR #i := 1 TO 10 STEP 2 DO #x := 1; END_FOR;": "BY",
    "RETURN #x;": "name of the function",
    "#s := 'it's';": "$'",
}


@pytest.mark.parametrize(("statement", "advice"), SLIPS.items())
def test_a_slip_gets_help_that_fits(statement: str, advice: str) -> None:
    text = f'FUNCTION_BLOCK "B"\nBEGIN\n{statement}\nEND_FUNCTION_BLOCK\n'
    _, findings = parse_recovering(Source("b.scl", text), "tia")
    assert findings
    assert findings[0].span is not None
    assert findings[0].span.line == 3
    assert advice in findings[0].help


def test_an_initial_value_behind_an_equals_sign_gets_help() -> None:
    text = 'FUNCTION_BLOCK "B"\nVAR\n  x : Int = 5;\nEND_VAR\nBEGIN\nEND_FUNCTION_BLOCK\n'
    _, (found,) = parse_recovering(Source("b.scl", text), "tia")
    assert "':='" in found.help


def test_a_comma_between_arguments_is_no_decimal_sign() -> None:
    text = 'FUNCTION_BLOCK "B"\nBEGIN\n#x := MAX(1, , 2);\nEND_FUNCTION_BLOCK\n'
    _, findings = parse_recovering(Source("b.scl", text), "tia")
    assert all("decimal" not in found.help for found in findings)
