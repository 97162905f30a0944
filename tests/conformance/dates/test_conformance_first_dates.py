"""On which day the dates begin, what they count, and that `convert` moves them as dates.

TIA Portal help, "DATE": days since 1990-01-01, up to 2169-06-06; "DT": 1990 to 2089. CODESYS help
and TwinCAT 3 help, "Date and time data types": DATE and DATE_AND_TIME are seconds since 1970-01-01
in 32 bits, up to DT#2106-02-07-06:28:15; LDATE and LDT are nanoseconds in 64 bits.
"""

import pytest

from fbgen.diagnostics import DiagnosticError
from fbgen.lang.conversion import convert
from fbgen.lang.parser import parse
from fbgen.lang.printer import print_generated
from fbgen.source import Source
from harness import LoadedProgram, load_program
from harness.engine.interface import Value
from harness.engine.retentive import restore_retentive, retentive_values

PC = ("iec", "twincat")
DAY = 86_400


def run(text: str, dialect: str, engine: str) -> LoadedProgram:
    return load_program([Source("f.st", text)], dialect, engine=engine)


def value(kind: str, expression: str, dialect: str, engine: str) -> Value:
    mark = "#" if dialect == "tia" else ""
    text = (
        f"FUNCTION_BLOCK F\nVAR_OUTPUT y : {kind}; END_VAR\nVAR\n"
        "  d : DATE := D#2024-02-29;\n  dt1 : DT := DT#2024-02-29-12:30:15;\n"
        "  tod1 : TOD := TOD#12:30:15.250;\nEND_VAR\n"
        f"{mark}y := {expression};\nEND_FUNCTION_BLOCK\n"
    )
    block = run(text, dialect, engine).instance("F")
    block()
    return block.y


@pytest.mark.parametrize("dialect", PC)
@pytest.mark.parametrize(
    ("kind", "expression", "expected"),
    [
        ("UDINT", "DATE_TO_UDINT(D#1970-01-01)", 0),
        ("UDINT", "DATE_TO_UDINT(D#1970-01-02)", DAY),
        ("DWORD", "DATE_TO_DWORD(d)", 19_782 * DAY),
        ("UDINT", "DT_TO_UDINT(DT#1970-01-01-00:00:01)", 1),
        ("DWORD", "DT_TO_DWORD(DT#2106-02-07-06:28:15)", 0xFFFF_FFFF),
        ("UDINT", "DT_TO_UDINT(dt1)", 19_782 * DAY + 45_015),
        ("STRING", "DATE_TO_STRING(UDINT_TO_DATE(DATE_TO_UDINT(d) + 86400))", "D#2024-03-01"),
        ("STRING", "DT_TO_STRING(DWORD_TO_DT(16#FFFFFFFF))", "DT#2106-02-07-06:28:15"),
        ("STRING", "DT_TO_STRING(dt1 + T#1m)", "DT#2024-02-29-12:31:15"),
        ("STRING", "DT_TO_STRING(dt1 - T#1s999ms)", "DT#2024-02-29-12:30:14"),
        ("STRING", "DATE_TO_STRING(DT_TO_DATE(dt1))", "D#2024-02-29"),
        ("STRING", "DT_TO_STRING(DATE_TO_DT(d))", "DT#2024-02-29-00:00:00"),
        ("STRING", "DT_TO_STRING(CONCAT_DATE_TOD(d, tod1))", "DT#2024-02-29-12:30:15"),
        ("STRING", "TOD_TO_STRING(DT_TO_TOD(dt1))", "TOD#12:30:15"),
        ("STRING", "DATE_TO_STRING(CONCAT_DATE(1970, 1, 2))", "D#1970-01-02"),
        ("TIME", "d - D#2024-02-28", DAY * 1000),
        ("TIME", "dt1 - DT#2024-02-29-12:30:14", 1_000),
        ("USINT", "DAY_OF_WEEK(D#1970-01-01)", 4),
        ("USINT", "DAY_OF_WEEK(dt1)", 4),
        ("BOOL", "d < D#2106-02-07", True),
        ("STRING", "LDATE_TO_STRING(DATE_TO_LDATE(d))", "LDATE#2024-02-29"),
        ("STRING", "LDT_TO_STRING(DT_TO_LDT(dt1))", "LDT#2024-02-29-12:30:15"),
        ("ULINT", "LDATE_TO_ULINT(LDATE#1970-01-02)", DAY * 1_000_000_000),
        ("LTIME", "LDATE#1970-01-03 - LDATE#1970-01-02", DAY * 1_000_000_000),
        ("DATE", "LDT_TO_DATE(LDT#1971-01-01-23:59:59.999)", 365 * DAY),
    ],
)
def test_dates_count_seconds_from_1970(
    kind: str, expression: str, expected: Value, dialect: str, engine_name: str
) -> None:
    assert value(kind, expression, dialect, engine_name) == expected


