"""From one dialect to another: what is said otherwise, and what is refused by name."""

import pytest
from trees import read

from fbgen.diagnostics import DiagnosticError
from fbgen.lang.checker import check
from fbgen.lang.conversion import convert, way
from fbgen.lang.dialects import DIALECTS
from fbgen.lang.parser import parse
from fbgen.lang.printer import print_generated
from fbgen.source import Source

DECLARATIONS = """\
VAR_INPUT
  go : Bool;
  w : Word;
END_VAR
VAR
  a : Int; b : Int; c : Int;
  part : Byte;
  t : TON_TIME;
END_VAR
VAR CONSTANT
  LAST : DInt := 70;
  MASK : Word := 16#FF;
  HALF : Real := 1;
END_VAR
"""
CLASSIC = """\
FUNCTION_BLOCK Pump
TITLE = 'pump one'
{ S7_m_c := 'true' }
VERSION : '1.2'
VAR_INPUT
  go : BOOL;
END_VAR
CONST
  LAST := 10;
  LONG := L#70000;
END_CONST
VAR
  t : SFB4;
  list : ARRAY[0..LAST] OF INT;
END_VAR
LABEL
  done;
END_LABEL
BEGIN
  t(IN := go, PT := T#5s);   // wait
  IF NOT OK THEN GOTO done; END_IF;
  list[1] := Values.level + PIW4 + WORD_TO_INT(SHR(IN := PEW[8], N := 1));
done: ;
  list[2] := LONG DIV L#2;
END_FUNCTION_BLOCK
DATA_BLOCK Values
STRUCT
  level : INT;
END_STRUCT
BEGIN
END_DATA_BLOCK
"""
STRUCTURED = """\
TYPE Colour : (red, green := 5, blue); END_TYPE
FUNCTION Larger : INT
VAR_INPUT
  first : INT;
  second : INT;
END_VAR
VAR
  offset : INT := 2;
END_VAR
  Larger := MAX(first, second) + offset;
END_FUNCTION
PROGRAM Main
VAR_EXTERNAL
  total : INT;
END_VAR
VAR
  state : Colour := blue;
  lamp AT %QX0.3 : BOOL;
  wait : TON;
  bits : WORD;
END_VAR
  {attribute 'x'}
  wait(IN := bits.3, PT := T#1s);
  lamp S= wait.Q;
  IF state = Colour#green THEN
    total := Larger(total, 3);   (* grow *)
  END_IF;
END_PROGRAM
CONFIGURATION Config0
VAR_GLOBAL
  total : INT := 7;
END_VAR
RESOURCE Res0 ON PLC
  TASK Cycle(INTERVAL := T#10ms, PRIORITY := 0);
  PROGRAM Run WITH Cycle : Main;
END_RESOURCE
END_CONFIGURATION
"""


def converted(text: str, source: str, target: str) -> str:
    """The text in the other dialect, which is read and checked again there."""
    printed = [print_generated(file).text for file in convert([read(text, source)], target)]
    check([parse(Source("again", one), target) for one in printed], target)
    return "\n".join(printed)


def statements(body: str, target: str) -> str:
    """The statements of a block in the other dialect."""
    text = f'FUNCTION_BLOCK "Unit"\n{DECLARATIONS}BEGIN\n{body}\nEND_FUNCTION_BLOCK\n'
    inside = converted(text, "tia", target).partition("BEGIN\n")[2]
    return "\n".join(line[3:] for line in inside.partition("END_FUNC")[0].splitlines())


def refused(text: str, source: str, target: str) -> list[tuple[str, str]]:
    with pytest.raises(DiagnosticError) as problem:
        convert([read(text, source)], target)
    return [(found.code, found.message) for found in problem.value.diagnostics]


@pytest.mark.parametrize(
    ("scl", "classic"),
    [
        ("#a := #b := #c + 1; // why", "b := c + 1;\na := b;   // why"),
        ("#a += #b - 1;", "a := a + (b - 1);"),
        ("REGION first\n#a := 1;\nEND_REGION // end", "// first\na := 1;\n// end"),
        ("#part := #w.%B1;", "part := WORD_TO_BYTE(SHR(IN := w, N := 8) AND WORD#16#00FF);"),
        ("#t(IN := #go, PT := T#5s);", "t(IN := go, PT := T#5s);"),
        ("%QB4:P := #part;", "PQB4 := part;"),
        ("#part := %IB300:P;", "part := PIB300;"),
        ("#a := MAX(IN1 := #a, IN2 := #b);", "a := MAX(IN1 := a, IN2 := b);"),
    ],
)
def test_statements_of_tia_are_said_in_step7(scl: str, classic: str) -> None:
    assert statements(scl, "step7") == classic


