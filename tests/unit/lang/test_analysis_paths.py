"""What is set, reached and called on the paths through a block; and what good code does."""

import pytest
from checking import findings_of, in_block

_HEAD = (
    "FUNCTION_BLOCK b\nVAR_INPUT a, c : BOOL; n : INT; END_VAR\n"
    "VAR_OUTPUT y : INT; z : BOOL; END_VAR\n"
    "VAR t1 : TON_TIME; r1 : R_TRIG; s : INT; END_VAR\n"
    "VAR_TEMP t, i : INT; END_VAR\nBEGIN\n"
)
_USE = "#y := #n; #z := #a AND #c; #s := #y; #r1(CLK := #a); #z := #r1.Q;\n"


def codes(statements: str) -> list[str]:
    """The warnings of the flow analysis for these statements in a tia block; not what is unused."""
    text = f"{_HEAD}{statements}\nEND_FUNCTION_BLOCK\n"
    unused = ("FB4101", "FB4201", "FB4202", "FB4203", "FB4205")
    return [one.code for one in findings_of(text, "tia") if one.code not in unused]


@pytest.mark.parametrize(
    "statements",
    [
        "IF #a THEN #t := 1; ELSE #t := 2; END_IF; #y := #t;",
        "IF #a THEN #t := 1; ELSIF #c THEN RETURN; ELSE #t := 3; END_IF; #y := #t;",
        "CASE #n OF 1: #t := 1; ELSE #t := 2; END_CASE; #y := #t;",
        "FOR #i := 0 TO 9 DO #t := #i; END_FOR; #y := #t;",
        "FOR #i := 0 TO 9 DO IF #a THEN #t := 1; EXIT; END_IF; #t := 2; END_FOR; #y := #t;",
        "REPEAT #t := #n; #s := #s + 1; UNTIL #s > 5 END_REPEAT; #y := #t;",
        "WHILE TRUE DO #t := #n; IF #a THEN EXIT; END_IF; #s := #s + 1; END_WHILE; #y := #t;",
        "#t := 1; WHILE #s < #n DO #s := #s + 1; END_WHILE; #y := #t;",
        "IF NOT #a THEN RETURN; END_IF; #t := 1; #y := #t;",
    ],
)
def test_a_temporary_that_every_path_sets_gives_no_warning(statements: str) -> None:
    assert codes(statements) == []


@pytest.mark.parametrize(
    ("statements", "code"),
    [
        ("#y := #t;", "FB4206"),
        ("IF #a THEN #t := 1; END_IF; #y := #t;", "FB4207"),
        ("CASE #n OF 1: #t := 1; END_CASE; #y := #t;", "FB4207"),
        ("FOR #i := 0 TO #n DO #t := #i; END_FOR; #y := #t;", "FB4207"),
        ("WHILE #s < #n DO #t := 1; #s := #s + 1; END_WHILE; #y := #t;", "FB4207"),
        ("FOR #i := 0 TO 9 DO #y := #t; #t := #i; END_FOR;", "FB4207"),
        ("FOR #i := 0 TO 9 DO IF #a THEN EXIT; END_IF; #t := 2; END_FOR; #y := #t;", "FB4207"),
        ("FOR #i := 0 TO 9 DO IF #a THEN CONTINUE; END_IF; #t := 2; END_FOR; #y := #t;", "FB4207"),
        ("#t := #t + 1; #y := #t;", "FB4206"),
    ],
)
def test_a_temporary_that_some_path_leaves_out_is_reported(statements: str, code: str) -> None:
    assert codes(statements) == [code]


def test_each_temporary_is_reported_once() -> None:
    assert codes("#y := #t; #y := #t + #t;") == ["FB4206"]


@pytest.mark.parametrize(
    "statements",
    [
        "RETURN; #y := 1;",
        "IF #a THEN RETURN; ELSE RETURN; END_IF; #y := 1;",
        "FOR #i := 0 TO 9 DO EXIT; #y := 1; END_FOR;",
        "FOR #i := 0 TO 9 DO CONTINUE; #y := 1; END_FOR;",
        "CASE #n OF 1: RETURN; ELSE RETURN; END_CASE; #y := 1; #y := 2;",
    ],
)
def test_what_no_path_reaches_is_reported_once(statements: str) -> None:
    assert codes(statements) == ["FB4210"]


def test_a_case_without_else_goes_on_behind_it() -> None:
    assert codes("CASE #n OF 1: RETURN; 2: RETURN; END_CASE; #y := 1;") == []


