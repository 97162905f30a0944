"""What CODESYS exports and TwinCAT keeps besides code: objects, lists and tasks."""

from pathlib import Path

import pytest

from fbgen.lang import ast
from fbgen.lang.checker import check_reporting
from fbgen.lang.containers import new_files, read_document, read_text
from fbgen.lang.parser import parse
from fbgen.lang.printer import print_file
from fbgen.lang.rewriting import replaced
from fbgen.lang.same_tree import same_tree
from fbgen.source import Source
from harness import load_program

_OBJECTS = Path(__file__).parents[2] / "conformance" / "objects"
_EXPORT = Path(__file__).parent / "samples" / "codesys_drive.xml"
_TASK = """\
<?xml version="1.0" encoding="utf-8"?>
<TcPlcObject Version="1.1.0.1">
  <Task Name="PlcTask" Id="{a6f69ccf-6b78-46d9-86ee-0d55a6d83f31}">
    <!--CycleTime in micro seconds.-->
    <CycleTime>2500</CycleTime>
    <Priority>20</Priority>
    <PouCall>
      <Name>MAIN</Name>
    </PouCall>
    <PouCall>
      <Name>VisuElems.Visu_Prg</Name>
    </PouCall>
  </Task>
</TcPlcObject>
"""
_MAIN = "PROGRAM MAIN\nVAR n : INT; END_VAR\nn := n + 1;\nEND_PROGRAM\n"


@pytest.mark.parametrize("engine", ["compiled", "reference"])
def test_an_export_of_codesys_runs_as_it_is(engine: str) -> None:
    program = load_program([_EXPORT], "twincat", engine)
    program.start()
    program.run_for(ms=50)
    names = ("PLC_PRG.rActual", "PLC_PRG.fbDrive.iCount", "diTotal")
    assert [program.engine.global_value(name) for name in names] == [800.0, 3, 12]


def test_an_export_of_codesys_has_its_objects() -> None:
    document = read_document(_EXPORT)
    assert (document.dialect, document.findings) == ("twincat", ())
    units = {unit.name.name: unit for unit in document.file.units if isinstance(unit, ast.Block)}
    drive = units["FB_Drive"]
    assert drive.extends is not None
    assert drive.extends.name == "FB_Base"
    assert [one.name for one in drive.implements] == ["I_Drive"]
    names = [member.name.name for member in drive.members]
    assert names == ["A_Reset", "M_Start", "M_Limit", "P_Speed"]
    assert isinstance(drive.members[2], ast.Method)
    assert drive.members[2].modifiers == ("PRIVATE",)
    assert units["FB_Base"].modifiers == ("ABSTRACT",)
    text = print_file(document.file).text
    assert "{attribute 'qualified_only'}" in text
    assert "VAR_GLOBAL RETAIN" in text
    assert "PROGRAM PLC_PRG WITH MainTask : PLC_PRG;" in text


def test_formatting_an_export_of_codesys_touches_code_only() -> None:
    document = read_document(_EXPORT)
    after = document.rewritten(document.file).decode()
    assert "IF xEnable THEN\n    M_Start(800.0);\nEND_IF;</xhtml>" in after
    again = read_text(Source(str(_EXPORT), after), "twincat", is_xml=True)
    assert again.rewritten(again.file).decode() == after


def test_a_task_of_twincat_runs_its_programs(tmp_path: Path) -> None:
    task, main = tmp_path / "PlcTask.TcTTO", tmp_path / "MAIN.st"
    task.write_text(_TASK, encoding="utf-8")
    main.write_text(_MAIN, encoding="utf-8")
    program = load_program([task, main], "twincat")
    (known,) = program.engine.program.tasks
    assert (known.name, known.interval_ns, known.priority) == ("PlcTask", 2_500_000, 20)
    program.start()
    program.run_for(ms=9)
    assert program.engine.global_value("MAIN.n") == 4