@pytest.mark.parametrize(
    ("scl", "classic"),
    [
        ("#w := 16#7001;", "w := W#16#7001;"),
        ("#w := 5;", "w := W#5;"),
        ("#w := 16#01 OR 16#02;", "w := W#16#01 OR W#16#02;"),
        ("#go := (#w AND 16#4000) <> 16#0;", "go := (w AND W#16#4000) <> W#16#0;"),
        ("#go := 16#47 = #part;", "go := B#16#47 = part;"),
        ("#go := SHR(IN := #w, N := 8) = 1;", "go := SHR(IN := w, N := 8) = W#1;"),
        ("#go := BYTE_TO_WORD(#part) > 63;", "go := BYTE_TO_WORD(part) > W#63;"),
        ("%QB4:P := 16#FF;", "PQB4 := B#16#FF;"),
        ("#a := 16#0F;", "a := 16#0F;"),
        (
            "CASE #w OF\n  16#10..16#1F, 16#FFFE, 7: #a := 1;\nEND_CASE;",
            "CASE WORD_TO_INT(w) OF\n   16#10..16#1F, -2, 7:\n      a := 1;\nEND_CASE;",
        ),
        (
            "#a := DPRD_DAT(LADDR := 16#100, RECORD => #w);",
            "a := SFC14(LADDR := W#16#100, RECORD := w);",
        ),
    ],
)
def test_numbers_have_the_type_of_bit_strings_in_step7(scl: str, classic: str) -> None:
    assert statements(scl, "step7") == classic


_MOTOR = """
FUNCTION_BLOCK "Motor"
VERSION : 0.1
   VAR_INPUT
      order : Word;
   END_VAR
   VAR_OUTPUT
      state : Word;
      done : Bool;
   END_VAR
BEGIN
   #state := #order;
   #done := TRUE;
END_FUNCTION_BLOCK

DATA_BLOCK "Motor_DB"
VERSION : 0.1
"Motor"
BEGIN
   order := 16#10;
END_DATA_BLOCK

FUNCTION "Twice" : Word
VERSION : 0.1
   VAR_INPUT
      value : Byte;
   END_VAR
   VAR_OUTPUT
      over : Bool;
   END_VAR
BEGIN
   #over := #value > 16#80;
   #Twice := SHL(IN := BYTE_TO_WORD(#value), N := 1);
END_FUNCTION

FUNCTION_BLOCK "Plant"
VERSION : 0.1
   VAR
      motor : "Motor";
      w : Word;
      ready : Bool;
   END_VAR
BEGIN
   // the first
   #motor(order := 16#1, state => #w, done => #ready);   // local
   "Motor_DB"(order := 16#2, done => #ready);
   #w := "Twice"(value := 16#3, over => #ready);
END_FUNCTION_BLOCK
"""
_PLANT_IN_STEP7 = """\
   // the first
   motor(order := W#16#1);   // local
   w := motor.state;
   ready := motor.done;
   "Motor"."Motor_DB"(order := W#16#2);
   ready := "Motor_DB".done;
   w := "Twice"(value := B#16#3, over := ready);
END_FUNCTION_BLOCK
"""