@pytest.mark.parametrize(
    ("statements", "expected"),
    [
        ("WHILE TRUE DO #y := 1; END_WHILE;", ["FB4213"]),
        ("REPEAT #y := 1; UNTIL FALSE END_REPEAT;", ["FB4213"]),
        ("WHILE TRUE DO IF #a THEN RETURN; END_IF; END_WHILE;", []),
        ("WHILE #a DO #y := #y + 1; END_WHILE;", ["FB4213"]),
        ("WHILE #y < 5 DO #y := #y + 1; END_WHILE;", []),
        ("WHILE #a DO #y := #y + 1; IF #y > 5 THEN EXIT; END_IF; END_WHILE;", []),
        ("WHILE %I0.0:P DO #y := #y + 1; END_WHILE;", []),
        (
            "WHILE #a DO WHILE TRUE DO EXIT; END_WHILE; END_WHILE;",
            ["FB4213"],
        ),
    ],
)
def test_a_loop_needs_a_way_out(statements: str, expected: list[str]) -> None:
    assert codes(statements) == expected


@pytest.mark.parametrize(
    ("statements", "expected"),
    [
        ("#t1(IN := #a, PT := T#1s);", []),
        ("IF #c THEN #t1(IN := #a, PT := T#1s); END_IF;", ["FB4220"]),
        ("IF #c THEN #t1(IN := #a, PT := T#1s); ELSE #t1(IN := FALSE); END_IF;", []),
        ("#t1(IN := #a, PT := T#1s); #t1(IN := #c, PT := T#1s);", ["FB4221"]),
        ("#t1(IN := FALSE); #t1(IN := #c, PT := T#1s);", []),
        ("#t1(IN := #a, PT := T#1s); #t1(IN := FALSE); #t1(IN := TRUE, PT := T#1s);", []),
        (
            "#t1(IN := #a, PT := T#1s); IF #c THEN #t1(IN := FALSE); END_IF; #t1(IN := #c);",
            ["FB4221"],
        ),
        ("#r1(CLK := #a); #r1(CLK := FALSE); #r1(CLK := #c);", []),
        ("FOR #i := 0 TO 3 DO #t1(IN := #a, PT := T#1s); END_FOR;", ["FB4221"]),
        ("CASE #n OF 1: #t1(IN := #a); 2: #t1(IN := #c); END_CASE;", []),
        ("IF #a THEN #t1(IN := #a); END_IF; #t1(IN := #c);", ["FB4221"]),
        ("#z := #t1.Q;", ["FB4222"]),
    ],
)
def test_a_timer_is_called_once_in_each_cycle(statements: str, expected: list[str]) -> None:
    found = [code for code in codes(statements) if code != "FB4220" or code in expected]
    assert found == expected


@pytest.mark.parametrize(
    ("condition", "warned"),
    [
        ("#u >= 0", True),
        ("#u < 0", True),
        ("0 <= #u", True),
        ("#u > 0", False),
        ("#u <= 65535", True),
        ("#u > 65534", False),
        ("#b = 300", True),
        ("#d >= 0", False),
    ],
)
def test_a_comparison_that_the_type_answers_is_reported(condition: str, warned: bool) -> None:
    text = in_block("u : UINT; b : USINT; d : DINT; x : BOOL;", f"#x := {condition};")
    assert ("FB4231" in [one.code for one in findings_of(text, "tia")]) is warned


@pytest.mark.parametrize(
    ("statements", "warned"),
    [
        ("#x := #r = #q;", True),
        ("#x := #r = 0.0;", False),
        ("#x := #r <> #r;", False),
        ("#x := #r <> #q; #q := #r;", False),
    ],
)
def test_reals_are_compared_exactly_on_purpose_only(statements: str, warned: bool) -> None:
    text = in_block("r, q : REAL; x : BOOL;", statements)
    assert ("FB4230" in [one.code for one in findings_of(text, "tia")]) is warned


@pytest.mark.parametrize(
    ("statements", "expected"),
    [
        ("IF #a THEN GOTO done; END_IF; #t := 1; #y := #t; done: ;", []),
        ("IF #a THEN GOTO done; END_IF; #t := 1; done: #y := #t;", ["FB4207"]),
        ("GOTO done; #y := 1; done: #y := 2;", ["FB4210"]),
        ("#s := 0; again: #s := #s + 1; IF #s < 5 THEN GOTO again; END_IF; #y := #s;", []),
        (
            "IF #a THEN GOTO second; END_IF; #t := 1; first: #y := #t; RETURN;"
            " second: #s := 1; GOTO first;",
            ["FB4207"],
        ),
        ("WHILE TRUE DO IF #a THEN GOTO done; END_IF; END_WHILE; done: #y := 1;", []),
        ("GOTO used; used: #y := 1; spare: #y := 2;", ["FB4208"]),
    ],
)
def test_jumps_are_followed_to_their_labels(statements: str, expected: list[str]) -> None:
    assert codes(statements) == expected


def test_a_named_switch_is_no_constant_condition() -> None:
    text = (
        "FUNCTION_BLOCK b\nVAR CONSTANT DEBUG : BOOL := FALSE; END_VAR\nVAR_OUTPUT y : INT;"
        " END_VAR\nIF #DEBUG THEN #y := 1; END_IF;\nEND_FUNCTION_BLOCK\n"
    )
    assert findings_of(text, "tia") == []


