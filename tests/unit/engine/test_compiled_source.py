"""The generated Python: it can be read, and does nothing that the types rule out."""

import re

import pytest

from fbgen.lang.checked import Assignment, Branch, CaseArm, Statement
from fbgen.source import Source
from harness.engine.compiled import CompiledEngine, Moment, Probe
from harness.engine.environment import StandaloneEnvironment
from harness.engine.loading import read_program

DECLARATIONS = """
VAR_INPUT
    word : WORD; other : WORD; byte : BYTE; flag : BOOL; small : USINT; number : INT; wide : DINT;
END_VAR
VAR_OUTPUT
    outWord : WORD; outFlag : BOOL; outSmall : USINT; outNumber : INT; outWide : DINT;
END_VAR
VAR
    list : ARRAY[0..9] OF INT; table : ARRAY[1..3] OF INT; floating : REAL; i : INT;
    timer : TON; edge : R_TRIG;
END_VAR
"""


def engine_of(text: str, probe: Probe | None = None) -> CompiledEngine:
    program = read_program([Source("source.scl", text)])
    return CompiledEngine(program, StandaloneEnvironment(), probe=probe)


def method(body: str) -> str:
    """The lines of the method that runs the block, without indentation."""
    source = engine_of(
        f'FUNCTION_BLOCK "Block"{DECLARATIONS}BEGIN\n{body}\nEND_FUNCTION_BLOCK\n'
    ).python_source("Block")
    found = re.search(r"def _run\(self\):\n(.*)\Z", source.rstrip(), re.DOTALL)
    assert found is not None
    return "\n".join(line[8:] for line in found[1].split("\n"))


def test_names_stay_as_they_were_declared() -> None:
    assert method("#outNumber := #number;") == "self.outNumber = self.number"


def test_python_keywords_and_odd_characters_get_names_that_work() -> None:
    engine = engine_of(
        """
FUNCTION_BLOCK "Größe 1"
VAR_INPUT "in" : INT; "class" : INT; self : INT; run : INT; "_run" : INT; "ä b" : INT; END_VAR
VAR_OUTPUT "lambda" : INT; END_VAR
VAR_TEMP "def" : INT; "frame" : INT; "len" : INT; END_VAR
BEGIN
    #"def" := #"in" + #"class"; #frame := #"self" + #run; #len := #"_run" + #"ä b";
    #"lambda" := #"def" + #frame + #len;
END_FUNCTION_BLOCK
"""
    )
    block = engine.instance("größe 1")
    block.call({"in": 1, "class": 2, "self": 4, "run": 8, "_run": 16, "Ä b": 32})
    assert block.get("lambda") == 63


def test_bit_strings_are_not_masked() -> None:
    assert method("#outWord := #word AND 16#00FF;") == "self.outWord = self.word & 0xff"
    assert method("#outWord := #word OR #other;") == "self.outWord = self.word | self.other"
    assert method("#outWord := #word XOR #other;") == "self.outWord = self.word ^ self.other"
    assert method("#outWord := SHR(IN := #word, N := 8);") == "self.outWord = self.word >> 8"


def test_not_of_a_bit_string_stays_in_its_width() -> None:
    assert method("#outWord := NOT #word;") == "self.outWord = self.word ^ 0xffff"


def test_a_sum_that_fits_is_not_wrapped() -> None:
    assert method("#outNumber := USINT_TO_INT(#small) + 1;") == "self.outNumber = self.small + 1"
    assert "if self.small + 1 > 255:" in method(
        "IF USINT_TO_INT(#small) + 1 > 255 THEN #outSmall := 0; END_IF;"
    )


def test_a_sum_that_can_leave_its_type_is_wrapped_once() -> None:
    assert method("#outWide := #wide + #wide - #wide * 3;").count("4294967295") == 1


def test_a_condition_can_rule_out_that_a_sum_leaves_its_type() -> None:
    body = method("IF #number < 1000 THEN #number := #number + 1; END_IF;")
    assert "self.number = self.number + 1" in body
    body = method("IF #small >= 255 THEN #small := 1; ELSE #small := #small + 1; END_IF;")
    assert "self.small = self.small + 1" in body
    body = method("IF #number >= 0 AND #number <= 9 THEN #list[#number] := 1; END_IF;")
    assert "self.list[self.number] = 1" in body


def test_what_a_condition_said_is_forgotten_when_the_variable_is_written() -> None:
    for body in (
        "IF #number < 9 THEN #number := #wide_to_int; #number := #number + 1; END_IF;",
        "IF #number < 9 THEN IF #flag THEN #number := #i; END_IF; #number := #number + 1; END_IF;",
        "IF #number < 9 THEN WHILE #flag DO #number := #number + 1; END_WHILE; END_IF;",
        "IF #number < 9 OR #flag THEN #number := #number + 1; END_IF;",
        "IF #number < 9 THEN ; ELSE #number := #number + 1; END_IF;",
        "IF #number < 9 THEN ; END_IF; #number := #number + 1;",
    ):
        assert "32767" in method(body.replace("#wide_to_int", "DINT_TO_INT(#wide)"))


