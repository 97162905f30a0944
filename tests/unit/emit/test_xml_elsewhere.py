"""The XML that is generated, read by programs that we did not write.

blark (GPL, a test dependency) parses TwinCAT's objects, container and code. The package plcopen is
made from the schema TC6 2.01 by xsdata: unknown elements, attributes and values are errors, and
what it writes again stands in the order of the schema. Of the packages for PLCopen XML on PyPI it
is the only one that knows the whole schema: plcopener takes code out, pyplcopen is about motion.
"""

from collections.abc import Sequence
from pathlib import Path
from xml.etree.ElementTree import Element

import pytest
from blark.parse import parse
from defusedxml.ElementTree import fromstring
from plcopen import Project
from xsdata.exceptions import ParserError
from xsdata.formats.dataclass.parsers import XmlParser
from xsdata.formats.dataclass.parsers.config import ParserConfig
from xsdata.formats.dataclass.serializers import XmlSerializer

from fbgen.emit.generated import GeneratedFile
from tests.unit.emit.examples import generated

PLANTS = ["manual_example", pytest.param("five_drives", marks=pytest.mark.slow)]
LONG = 8_000
"""Bytes of an object that blark, an Earley parser, reads for seconds: three of the manual's example
have more, and are as long together as all others."""


def blocks_of(example: str) -> set[str]:
    """Every block with code that the plant has, by the files of dialect `tia`."""
    own = {"TOS_Restart"}  # OB100 is of the S7
    files = generated(example, "tia")
    return {file.name.removesuffix(".scl") for file in files if file.name.endswith(".scl")} - own


def read_by_blark(files: Sequence[GeneratedFile], folder: Path) -> set[str]:
    """The names of all objects that it reads."""
    read: set[str] = set()
    for file in files:
        path = folder / file.name
        path.write_bytes(file.data)
        for result in parse(path):
            assert result.exception is None, (file.name, result.exception)
            read.add(str(result.identifier).partition("/")[0])
    return read


@pytest.mark.slow
@pytest.mark.parametrize("example", ["manual_example", "five_drives"])
def test_blark_reads_every_object_of_twincat(example: str, tmp_path: Path) -> None:
    blocks = blocks_of(example)
    assert len(blocks) > 10
    files = generated(example, "twincat")
    assert blocks | {"typeTosLine", "TOS_Globals"} <= read_by_blark(files, tmp_path)


def test_blark_reads_every_object_of_twincat_that_is_not_long(tmp_path: Path) -> None:
    files = [file for file in generated("manual_example", "twincat") if len(file.data) <= LONG]
    long = {"TOS_Drive", "TOS_Line", "TOS_Telegram"}
    blocks = blocks_of("manual_example") - long
    assert len(blocks) > 10
    assert blocks | {"typeTosLine", "TOS_Globals"} <= read_by_blark(files, tmp_path)


def test_blark_refuses_a_broken_object(tmp_path: Path) -> None:
    block = next(one for one in generated("manual_example", "twincat") if "Handshake" in one.name)
    path = tmp_path / block.name
    path.write_bytes(block.data.replace(b"END_IF;", b"END_FI;", 1))
    assert any(result.exception is not None for result in parse(path))


def project_of(text: str) -> Project:
    """The project as the library has it; ParserError for what the schema does not know."""
    strict = ParserConfig(
        fail_on_unknown_properties=True,
        fail_on_unknown_attributes=True,
        fail_on_converter_warnings=True,
    )
    return XmlParser(config=strict).from_string(text, Project)


def shape(element: Element) -> tuple[str, list[object]]:
    """The tags in their order; the sections of an interface may stand in any."""
    inside: list[object] = [shape(child) for child in element]
    if element.tag.endswith("}interface"):
        inside.sort(key=str)
    return element.tag, inside


@pytest.mark.parametrize("example", [*PLANTS, "devicenet"])
def test_a_library_of_the_schema_reads_the_project_of_plcopen(example: str) -> None:
    (file,) = generated(example, "plcopen")
    project = project_of(file.text)
    assert project.content_header.name == {"devicenet": "conveyors"}.get(example, example)
    names = {pou.name for pou in project.types.pous.pou}
    assert names == blocks_of(example)
    again = XmlSerializer().render(project)
    assert shape(fromstring(again)) == shape(fromstring(file.text))


def test_the_library_refuses_what_the_schema_does_not_know() -> None:
    (file,) = generated("manual_example", "plcopen")
    with pytest.raises(ParserError):
        project_of(
            file.text.replace("<inputVars>", "<inputs>").replace("</inputVars>", "</inputs>")
        )


def test_elements_out_of_the_order_of_the_schema_are_seen() -> None:
    (file,) = generated("manual_example", "plcopen")
    head, content, rest = file.text.partition("<contentHeader")
    content_end = rest.index("</contentHeader>") + len("</contentHeader>\n")
    moved = head + rest[content_end:].replace(
        "</project>", f"<contentHeader{rest[:content_end]}</project>"
    )
    again = XmlSerializer().render(project_of(moved))
    assert content
    assert shape(fromstring(again)) != shape(fromstring(moved))