@pytest.mark.parametrize(
    ("kind", "expression", "expected"),
    [
        ("UINT", "DATE_TO_UINT(D#1990-01-02)", 1),
        ("UINT", "DATE_TO_UINT(d)", 19_782 - 7_305),
        ("DATE", "DT_TO_DATE(DT#1990-01-03-12:00:00)", 2),
        (
            "STRING",
            "DT_TO_STRING(CONCAT_DATE_TOD(IN1 := d, IN2 := tod1))",
            "DT#2024-02-29-12:30:15.250",
        ),
    ],
)
def test_dates_of_s7_count_days_from_1990(
    kind: str, expression: str, expected: Value, engine_name: str
) -> None:
    for name in ("d", "tod1"):
        expression = expression.replace(f"({name}", f"(#{name}").replace(f" {name}", f" #{name}")
    assert value(kind, expression, "tia", engine_name) == expected


STARTS = (
    "FUNCTION_BLOCK F\nVAR_OUTPUT d : DATE; moment : DT; END_VAR\nVAR x : INT; END_VAR\n"
    "{m}x := 1;\nEND_FUNCTION_BLOCK\n"
)


@pytest.mark.parametrize(
    ("dialect", "first"),
    [
        ("tia", "1990-01-01"),
        ("step7", "1990-01-01"),
        ("iec", "1970-01-01"),
        ("twincat", "1970-01-01"),
    ],
)
def test_a_variable_starts_with_the_first_date(dialect: str, first: str, engine_name: str) -> None:
    text = (
        "FUNCTION_BLOCK F\nVAR_OUTPUT a, b : STRING; END_VAR\nVAR d : DATE; moment : DT; END_VAR\n"
        "{m}a := DATE_TO_STRING({m}d);\n{m}b := DT_TO_STRING({m}moment);\nEND_FUNCTION_BLOCK\n"
    ).format(m="#" if dialect == "tia" else "")
    block = run(text, dialect, engine_name).instance("F")
    block()
    assert (block.a, block.b) == (f"D#{first}", f"DT#{first}-00:00:00")


@pytest.mark.parametrize("target", PC)
def test_a_date_without_a_value_starts_with_the_same_day_after_a_conversion(
    target: str, engine_name: str
) -> None:
    (converted,) = convert([parse(Source("f.scl", STARTS.format(m="#")), "tia")], target)
    text = print_generated(converted).text
    assert "d : DATE := D#1990-01-01;" in text
    block = run(text, target, engine_name).instance("F")
    assert block.d == 7_305 * DAY
    assert block.moment == 7_305 * DAY


@pytest.mark.parametrize("source", PC)
def test_a_date_that_starts_in_1970_is_refused_on_the_way_to_s7(source: str) -> None:
    with pytest.raises(DiagnosticError) as refused:
        convert([parse(Source("f.st", STARTS.format(m="")), source)], "tia")
    assert [one.code for one in refused.value.diagnostics] == ["FB3051", "FB3051"]
    assert "d, which starts as 1970-01-01" in refused.value.diagnostics[0].message


@pytest.mark.parametrize(
    ("source", "target", "call"),
    [
        ("tia", "iec", "UINT_TO_DATE(#n)"),
        ("twincat", "tia", "UINT_TO_DATE(n)"),
        ("iec", "step7", "TO_DATE(n)"),
    ],
)
def test_a_number_that_becomes_a_date_is_refused(source: str, target: str, call: str) -> None:
    mark = "#" if source == "tia" else ""
    text = (
        "FUNCTION_BLOCK F\nVAR d : DATE := D#2024-01-01; n : UINT; END_VAR\n"
        f"{mark}d := {call};\nEND_FUNCTION_BLOCK\n"
    )
    with pytest.raises(DiagnosticError) as refused:
        convert([parse(Source("f.st", text), source)], target)
    (found,) = refused.value.diagnostics
    assert (found.code, found.span and found.span.line) == ("FB3051", 3)


@pytest.mark.parametrize("target", PC)
def test_dates_move_as_dates(target: str, engine_name: str) -> None:
    text = (
        'FUNCTION_BLOCK "F"\nVAR_INPUT d : DATE; END_VAR\nVAR_OUTPUT late : BOOL; END_VAR\n'
        "BEGIN\n#late := #d > D#2024-06-01;\nEND_FUNCTION_BLOCK\n"
    )
    (converted,) = convert([parse(Source("f.scl", text), "tia")], target)
    block = run(print_generated(converted).text, target, engine_name).instance("F")
    for day, late in ((19_783, False), (19_999, True)):
        block(d=day * DAY)
        assert block.late is late


@pytest.mark.parametrize("dialect", ["tia", "twincat"])
def test_retentive_dates_come_back(dialect: str, engine_name: str) -> None:
    text = (
        "DATA_BLOCK Kept\nVAR RETAIN d : DATE; moment : DT; END_VAR\nBEGIN\nEND_DATA_BLOCK\n"
        if dialect == "tia"
        else "VAR_GLOBAL RETAIN d : DATE; moment : DT; END_VAR\n"
    )
    first, second = (run(text, dialect, engine_name) for _ in range(2))
    names = ['"Kept"."d"', '"Kept"."moment"'] if dialect == "tia" else ['"d"', '"moment"']
    first.engine.set_global(names[0], 12_000)
    first.engine.set_global(names[1], 4_000_000_000)
    restore_retentive(second.engine, retentive_values(first.engine))
    assert [second.engine.global_value(name) for name in names] == [12_000, 4_000_000_000]
