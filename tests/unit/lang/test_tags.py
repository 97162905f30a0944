"""PLC tags and user constants that a project keeps outside of its sources."""

import re

import pytest

from fbgen.diagnostics import DiagnosticError
from fbgen.lang.tag_files import global_file, read_tags
from fbgen.lang.tags import Tag
from fbgen.resources import shipped
from fbgen.source import Source
from harness import load_program
from harness.engine.interface import Value

_BLOCK = Source(
    "start.scl",
    'FUNCTION_BLOCK "Start"\n'
    'VAR list : ARRAY[0.."MAX"] OF INT; wait : TIME; level : REAL; END_VAR\n'
    "BEGIN\n"
    '  "Motor" := "Button" AND NOT "Fault";\n'
    '  #wait := "DELAY";\n'
    '  #level := "Level" * 2.0;\n'
    '  #list["MAX"] := 5;\n'
    "END_FUNCTION_BLOCK\n",
)
_TABLE = """<?xml version='1.0' encoding='utf-8'?>
<Tagtable name='Default tag table'>
  <Tag type='Bool' hmiVisible='True' remark='' addr='%I0.0'>Button</Tag>
  <Tag type='Bool' addr='%Q4.1'>Motor</Tag>
  <Tag type='Bool' addr='%M1.7'>Fault</Tag>
  <Tag type='Real' addr='%MD20'>Level</Tag>
  <Tag type='Timer' addr='%T5'>Old timer</Tag>
  <Constant type='Int' remark='' value='3'>MAX</Constant>
  <Constant type='Time' remark='' value='T#5s'>DELAY</Constant>
</Tagtable>
"""
_OPENNESS = """<Document><SW.Tags.PlcTagTable ID="0"><ObjectList>
<SW.Tags.PlcTag ID="1"><AttributeList><DataTypeName>Bool</DataTypeName>
<LogicalAddress>%I0.0</LogicalAddress><Name>Start &amp; go</Name></AttributeList></SW.Tags.PlcTag>
<SW.Tags.PlcUserConstant ID="2"><AttributeList><DataTypeName>Int</DataTypeName>
<Name>MAX</Name><Value>8</Value></AttributeList></SW.Tags.PlcUserConstant>
</ObjectList></SW.Tags.PlcTagTable></Document>
"""
_SDF = (
    '"Button                  ","E       0.0","BOOL      ","start button"\n'
    '"Speed                   ","MW     10  ","INT       ",""\n'
    '"Main                    ","OB      1  ","OB      1 ",""\n'
)


@pytest.mark.parametrize("engine", ["compiled", "reference"])
def test_a_program_uses_tags_and_constants_of_a_table(engine: str) -> None:
    program = load_program([_BLOCK], tags=[Source("tags.xml", _TABLE)], engine=engine)
    block = program.instance("Start")
    program.globals["Button"] = True
    program.globals["Level"] = 1.25
    block()
    assert program.globals["Motor"] is True
    assert program.engine.environment.outputs[4] == 2
    assert (block.wait, block.level, block.list[3]) == (5_000, 2.5, 5)


def test_tags_and_constants_come_from_python() -> None:
    tags = [Tag("Button", "BOOL"), Tag("Motor", "BOOL"), Tag("Fault", "BOOL"), Tag("Level", "REAL")]
    program = load_program([_BLOCK], constants={"MAX": 1, "DELAY": "T#2s"}, tags=tags)
    block = program.instance("Start")
    block()
    assert (block.list, block.wait) == ([0, 5], 2_000)


@pytest.mark.parametrize(
    ("value", "expected"),
    [(True, True), (-5, -5), (40_000, 40_000), (2.5, 2.5), ("16#FF", 255), ("'on'", "on")],
)
def test_a_constant_has_the_type_of_its_value(value: Value, expected: Value) -> None:
    kind = {bool: "BOOL", int: "DINT", float: "REAL", str: "STRING"}[type(expected)]
    text = f'FUNCTION "F" : {kind}\nBEGIN\n  #F := "C";\nEND_FUNCTION\n'
    assert isinstance(value, bool | int | float | str)
    assert load_program([Source("f.scl", text)], constants={"C": value}).call("F") == expected


def test_openness_exports_and_symbol_tables_are_read() -> None:
    tags, constants = read_tags(Source("tags.xml", _OPENNESS))
    assert [(tag.name, tag.type, tag.address) for tag in tags] == [("Start & go", "Bool", "%I0.0")]
    assert [(one.name, one.type, one.value) for one in constants] == [("MAX", "Int", "8")]
    tags, constants = read_tags(Source("symbols.sdf", _SDF))
    assert [(tag.name, tag.type, tag.address) for tag in tags] == [
        ("Button", "BOOL", "E0.0"),
        ("Speed", "INT", "MW10"),
    ]
    assert constants == []


@pytest.mark.parametrize(
    ("text", "line"),
    [
        ("<Tagtable><Tag type='Bool' addr='%M9'>A</Tag></Tagtable>", 1),
        ("<Tagtable>\n<Constant type='Int' value='many'>A</Constant></Tagtable>", 2),
        ("<Other/>", 1),
        ('"Button","E 0.0","BOOL",""\n"Broken"\n', 2),
    ],
)
def test_what_is_no_tag_is_reported_at_its_place(text: str, line: int) -> None:
    with pytest.raises(DiagnosticError) as caught:
        load_program([_BLOCK], tags=[Source("tags", text)])
    (found,) = caught.value.diagnostics
    assert found.code == "FB3060"
    assert found.span is not None
    assert found.span.line == line


def test_a_constant_that_the_sources_declare_too_is_reported() -> None:
    text = "VAR_GLOBAL CONSTANT C : INT := 1; END_VAR\nPROGRAM p\nEND_PROGRAM\n"
    with pytest.raises(DiagnosticError) as caught:
        load_program([Source("p.st", text)], dialect="iec", constants={"C": 2})
    assert [one.code for one in caught.value.diagnostics] == ["FB4002"]


def test_the_page_of_the_code_shows_it_and_the_way_out() -> None:
    page = (shipped("diagnostics") / "FB3060.md").read_text(encoding="utf-8")
    fails, fixed = re.findall(r"```xml\n(.*?)```", page, re.DOTALL)
    with pytest.raises(DiagnosticError, match="FB3060"):
        global_file("tia", {}, [Source("tags.xml", fails)])
    assert len(global_file("tia", {}, [Source("tags.xml", fixed)]).units) == 1
