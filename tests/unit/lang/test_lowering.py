"""Canonical SCL to IEC text."""

from pathlib import Path

import pytest
from trees import read

from fbgen.diagnostics import DiagnosticError
from fbgen.lang import ast
from fbgen.lang.lowering import Schedule, lower, lower_files
from fbgen.lang.parser import parse
from fbgen.lang.printer import print_generated
from fbgen.source import Source

_PLANT = Path(__file__).parent / "samples" / "plant.scl"


def iec(text: str) -> str:
    """The IEC text of SCL, which is read again to show that it is IEC."""
    printed = print_generated(lower(read(text), "iec")).text
    assert print_generated(parse(Source("again", printed), "iec")).text == printed
    return printed


def statements(text: str, declarations: str = "") -> str:
    """The statements of a block in IEC."""
    printed = iec(
        f'FUNCTION_BLOCK "Unit"\nVAR_TEMP\n w : Word; d : DWord; x : Int; b : Bool; y : Byte;\n'
        f"{declarations}END_VAR\nBEGIN\n{text}\nEND_FUNCTION_BLOCK"
    )
    inside = printed.partition("END_VAR\n")[2].partition("END_FUNCTION_BLOCK")[0]
    return "\n".join(line[4:] for line in inside.splitlines())


def refused(text: str) -> list[tuple[str, str]]:
    with pytest.raises(DiagnosticError) as problem:
        lower(read(text), "iec")
    return [(found.code, found.message) for found in problem.value.diagnostics]


@pytest.mark.parametrize(
    ("scl", "st"),
    [
        ("#x += 2;", "x := x + 2;"),
        ("#x -= #x + 1;", "x := x - (x + 1);"),
        ("#x := #x DIV 2;", "x := x / 2;"),
        ("#x := -#x ** 2;", "x := -(x ** 2);"),
        ("#b := #b & #b;", "b := b AND b;"),
        ("#w := W#16#ff;", "w := WORD#16#FF;"),
        ("#b := #w.%X3;", "b := ((w AND WORD#16#0008) <> WORD#16#0000);"),
        ("#y := #w.%B0;", "y := WORD_TO_BYTE(w AND WORD#16#00FF);"),
        ("#y := #w.%B1;", "y := WORD_TO_BYTE(SHR(w, 8) AND WORD#16#00FF);"),
        ("#w := #d.%W1;", "w := DWORD_TO_WORD(SHR(d, 16) AND DWORD#16#0000FFFF);"),
        ("#w.%X0 := TRUE;", "w := w OR WORD#16#0001;"),
        ("#w.%X0 := FALSE;", "w := w AND WORD#16#FFFE;"),
        ("#w.%X15 := #b;", "w := SEL(b, w AND WORD#16#7FFF, w OR WORD#16#8000);"),
        ("#w.%B1 := #y;", "w := w AND WORD#16#00FF OR SHL(BYTE_TO_WORD(y), 8);"),
        ("#w.%B0 := 16#12;", "w := w AND WORD#16#FF00 OR BYTE_TO_WORD(BYTE#16#12);"),
        ("#b := #x.%X0;", "b := ((INT_TO_WORD(x) AND WORD#16#0001) <> WORD#16#0000);"),
        (
            "#x.%X0 := TRUE;",
            "x := WORD_TO_INT(INT_TO_WORD(x) OR WORD#16#0001);",
        ),
        ("// why\n#x := 1; // so", "(* why *)\nx := 1;   (* so *)"),
        ("REGION a *) b\n#x := 1;\nEND_REGION // c", "(* a * ) b *)\nx := 1;\n(* c *)"),
        ("REGION empty\nEND_REGION\n;\n#x := 1;", "(* empty *)\nx := 1;"),
        ("IF #b THEN ; END_IF;", "IF b THEN\n    ;\nEND_IF;"),
        ("IF #b THEN REGION r\nEND_REGION\nEND_IF;", "IF b THEN\n    (* r *)\n    ;\nEND_IF;"),
        ("#x := ROUND(1.5);", "x := REAL_TO_DINT(1.5);"),
    ],
)
def test_statements_are_said_in_iec(scl: str, st: str) -> None:
    assert statements(scl) == st


