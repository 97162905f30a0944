"""What CODESYS and TwinCAT add: generic constants, configured variables, texts over two lines."""

from pathlib import Path

import pytest

from fbgen.source import Source
from harness import LoadedProgram, load_program

_HERE = Path(__file__).parent


@pytest.mark.parametrize("dialect", ["iec", "twincat"])
def test_instances_of_a_generic_block_have_their_own_constants(
    dialect: str, engine_name: str
) -> None:
    program = load_program([_HERE / "generic.st"], dialect=dialect, engine=engine_name)
    user = program.instance("User")
    user()
    user()
    assert (user.a, user.b, user.c, user.calls) == (2, 60, 15, 2)


def test_a_generic_block_itself_has_the_values_of_its_declaration(engine_name: str) -> None:
    program = load_program([_HERE / "generic.st"], dialect="twincat", engine=engine_name)
    buffer = program.instance("Buffer")
    buffer()
    assert (buffer.sum, buffer.count) == (2, 2)


def test_a_configuration_gives_values_and_addresses_to_variables(engine_name: str) -> None:
    program = load_program([_HERE / "configured.st"], dialect="iec", engine=engine_name)
    program.start()
    program.run_for(ms=5)
    values = [program.engine.global_value(f"Main.{name}") for name in ("first", "second")]
    assert values == [7, 5]
    assert program.engine.global_value("Main.station.pump.twice") == 120
    assert program.engine.global_value("Main.lamp") is True


def test_codesys_names_the_program_first(engine_name: str) -> None:
    text = (_HERE / "configured.st").read_text(encoding="utf-8")
    blocks = text.partition("CONFIGURATION")[0]
    config = "VAR_CONFIG\nMain.station.pump.speed : INT := 9;\nEND_VAR\n"
    program = load_program([Source("x.st", blocks + config)], "twincat", engine_name)
    program.start()
    program.run_for(ms=5)
    assert program.engine.global_value("Main.station.n") == 18


def _text(program: LoadedProgram) -> object:
    block = program.instance("F")
    block()
    return block.t


@pytest.mark.parametrize("end", ["\n", "\r\n"])
def test_a_text_may_go_on_in_the_next_line(end: str, engine_name: str) -> None:
    text = (
        "FUNCTION_BLOCK F\nVAR_OUTPUT t : STRING; END_VAR\n"
        f"t := 'one{end}two';\nEND_FUNCTION_BLOCK\n"
    )
    program = load_program([Source("x.st", text)], "twincat", engine_name)
    assert _text(program) == f"one{end}two"


def test_members_in_files_of_their_own_belong_to_the_block_of_that_name(
    tmp_path: Path, engine_name: str
) -> None:
    (tmp_path / "Pump").mkdir()
    files = {
        "Pump.st": "FUNCTION_BLOCK Pump\nVAR_OUTPUT n : INT; END_VAR\nStart();\nCount();\n"
        "n := n + Speed;\nEND_FUNCTION_BLOCK\n",
        "Pump.Start.st": "METHOD Start : BOOL\nn := 1;\nStart := TRUE;\nEND_METHOD\n",
        "Pump/Count.st": "ACTION Count:\nn := n + 10;\nEND_ACTION\n",
        "Pump_Speed.prop.st": "PROPERTY Speed : INT\nGET\nSpeed := 100;\nEND_GET\nEND_PROPERTY\n",
    }
    for name, text in files.items():
        (tmp_path / name).write_text(text, encoding="utf-8")
    program = load_program([tmp_path / name for name in files], "twincat", engine_name)
    pump = program.instance("Pump")
    pump()
    assert pump.n == 111


@pytest.mark.parametrize(
    ("start", "expected"),
    [("0", ["Abc", 65, 0, "ab", "Abcd"]), ("UINT#0", ["Abc", 65, 0, "ab", "Abcd"])],
)
def test_a_text_is_made_of_bytes_that_count_from_0(
    start: str, expected: list[object], engine_name: str
) -> None:
    text = (
        "FUNCTION_BLOCK F\nVAR_OUTPUT whole, short, long : STRING(10); END_VAR\n"
        "VAR_OUTPUT first, behind : BYTE; END_VAR\n"
        "VAR i : UINT; END_VAR\n"
        f"whole := 'abc'; i := {start}; whole[i] := whole[i] - 32;\n"
        "first := whole[0]; behind := whole[3];\n"
        "short := 'abc'; short[2] := 0; short[9] := 65;\n"
        "long := whole; long[LEN(long)] := 16#64;\nEND_FUNCTION_BLOCK\n"
    )
    program = load_program([Source("x.st", text)], "twincat", engine_name)
    block = program.instance("F")
    block()
    assert [block.whole, block.first, block.behind, block.short, block.long] == expected


def test_operators_are_functions_too(engine_name: str) -> None:
    text = (
        "FUNCTION_BLOCK F\nVAR_INPUT a, b : BOOL; n : INT; END_VAR\n"
        "VAR_OUTPUT q, r, s : BOOL; m : INT; END_VAR\n"
        "q := AND(a, b, TRUE); r := NOT(OR(a, b)); s := XOR(a, b) AND a; m := MOD(n, 4);\n"
        "END_FUNCTION_BLOCK\n"
    )
    program = load_program([Source("x.st", text)], "iec", engine_name)
    block = program.instance("F")
    block(a=True, b=False, n=7)
    assert (block.q, block.r, block.s, block.m) == (False, False, True, 3)


def test_blocks_tell_their_own_names_and_places(engine_name: str) -> None:
    program = load_program([_HERE / "own_names.st"], dialect="twincat", engine=engine_name)
    teller = program.instance("Teller")
    teller()
    assert (teller.here, teller.asked, teller.told) == ("Teller", "Teller.Ask", "Teller.Title.Get")
    assert (teller.line, teller.place) == ("Line 11 (Decl)", "Line 25, Column 10 (Impl)")


def test_return_with_a_condition_leaves_the_block(engine_name: str) -> None:
    program = load_program([_HERE / "own_names.st"], dialect="twincat", engine=engine_name)
    counter = program.instance("Counter")
    counter(stop=True)
    assert (counter.count, counter.behind) == (1, 0)
    counter(stop=False)
    assert (counter.count, counter.behind) == (22, 1)


def test_a_list_in_a_text_of_its_own_is_named_after_the_file(engine_name: str) -> None:
    lists = [
        Source(f"{name}.st", f"VAR_GLOBAL\n  x : INT := {value};\nEND_VAR\n")
        for name, value in (("GVL", 3), ("Limits", 4))
    ]
    text = "FUNCTION_BLOCK F\nVAR_OUTPUT\n  n : INT;\nEND_VAR\nn := GVL.x * 10 + Limits.x;\n"
    block = Source("f.st", text + "END_FUNCTION_BLOCK\n")
    program = load_program([*lists, block], "twincat", engine_name)
    one = program.instance("F")
    one()
    assert one.n == 34