def test_statements_with_errors_hide_what_they_may_have_done() -> None:
    text = (
        "FUNCTION_BLOCK b\nVAR_OUTPUT y, z : INT; END_VAR\nVAR_TEMP t, u : INT; END_VAR\nBEGIN\n"
        '"GET"(x => #t, y => #z);\n#y := #t + #u;\nEND_FUNCTION_BLOCK\n'
    )
    assert [one.code for one in findings_of(text, "tia")] == ["FB4004", "FB4206"]


def test_an_unknown_block_is_one_error_with_all_its_places() -> None:
    text = in_block("y : INT;", '"GET"(1);\n#y := "GET"(#missing);\n"GET"(2);')
    found = findings_of(text, "tia")
    assert [one.code for one in found] == ["FB4004", "FB4001"]
    assert [note.span and note.span.line for note in found[0].notes] == [5, 6]


def test_the_iec_dialects_give_variables_their_defaults() -> None:
    text = (
        "FUNCTION f : INT\nVAR_INPUT a : BOOL; END_VAR\nVAR t : INT; END_VAR\n"
        "IF a THEN\n t := 1;\n f := t;\nEND_IF;\nEND_FUNCTION\n"
    )
    assert findings_of(text) == []


def test_the_time_grows_with_the_size() -> None:
    """Deep and long blocks are followed without recursion over their length."""
    text = in_block("x : INT;", "IF #x > 1 THEN #x := 2; END_IF;\n" * 3000)
    assert findings_of(text, "tia") == []


@pytest.mark.parametrize(
    ("statements", "warned"),
    [
        ("#t(IN := NOT #t.Q, PT := T#1s);\n#x := #t.Q;", True),
        ("#t(IN := #go AND NOT #t.Q, PT := T#1s);", True),
        ("#x := #t.Q;\n#t(IN := NOT #t.Q, PT := T#1s);", False),
        ("#x := #t.Q;\n#t(IN := NOT #x, PT := T#1s);", False),
        ("#t(IN := NOT #u.Q, PT := T#1s);\n#u(IN := #t.Q, PT := T#1s);", False),
    ],
)
def test_a_timer_that_resets_itself_is_warned_of_where_its_end_is_never_seen(
    statements: str, warned: bool
) -> None:
    text = (
        'FUNCTION_BLOCK "F"\nVAR_INPUT go : BOOL; END_VAR\nVAR_OUTPUT x : BOOL; END_VAR\n'
        f"VAR t, u : TON_TIME; END_VAR\nBEGIN\n{statements}\nEND_FUNCTION_BLOCK\n"
    )
    assert ("FB4225" in [one.code for one in findings_of(text, "tia")]) is warned
    plain = text.replace("#", "").replace('"F"', "F").replace("BEGIN\n", "")
    plain = plain.replace("TON_TIME", "TON")
    assert "FB4225" not in [one.code for one in findings_of(plain, "iec")]


_OB = """ORGANIZATION_BLOCK "OB86"
VAR_TEMP
  what : BYTE;
  others : ARRAY[1..{others}] OF BYTE;
  behind : BYTE;
END_VAR
BEGIN
  "seen".x := #what = #behind;
END_ORGANIZATION_BLOCK
DATA_BLOCK "seen"
STRUCT x : BOOL; END_STRUCT;
BEGIN
END_DATA_BLOCK
"""


@pytest.mark.parametrize("dialect", ["tia", "step7"])
@pytest.mark.parametrize(("others", "unset"), [(16, []), (18, ["behind"])])
def test_the_start_information_of_an_organization_block_is_20_bytes(
    dialect: str, others: int, unset: list[str]
) -> None:
    found = findings_of(_OB.replace("{others}", str(others)), dialect)
    assert [one.span.text.strip("#") for one in found if one.span] == unset
    assert {one.code for one in found} <= {"FB4206"}


_FOR_FORM = """FUNCTION Text : BOOL
VAR_INPUT code : INT; END_VAR
VAR_OUTPUT letter : INT; END_VAR
Text := {answer};
letter := code + 1;
END_FUNCTION
FUNCTION_BLOCK Panel
VAR_INPUT code : INT; END_VAR
VAR_OUTPUT letter : INT; END_VAR
VAR unused : BOOL; END_VAR
unused := {called}(code := code, letter => letter);
END_FUNCTION_BLOCK
"""


@pytest.mark.parametrize(
    ("answer", "codes"),
    [
        ("TRUE", []),
        ("code > 0", ["FB4203"]),
        ("FALSE", ["FB4203"]),
        ("TRUE; Text := FALSE", ["FB4203"]),
    ],
)
def test_a_result_that_says_nothing_may_go_nowhere(answer: str, codes: list[str]) -> None:
    text = _FOR_FORM.replace("{answer}", answer).replace("{called}", "Text")
    assert [one.code for one in findings_of(text, "iec")] == codes
    dropped = text.replace("unused := ", "").replace("VAR unused : BOOL; END_VAR\n", "")
    wanted = ["FB4235"] if codes else []
    assert [one.code for one in findings_of(dropped, "twincat")] == wanted