def test_no_structured_parameter_is_handed_on_in_step7() -> None:
    block = """\
TYPE "Pair" STRUCT a : Int; b : Int; END_STRUCT; END_TYPE
FUNCTION "Sum" : Int
VAR_INPUT pair : "Pair"; END_VAR
VAR_OUTPUT text : String[8]; END_VAR
BEGIN
  #Sum := #pair.a + #pair.b;
  #text := 'sum';
END_FUNCTION
FUNCTION_BLOCK "Outer"
VAR_INPUT given : "Pair"; END_VAR
VAR_IN_OUT
  pairs : Array[0..3] of "Pair"; caption : String[8]; count : Int;
END_VAR
VAR own : "Pair"; END_VAR
BEGIN
  // both
  #count := "Sum"(pair := #pairs[#count], text => #caption);
  #count := "Sum"(pair := #given, text => #caption);
END_FUNCTION_BLOCK
FUNCTION "Around" : Int
VAR_INPUT pair : "Pair"; END_VAR
VAR_TEMP mine : String[8]; copyPair : Int; END_VAR
BEGIN
  #Around := "Sum"(pair := #pair, text => #mine);
END_FUNCTION
"""
    text = converted(block, "tia", "step7")
    assert "   // both\n   copyPair := pairs[count];\n   count := " in text
    assert '"Sum"(pair := copyPair, text := copyText);\n   caption := copyText;\n' in text
    assert 'count := "Sum"(pair := given, text := copyText);' in text
    assert 'copyPair2 := pair;\n   Around := "Sum"(pair := copyPair2, text := mine);' in text
    assert text.count("copyPair :=") == 1


def test_instances_are_called_as_step7_calls_them() -> None:
    classic = converted(_MOTOR, "tia", "step7")
    assert classic.endswith(_PLANT_IN_STEP7)
    assert "   order := W#16#10;\nEND_DATA_BLOCK" in classic


def test_calls_of_step7_become_those_of_tia() -> None:
    back = converted(converted(_MOTOR, "tia", "step7"), "step7", "tia")
    assert '   "Motor_DB"(order := W#16#2);\n' in back
    assert '   #w := "Twice"(value := B#16#3, over => #ready);\n' in back


def test_a_data_type_of_step7_has_no_header() -> None:
    text = 'TYPE "Pair"\nTITLE = Two\nVERSION : 0.1\nSTRUCT\na : Int;\nEND_STRUCT;\nEND_TYPE\n'
    assert converted(text, "tia", "step7").splitlines()[:2] == ["// Two", 'TYPE "Pair"']


def test_constants_have_the_type_of_their_value_in_step7() -> None:
    text = f'FUNCTION_BLOCK "Unit"\n{DECLARATIONS}BEGIN\n;\nEND_FUNCTION_BLOCK\n'
    printed = converted(text, "tia", "step7")
    inside = printed.partition("CONST\n")[2].partition("   END_CONST")[0]
    assert inside.splitlines() == [
        "      LAST := L#70;",
        "      MASK := W#16#FF;",
        "      HALF := 1.0;",
    ]


def test_the_header_is_what_step7_takes() -> None:
    text = (
        "FUNCTION_BLOCK \"Unit\"\nTITLE = Unit of the plant\n{ S7_Optimized_Access := 'TRUE' }\n"
        f"AUTHOR : somebody_long\nVERSION : 0.1\n{DECLARATIONS}BEGIN\n;\nEND_FUNCTION_BLOCK\n"
    )
    assert converted(text, "tia", "step7").splitlines()[1:4] == [
        "TITLE = 'Unit of the plant'",
        "AUTHOR : somebody",
        "VERSION : '0.1'",
    ]


@pytest.mark.parametrize(
    ("declaration", "code", "message"),
    [
        ("u : UInt;", "FB3052", "the type UInt is none of dialect step7"),
        ("s : WString;", "FB3052", "the type WSTRING is none of dialect step7"),
        ("r : REF_TO Int;", "FB3051", "REF_TO has no counterpart in dialect step7"),
        ("e : R_TRIG;", "FB3051", "the block R_TRIG has no counterpart in dialect step7"),
        (
            "a_name_that_is_much_too_long : Int;",
            "FB3050",
            "the name 'a_name_that_is_much_too_long' is longer than 24 characters",
        ),
        ("M4 : Int;", "FB3050", "the name 'M4' is none that STEP 7 takes without quotes"),
        ('"two words" : Int;', "FB3050", "the name 'two words' is none that STEP 7 takes"),
    ],
)
def test_what_step7_cannot_say_is_refused_by_name(
    declaration: str, code: str, message: str
) -> None:
    text = f'FUNCTION_BLOCK "U"\nVAR\n{declaration}\nEND_VAR\nBEGIN\n;\nEND_FUNCTION_BLOCK\n'
    ((found, said),) = refused(text, "tia", "step7")
    assert found == code
    assert said.startswith(message)