def test_constants_become_literals_where_iec_wants_them() -> None:
    printed = iec(
        'FUNCTION_BLOCK "Unit"\nVAR\n a : Array[0..#MAX] of Byte; s : String[#MAX];\n x : Int;\n'
        "END_VAR\nVAR CONSTANT\n MAX : Int := #HALF * 2 + 1;\n HALF : Int := 3;\nEND_VAR\nBEGIN\n"
        "CASE #x OF #MAX: #x := #MAX; #HALF..#MAX - 1: ; END_CASE;\nEND_FUNCTION_BLOCK"
    )
    assert "ARRAY[0..7] OF BYTE" in printed
    assert "STRING[7]" in printed
    assert "        7:\n            x := MAX;\n        3..6:\n" in printed


@pytest.mark.parametrize(
    ("scl", "st"),
    [
        ("T#1S_500MS", "T#1s500ms"),
        ("TIME#-90m", "T#-1h30m"),
        ("T#0s", "T#0ms"),
    ],
)
def test_durations_are_spelled_plainly(scl: str, st: str) -> None:
    assert statements(f"#t := {scl};", " t : Time;\n") == f"t := {st};"


def test_a_plant_comes_out_in_an_order_that_compiles() -> None:
    text = iec(_PLANT.read_text(encoding="utf-8"))
    order = [
        line.split(" : ")[0].removeprefix("    ")
        for line in text.splitlines()
        if line.startswith(("FUNCTION", "PROGRAM", "CONFIGURATION")) or line.endswith(" : STRUCT")
    ]
    assert order == [
        "typeA",
        "typeB_n",
        "typeB",
        "Own_TYPE",
        "FUNCTION Void",
        "FUNCTION WithResult",
        "FUNCTION_BLOCK Inner",
        "FUNCTION_BLOCK Outer",
        "PROGRAM Main",
        "CONFIGURATION Config0",
    ]


def test_data_blocks_become_globals_and_their_users_say_so() -> None:
    text = iec(_PLANT.read_text(encoding="utf-8"))
    assert "        Outer_DB : Outer := (go := TRUE);\n" in text
    assert "        PlantDB : typeB := (n := (x := 3), a := (w := 16#5));\n" in text
    program = text.partition("PROGRAM Main\n")[2].partition("END_PROGRAM")[0]
    assert program == (
        "    VAR_EXTERNAL\n        Outer_DB : Outer;\n        PlantDB : typeB;\n    END_VAR\n"
        "    (* call *)\n    Outer_DB(go := TRUE, b := PlantDB);\n"
    )


def test_bits_and_bytes_at_addresses_become_located_globals() -> None:
    text = iec(_PLANT.read_text(encoding="utf-8"))
    assert "        IB256 AT %IB256 : BYTE;\n" in text
    assert "        IX0_3 AT %IX0.3 : BOOL;\n" in text
    assert "    QB260 := IB256;\n" in text


def test_a_function_without_result_returns_true_and_its_callers_take_it() -> None:
    text = iec(_PLANT.read_text(encoding="utf-8"))
    assert "FUNCTION Void : BOOL\n" in text
    assert "    Void := TRUE;\n" in text
    assert "    unusedBOOL := Void(p := 1);\n" in text
    assert "    unusedINT := WithResult(1);\n" in text


def test_the_schedule_is_what_the_plant_says() -> None:
    schedule = Schedule(interval_ns=2_500_000, task="Fast")
    file = lower_files([read(_PLANT.read_text(encoding="utf-8"))], "iec", schedule)
    text = print_generated(file).text
    assert "TASK Fast(INTERVAL := T#2ms500us, PRIORITY := 0);" in text
    assert "PROGRAM instMain WITH Fast : Main;" in text


