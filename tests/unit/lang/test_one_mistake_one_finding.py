"""A source with one typical mistake gives one finding, at its place, with the help that fits it."""

import pytest

from fbgen.lang.parser import parse_recovering
from fbgen.source import Source

TEXT = """FUNCTION_BLOCK "Band"
VAR_INPUT
   start : Bool;
   ende : Bool;
END_VAR
VAR
   zeit : TON;
   liste : Array[0..9] of Int;
   i : Int;
END_VAR
BEGIN
   REGION Schritte
      IF #start THEN
         #i := 1;
      ELSIF #ende THEN
         #i := 2;
      END_IF;
      CASE #i OF
         1..3:
            #zeit(IN := #start, PT := T#5s);
         ELSE
            #i := 0;
      END_CASE;
   END_REGION
   FOR #i := 0 TO 9 DO
      #liste[#i] := #i;
   END_FOR;
   WHILE #i > 0 DO
      #i := #i - 1;
   END_WHILE;
   REPEAT
      #i := #i + 1;
   UNTIL #i > 5
   END_REPEAT;
END_FUNCTION_BLOCK

FUNCTION "Zwei" : Int
BEGIN
   #Zwei := 2;
END_FUNCTION
"""

MISTAKES = [
    ("IF #start THEN", "IF #start", 14, "write IF condition THEN"),
    ("IF #start THEN", "IF #start DO", 13, "write IF condition THEN"),
    ("IF #start THEN", "IF #start; THEN", 13, "no ';' stands in front of THEN"),
    ("ELSIF #ende THEN", "ELSIF #ende", 16, "write IF condition THEN"),
    ("CASE #i OF", "CASE #i", 19, "write CASE variable OF"),
    ("0 TO 9 DO", "0 TO 9", 26, "write FOR i := 0 TO 7 DO"),
    ("#i > 0 DO", "#i > 0", 29, "write WHILE condition DO"),
    ("#i > 0 DO", "#i > 0 THEN", 28, "write WHILE condition DO"),
    ("   UNTIL #i > 5\n", "", 33, "write REPEAT ... UNTIL condition END_REPEAT;"),
    ("END_IF;", "END IF;", 17, "write END_IF"),
    ("END_IF;", "ENDIF;", 17, "write END_IF"),
    ("ELSIF #ende", "ELSEIF #ende", 15, "write ELSIF"),
    ("ELSIF #ende", "ELSE IF #ende", 13, "ELSE IF needs an END_IF of its own: write ELSIF"),
    ("WHILE #i", "WHIEL #i", 28, "write WHILE"),
    ("FOR #i", "FRO #i", 25, "write FOR"),
    ("IF #start", "IFF #start", 13, "write IF"),
    ("CASE #i", "CAES #i", 18, "write CASE"),
    ("VAR_INPUT", "VAR_INPT", 2, "write VAR_INPUT"),
    ("VAR\n   zeit", "VAR_CONST\n   zeit", 6, "write VAR CONSTANT"),
    ("#i := 1;", "#i : = 1;", 14, "write := without a blank in it"),
    ("END_FUNCTION_BLOCK", "END_FUNCTION", 35, "write END_FUNCTION_BLOCK"),
    ("      END_IF;\n", "", 13, "write END_IF; where it ends"),
    ("      END_CASE;\n", "", 18, "write END_CASE; where it ends"),
    ("   END_FOR;\n", "", 25, "write END_FOR; where it ends"),
    ("END_FUNCTION_BLOCK\n", "", 1, "write END_FUNCTION_BLOCK where it ends"),
    ("#i := 1;", "#i := 1", 14, "write ';' here"),
    ("#i := 1;", "#i = 1;", 14, "an assignment is written ':=', '=' compares"),
    ("IF #start", "IF #start == TRUE", 13, "one '=' compares"),
    ("T#5s", "5s", 20, "numbers look like"),
    ("Array[0..9]", "Array(0..9)", 8, "an array type looks like"),
    ("start : Bool", "start Bool", 3, "a declaration looks like name : TYPE;"),
    ("ende : Bool;", "ende : Bool", 4, "write ';' here"),
    ("#liste[#i] :=", "#liste[#i :=", 26, "each '[' needs its ']'"),
    ("ende : Bool;\nEND_VAR", "ende : Bool;", 2, "write END_VAR where it ends"),
]


@pytest.mark.parametrize(("right", "wrong", "line", "hint"), MISTAKES)
def test_one_mistake_is_one_finding(right: str, wrong: str, line: int, hint: str) -> None:
    assert right in TEXT
    _, findings = parse_recovering(Source("band.scl", TEXT.replace(right, wrong, 1)), "tia")
    places = [(one.span.line, one.help) for one in findings if one.span is not None]
    assert [place[0] for place in places] == [line]
    assert hint in places[0][1]


def test_the_text_without_a_mistake_is_right() -> None:
    assert parse_recovering(Source("band.scl", TEXT), "tia")[1] == []


def test_two_mistakes_are_two_findings() -> None:
    text = TEXT.replace("IF #start THEN", "IF #start").replace("END_WHILE;", "ENDWHILE;")
    _, findings = parse_recovering(Source("band.scl", text), "tia")
    assert [one.span.line for one in findings if one.span is not None] == [14, 30]