def test_all_refusals_come_together() -> None:
    text = (
        'FUNCTION_BLOCK "U"\nVAR\na : UInt;\nb : LReal;\nEND_VAR\nBEGIN\n"tag":P := 1;\n'
        "END_FUNCTION_BLOCK\n"
    )
    assert [code for code, _ in refused(text, "tia", "step7")] == ["FB3052", "FB3052", "FB3051"]


def test_classic_text_becomes_that_of_tia() -> None:
    assert print_generated(convert([read(CLASSIC, "step7")], "tia")[0]).text == (
        'FUNCTION_BLOCK "Pump"\n'
        "TITLE = 'pump one'\n"
        "VERSION : 1.2\n"
        "   VAR_INPUT\n      go : BOOL;\n   END_VAR\n"
        "   VAR CONSTANT\n      LAST : Int := 10;\n      LONG : Dint := L#70000;\n   END_VAR\n"
        "   VAR\n      t : TON_TIME;\n      list : ARRAY[0..#LAST] OF INT;\n   END_VAR\n"
        "\nBEGIN\n"
        "   #t(IN := #go, PT := T#5s);   // wait\n"
        "   IF NOT ENO THEN\n      GOTO done;\n   END_IF;\n"
        '   #list[1] := "Values".level + %IW4:P'
        " + WORD_TO_INT(SHR(IN := %IW8:P, N := 1));\n"
        "   done:\n"
        "   #list[2] := #LONG DIV L#2;\n"
        "END_FUNCTION_BLOCK\n"
        '\nDATA_BLOCK "Values"\n   STRUCT\n      level : INT;\n   END_STRUCT;\n'
        "\nBEGIN\nEND_DATA_BLOCK\n"
    )


OVERLAID = """FUNCTION COPY : INT
VAR_INPUT from_db : INT; END_VAR
VAR_OUTPUT length : INT; END_VAR
VAR_TEMP
  source : ANY;
  view AT source : ARRAY[0..9] OF BYTE;
  target : WORD;
END_VAR
length := from_db;
COPY := SFC20(SRCBLK := source, DSTBLK := target);
END_FUNCTION

FUNCTION TWICE : VOID
VAR_TEMP length : INT; first : INT; END_VAR
first := COPY(from_db := 3, length := length);
END_FUNCTION
"""


def test_outputs_get_arrows_and_numbered_instructions_their_names_in_tia() -> None:
    text = print_generated(convert([read(OVERLAID, "step7")], "tia")[0]).text
    assert "      view AT source : ARRAY[0..9] OF BYTE;\n" in text
    assert "#COPY := BLKMOV(SRCBLK := #source, DSTBLK => #target);\n" in text
    assert '#first := "COPY"(from_db := 3, length => #length);\n' in text


def test_structured_text_becomes_that_of_tia() -> None:
    printed = converted(STRUCTURED, "iec", "tia")
    assert 'FUNCTION "Larger" : INT' in printed
    assert (
        "BEGIN\n   #offset := 2;\n   #Larger := MAX(IN1 := #first, IN2 := #second) + #offset;\n"
    ) in printed
    assert 'FUNCTION_BLOCK "Main"' in printed
    assert "state : Int := 6;" in printed
    assert "   // {attribute 'x'}\n   #wait(IN := #bits.%X3, PT := T#1s);\n" in printed
    assert "   IF #wait.Q THEN\n      %Q0.3 := TRUE;\n   END_IF;\n" in printed
    assert (
        "   IF #state = 5 THEN\n"
        '      "Globals".total := "Larger"(first := "Globals".total, second := 3);   (* grow *)\n'
    ) in printed
    assert "total : INT := 7;" in printed
    assert 'DATA_BLOCK "Main_DB"\n' in printed
    assert 'ORGANIZATION_BLOCK "OB1"\n\nBEGIN\n   "Main_DB"();\nEND_ORGANIZATION_BLOCK' in printed


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("FUNCTION_BLOCK A EXTENDS B\nEND_FUNCTION_BLOCK", "EXTENDS of A"),
        ("FUNCTION_BLOCK A\nMETHOD m : INT\nEND_METHOD\nEND_FUNCTION_BLOCK", "METHOD of A"),
        ("INTERFACE I\nEND_INTERFACE", "INTERFACE"),
        ("FUNCTION_BLOCK A\nVAR p : REF_TO INT; END_VAR\nEND_FUNCTION_BLOCK", "REF_TO"),
        ("PROGRAM A\nVAR w AT %MW4 : WORD; x : WORD; END_VAR\nx := w;\nEND_PROGRAM", "%MW4"),
    ],
)
def test_what_tia_cannot_say_is_refused_by_name(text: str, message: str) -> None:
    (found, *_) = refused(text, "iec", "tia")
    assert found == ("FB3051", f"{message} has no counterpart in dialect tia")