def test_headers_become_comments_and_attributes_go() -> None:
    text = iec(
        "// about\nFUNCTION_BLOCK \"Unit\"\nTITLE = a *) b\n{ S7_Optimized_Access := 'TRUE' }\n"
        "AUTHOR : me\nBEGIN\n;\nEND_FUNCTION_BLOCK"
    )
    assert text == (
        "(* about *)\n(* TITLE: a * ) b *)\n(* AUTHOR: me *)\nFUNCTION_BLOCK Unit\n    ;\n"
        "END_FUNCTION_BLOCK\n"
    )


def test_several_files_are_lowered_together() -> None:
    user = read('FUNCTION_BLOCK "A"\nVAR\n b : "B1";\nEND_VAR\nBEGIN\n#b();\nEND_FUNCTION_BLOCK')
    used = read('FUNCTION_BLOCK "B1"\nBEGIN\n;\nEND_FUNCTION_BLOCK')
    units = lower_files([user, used], "iec").units
    assert [unit.name.name for unit in units if isinstance(unit, ast.Block)] == ["B1", "A"]


_BLOCK = (
    'FUNCTION_BLOCK "Unit"\nVAR\n x : Int;\n w : Word;\n{0}END_VAR\nBEGIN\n{1}\nEND_FUNCTION_BLOCK'
)


@pytest.mark.parametrize(
    ("declarations", "text", "named"),
    [
        ("", "#x := DPRD_DAT(LADDR := 1, RECORD => #w);", "DPRD_DAT"),
        ("", "#w := %IW4;", "%IW4"),
        ("", "%QB4:P := 1;", "%QB4:P"),
        ("", "#w := %DB1.DBW2;", "%DB1.DBW2"),
        ("", "GOTO a;\na: ;", "GOTO"),
        ("", "FOR #x := 1 TO 2 DO CONTINUE; END_FOR;", "CONTINUE"),
        (" v AT w : Array[0..1] of Byte;\n", ";", "v AT w"),
        ("", "#w.%D0 := 1;", "%D0"),
        ("", '#x := "Tag";', "Tag"),
        ("", "#x := S5T#5s;", "S5T#5s"),
        (" n : Array[*] of Int;\n", ";", "ARRAY[*]"),
    ],
)
def test_what_iec_cannot_say_is_refused_by_name(declarations: str, text: str, named: str) -> None:
    ((code, message),) = refused(_BLOCK.format(declarations, text))
    assert code == "FB3051"
    assert named in message


@pytest.mark.parametrize("name", ["x_", "_x", "x__y", "größe", "x y", "task", "9x"])
def test_names_that_iec_does_not_take_are_refused(name: str) -> None:
    ((code, message),) = refused(_BLOCK.format(f' "{name}" : Int;\n', ";"))
    assert (code, name in message) == ("FB3050", True)


def test_a_variable_named_like_a_block_is_refused() -> None:
    ((code, _),) = refused(_BLOCK.format(" unit : Bool;\n", ";"))
    assert code == "FB3050"


def test_a_program_cannot_be_called() -> None:
    text = _PLANT.read_text(encoding="utf-8")
    call = 'ORGANIZATION_BLOCK "OB1"\nBEGIN\n"Main"();\nEND_ORGANIZATION_BLOCK'
    ((code, message),) = refused(text + call)
    assert (code, "Main" in message) == ("FB3053", True)


def test_other_directions_are_refused() -> None:
    with pytest.raises(DiagnosticError) as problem:
        lower(read("PROGRAM p ; END_PROGRAM", "iec"), "tia")
    assert [found.code for found in problem.value.diagnostics] == ["FB3054"]


def test_the_same_dialect_needs_no_lowering() -> None:
    file = read("PROGRAM p ; END_PROGRAM", "iec")
    assert lower(file, "iec") is file