def test_a_task_of_twincat_comes_back_from_its_tree() -> None:
    document = read_text(Source("PlcTask.TcTTO", _TASK), "twincat", is_xml=True)
    assert document.rewritten(document.file).decode() == _TASK
    (new,) = new_files([document.file], "twincat", "x")
    assert new.name == "PlcTask.TcTTO"
    again = read_text(Source("x", new.data.decode()), "twincat", is_xml=True)
    assert print_file(again.file).text == print_file(document.file).text


def test_a_task_without_a_program_that_is_there_is_told() -> None:
    document = read_text(Source("PlcTask.TcTTO", _TASK), "twincat", is_xml=True)
    _, found = check_reporting([document.file], "twincat")
    (one,) = found
    assert one.span is not None
    assert (one.code, one.span.line, one.span.column) == ("FB4060", 8, 13)


@pytest.mark.parametrize("name", ["abstract", "interfaces", "objects", "shared"])
def test_objects_come_back_from_plcopen_xml(name: str) -> None:
    path = _OBJECTS / f"{name}.st"
    tree = parse(Source(str(path), path.read_text(encoding="utf-8")), "twincat")
    (new,) = new_files([tree], "plcopen", name)
    document = read_text(Source("x.xml", new.data.decode()), "twincat", is_xml=True)
    assert document.findings == ()
    before = {_name(unit): unit for unit in tree.units}
    after = {_name(unit): unit for unit in document.file.units}
    assert before.keys() == after.keys()
    for key, unit in before.items():
        if not isinstance(unit, ast.Globals):
            assert same_tree(_ordered(unit), _ordered(after[key])), key


def _name(unit: ast.Unit) -> str:
    return str(getattr(getattr(unit, "name", ""), "name", type(unit).__name__))


def _ordered(unit: ast.Unit) -> ast.Unit:
    """Actions stand in an element of their own, in front of the other members."""
    if not isinstance(unit, ast.Block):
        return unit
    return replaced(unit, members=tuple(sorted(unit.members, key=lambda one: one.name.name)))


def test_what_has_no_element_stands_in_the_text_of_codesys() -> None:
    text = (
        "FUNCTION_BLOCK Pump EXTENDS Base\nVAR\nr : REFERENCE TO INT;\nEND_VAR\n"
        "METHOD PRIVATE Stop\nEND_METHOD\nEND_FUNCTION_BLOCK\n"
    )
    (new,) = new_files([parse(Source("x", text), "twincat")], "plcopen", "x")
    xml = new.data.decode()
    assert "<Extends>Base</Extends>" in xml
    assert '<AccessModifiers Private="true"/>' in xml
    assert "r : REFERENCE TO INT;" in xml


_OPEN_ARRAY = """\
<project xmlns="http://www.plcopen.org/xml/tc6_0200"><types><dataTypes/><pous>
<pou name="Total" pouType="function"><interface><returnType><INT/></returnType><inputVars>
<variable name="first"><type><INT/></type></variable>
<variable name="values"><type><pointer><baseType><INT/></baseType></pointer></type><addData>
<data name="http://www.3s-software.com/plcopenxml/attributes" handleUnknown="implementation">
<Attributes><Attribute Name="variable_length_array_original_scope" Value="Inout"/>
<Attribute Name="variable_length_array" Value="ARRAY[*] OF INT"/></Attributes></data></addData>
</variable><variable name="last"><type><INT/></type></variable></inputVars></interface>
<body><ST><xhtml xmlns="http://www.w3.org/1999/xhtml">Total := values[first] + values[last];</xhtml>
</ST></body></pou></pous></types></project>
"""


def test_open_arrays_come_back_from_the_pointers_of_an_export() -> None:
    document = read_text(Source("x.xml", _OPEN_ARRAY), "twincat", is_xml=True)
    (block,) = document.file.units
    assert isinstance(block, ast.Block)
    kinds = [
        (section.keyword, one.names[0].name)
        for section in block.sections
        for one in section.declarations
    ]
    assert kinds == [("VAR_INPUT", "first"), ("VAR_IN_OUT", "values"), ("VAR_INPUT", "last")]
    program, found = check_reporting([document.file], "twincat")
    assert program is not None
    assert [one.code for one in found if one.code < "FB41"] == []