def test_types_that_are_no_structures_are_written_out_where_they_are_used() -> None:
    text = (
        "TYPE Level : INT (10..100); END_TYPE\nTYPE Speed : REAL := 1.5; END_TYPE\n"
        "TYPE Mode : (off := 3, on); END_TYPE\n"
        "FUNCTION_BLOCK A\nVAR a : Level; b : Speed; c : Mode; d : (red, green) := green;\n"
        "END_VAR\nc := on;\nIF d = red THEN a := 20; END_IF;\nEND_FUNCTION_BLOCK\n"
    )
    printed = converted(text, "iec", "tia")
    inside = [line.strip() for line in printed.partition("VAR\n")[2].splitlines()]
    assert inside[:4] == ["a : INT := 10;", "b : REAL := 1.5;", "c : Int := 3;", "d : Int := 1;"]
    assert "#c := 4;" in inside
    assert "IF #d = 0 THEN" in inside
    assert "TYPE" not in printed


def test_a_name_of_two_enumerations_is_refused() -> None:
    text = (
        "TYPE A : (red, green); END_TYPE\nTYPE B : (off, red); END_TYPE\n"
        "FUNCTION_BLOCK F\nVAR a : A; b : B; END_VAR\na := A#red;\nb := red;\n"
        "END_FUNCTION_BLOCK\n"
    )
    ((_, message),) = refused(text, "iec", "tia")
    assert message == "the name red of several enumerations has no counterpart in dialect tia"


def test_a_block_that_changes_its_input_is_refused_by_iec() -> None:
    text = (
        'FUNCTION_BLOCK "F"\nVAR_INPUT\n  value : Int;\nEND_VAR\nBEGIN\n#value := 0;\n'
        "END_FUNCTION_BLOCK\n"
    )
    ((code, message),) = refused(text, "tia", "iec")
    assert code == "FB3051"
    assert message.startswith("an assignment to the input value")
    assert "value := 0;" in converted(text, "tia", "twincat")


def test_twincat_reaches_globals_everywhere_and_needs_no_configuration() -> None:
    text = (
        'DATA_BLOCK "Plant"\nSTRUCT\n  count : Int;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n'
        'FUNCTION "Count" : Void\nBEGIN\nWHILE TRUE DO\n  IF "Plant".count > 3 THEN EXIT; END_IF;\n'
        '  "Plant".count += 1;\n  CONTINUE;\nEND_WHILE;\nEND_FUNCTION\n'
    )
    printed = converted(text, "tia", "twincat")
    assert "VAR_GLOBAL\n    Plant : Plant_TYPE := ();" not in printed
    assert "VAR_GLOBAL\n    Plant : Plant_TYPE;\nEND_VAR" in printed
    assert "FUNCTION Count : BOOL\n" in printed
    assert "CONTINUE;" in printed
    assert "CONFIGURATION" not in printed
    assert "VAR_EXTERNAL" not in printed


def test_every_dialect_reaches_every_other_one() -> None:
    for source in DIALECTS:
        for target in DIALECTS:
            assert way(source, target)[-1:] == (target,), f"{source} to {target}"


def test_files_of_different_dialects_are_not_one_program() -> None:
    files = [read("", "tia"), read("", "iec")]
    with pytest.raises(DiagnosticError) as problem:
        convert(files, "step7")
    assert problem.value.diagnostics[0].code == "FB3054"


def test_a_tree_comes_back_itself_where_there_is_nothing_to_convert() -> None:
    file = read(CLASSIC, "step7")
    assert convert([file], "step7") == [file]