def test_an_index_that_cannot_leave_its_bounds_is_not_checked() -> None:
    assert "list[_1] = _1" in method("FOR #i := 0 TO 9 DO #list[#i] := #i; END_FOR;")
    assert "table[_1 - 1] = 0" in method("FOR #i := 1 TO 3 DO #table[#i] := 0; END_FOR;")
    body = "#list[WORD_TO_INT(#word AND 16#0007)] := 0;"
    assert method(body) == "self.list[self.word & 7] = 0"
    assert method("#list[3] := 0;") == "self.list[3] = 0"


def test_an_index_that_may_be_negative_is_checked() -> None:
    assert "_bad_index(" in method("#list[#number] := 0;")
    assert "_bad_index(" not in method("#list[#small] := 0;")


def test_a_loop_variable_that_the_body_changes_is_no_python_range() -> None:
    body = method("FOR #i := 0 TO 9 DO #i := #i + 1; END_FOR;")
    assert "range(" not in body
    assert "while " in body


def test_passes_are_counted_only_if_the_watchdog_could_bark() -> None:
    assert "passes" not in method("FOR #i := 0 TO 9 DO #list[#i] := #i; END_FOR;")
    assert "_cpu.passes -= 1" in method("WHILE #number > 0 DO #number := 0; END_WHILE;")
    assert "_cpu.passes -= len(" in method("FOR #i := 0 TO #number DO #outNumber := 0; END_FOR;")
    nest = "FOR #i := 1 TO 30_000 DO FOR #number := 1 TO 30_000 DO ; END_FOR; END_FOR;"
    assert method(nest).count("_cpu.passes") == 4


def test_conditions_are_short_circuits_where_nobody_can_tell() -> None:
    assert method("#outFlag := #flag AND #timer.Q;").endswith("self.flag and self.timer._now().Q")


TIMER = "#timer(IN := #flag, PT := T#1s); "


@pytest.mark.parametrize(
    "code",
    [
        "#outFlag := #timer.Q;",
        "#outFlag := #flag; #outFlag := #timer.ET > T#15ms;",
        "IF #timer.Q THEN #outFlag := TRUE; END_IF;",
    ],
)
def test_a_timer_is_not_asked_again_right_behind_its_call(code: str) -> None:
    assert "_now()" not in method(TIMER + code)


@pytest.mark.parametrize(
    "code",
    [
        "#word := %IW0:P; #outFlag := #timer.Q;",
        "%QW0:P := #word; #outFlag := #timer.Q;",
        "#word := PEEK_WORD(area := 16#81, dbNumber := 0, byteOffset := 0); #outFlag := #timer.Q;",
        "IF %I0.0:P THEN #outFlag := #timer.Q; END_IF;",
        "IF %I0.0:P AND #timer.Q THEN ; END_IF;",
        "IF #flag THEN ; END_IF; #outFlag := #timer.Q;",
        "#timer.IN := FALSE; #outFlag := #timer.Q;",
        "WHILE #timer.Q DO ; END_WHILE;",
    ],
)
def test_a_timer_is_asked_again_where_time_may_have_passed_since(code: str) -> None:
    assert "timer._now()" in method(TIMER + code)


def test_both_sides_are_evaluated_where_one_can_stop_the_program() -> None:
    body = method("#outFlag := #flag AND (10 / #number > 1);")
    assert "self.flag & (" in body


def test_a_real_that_is_stored_is_rounded_without_a_call() -> None:
    assert method("#floating := #floating + 1.5;") == (
        "_cell[0] = self.floating + 1.5\nself.floating = _cell[0]"
    )


def test_many_arms_are_found_by_a_table_and_by_halving() -> None:
    arms = " ".join(f"{n}: #outNumber := {n};" for n in range(16))
    body = method(f"CASE #number OF {arms} END_CASE;")
    assert ".get(self.number, 16)" in body
    assert max(len(line) - len(line.lstrip()) for line in body.split("\n")) <= 4 * 6


def test_without_a_probe_nothing_is_counted() -> None:
    assert "count" not in method("#outNumber := #number;")


def test_a_probe_can_count_statements_and_branches() -> None:
    counts: dict[str, int] = {}
    nodes: list[Statement | Branch | CaseArm] = []

    def line(node: Statement | Branch | CaseArm, moment: Moment) -> str:
        is_branch = isinstance(node, Branch | CaseArm)
        if moment is not (Moment.INSIDE if is_branch else Moment.BEFORE):
            return ""
        nodes.append(node)
        return f"count({type(node).__name__!r})"

    def count(kind: str) -> None:
        counts[kind] = counts.get(kind, 0) + 1

    engine = engine_of(
        f"""
FUNCTION_BLOCK "Block"{DECLARATIONS}BEGIN
    IF #flag THEN #outNumber := 1; ELSIF #number > 0 THEN #outNumber := 2; #outWide := 3; END_IF;
    CASE #number OF 1: #outSmall := 1; 2: #outSmall := 2; END_CASE;
END_FUNCTION_BLOCK
""",
        Probe(line, {"count": count}),
    )
    block = engine.instance("Block")
    block.call({"number": 2})
    assert counts == {"If": 1, "Branch": 1, "Assignment": 3, "Case": 1, "CaseArm": 1}
    block.call({"number": 0, "flag": True})
    assert counts == {"If": 2, "Branch": 2, "Assignment": 4, "Case": 2, "CaseArm": 1}
    assert sum(isinstance(node, Assignment) for node in nodes) == 5
