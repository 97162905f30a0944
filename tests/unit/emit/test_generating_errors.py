"""What cannot be generated: code, place and help; and a page for each code of this range."""

import re
from pathlib import Path

import pytest

import fbgen
from fbgen.blocks.plan import plan_blocks
from fbgen.catalog import load_catalog
from fbgen.diagnostics import Diagnostic, DiagnosticError, Severity
from fbgen.emit.generator import generate
from fbgen.plant import Plant, in_dialect, read_plant
from fbgen.resources import shipped
from fbgen.source import Source

ROOT = Path(__file__).parents[3]
PACKAGE = Path(str(fbgen.__file__)).parent
EXAMPLE = (ROOT / "examples" / "manual_example" / "plant.yaml").read_text("utf-8")
SEQUENCE = (ROOT / "catalog" / "sequences" / "set_frequency.yaml").read_text("utf-8")


def plant(text: str, *extra: Path) -> Plant:
    return read_plant(Source("plant.yaml", text), load_catalog(extra))


STEP7 = EXAMPLE.replace("dialect: tia", "dialect: step7").replace("s7-1500", "s7-300")


def refused(text: str) -> Diagnostic:
    """The only thing that is wrong in a plant of this text."""
    with pytest.raises(DiagnosticError) as failure:
        generate(plant(text), load_catalog())
    (found,) = failure.value.diagnostics
    return found


@pytest.mark.parametrize("dialect", ["iec", "twincat", "plcopen"])
def test_an_access_way_that_a_dialect_has_not_is_fb2005_at_its_place(dialect: str) -> None:
    with pytest.raises(DiagnosticError) as failure:
        in_dialect(plant(EXAMPLE), dialect, load_catalog())
    (found,) = failure.value.diagnostics
    assert found.code == "FB2005"
    assert found.span is not None
    assert found.span.text == "per_identifier"
    assert "process_image" in found.help


def test_a_gateway_whose_blocks_get_too_long_names_is_fb5010_at_its_name() -> None:
    found = refused(STEP7.replace("name: gw1", "name: conveyor"))
    assert found.code == "FB5010"
    assert found.message == (
        "the name 'TOS_ConsistentIo_conveyor' has 25 characters, and STEP 7 V5 SCL takes 24"
    )
    assert found.help == "give the gateway a name of at most 7 characters"
    assert found.span is not None
    assert found.span.text == "conveyor"
    assert generate(plant(STEP7.replace("name: gw1", "name: convey1")), load_catalog())


def test_a_drive_that_step7_takes_for_an_address_is_fb5010_at_its_name() -> None:
    text = STEP7.replace("name: drive11", "name: M11")
    found = refused(text)
    assert found.code == "FB5010"
    assert found.message == "'M11' is an address or a block to STEP 7 V5 SCL"
    assert found.span is not None
    assert found.span.text == "M11"
    assert generate(in_dialect(plant(text), "tia", load_catalog()), load_catalog())


def test_a_range_with_too_few_block_numbers_is_fb5011() -> None:
    found = refused(STEP7 + "block_numbers: {first: 10, last: 12}\n")
    assert found.code == "FB5011"
    needed = re.fullmatch(
        r"the plant needs (\d+) UDTs, and 3 numbers are free for them", found.message
    )
    assert needed
    assert found.help == f"let block_numbers end at {10 + int(needed[1]) - 1} or later"
    assert found.span is not None
    assert found.span.text == "12"


def test_a_range_of_block_numbers_that_ends_before_it_begins_is_fb2020() -> None:
    with pytest.raises(DiagnosticError) as failure:
        plant(STEP7 + "block_numbers: {first: 12, last: 10}\n")
    (found,) = failure.value.diagnostics
    assert found.code == "FB2020"
    assert found.span is not None
    assert found.span.text == "10"


@pytest.mark.parametrize(
    ("com_no", "message", "way_out"),
    [
        ("frequency_setpoint", "no cell there", "leave out memory: eeprom"),
        ("upper_limit_frequency", "into the EEPROM", "10,000"),
    ],
)
def test_a_sequence_that_writes_into_the_eeprom_is_the_warning_fb5005(
    tmp_path: Path, com_no: str, message: str, way_out: str
) -> None:
    (tmp_path / "sequences").mkdir()
    text = (
        SEQUENCE.replace("id: set_frequency", "id: keep")
        .replace("frequency_setpoint", com_no)
        .replace("    parameter: frequency\n", "    parameter: frequency\n    memory: eeprom\n")
    )
    (tmp_path / "sequences" / "keep.yaml").write_text(text, "utf-8")
    catalog = load_catalog([tmp_path])
    own = EXAMPLE.replace("[manual_example]", "[keep]")
    files = generate(read_plant(Source("plant.yaml", own), catalog), catalog)
    (found,) = files.warnings
    assert (found.code, found.severity) == ("FB5005", Severity.WARNING)
    assert found.span is not None
    assert found.span.text == "eeprom"
    assert found.message.endswith(message)
    assert way_out in found.help
    block = next(file.text for file in files.files if file.name == "TOS_Seq_keep.scl")
    assert "#channel.request.cmd := 16#57;" in block


@pytest.mark.parametrize(("limit_ms", "warned"), [(59, True), (60, False)])
def test_a_limit_below_what_a_reply_may_take_is_the_warning_fb5016(
    limit_ms: int, warned: bool
) -> None:
    # 20 ms the drive, 2 x 5 ms the gateway, 2 x 4.6 ms the line, 2 x 10 ms the PLC
    path = ROOT / "tests" / "unit" / "bad" / "FB5016_short_timeout.yaml"
    text = path.read_text("utf-8").replace("timeout_ms: 5}", f"timeout_ms: {limit_ms}}}")
    found = generate(plant(text), load_catalog()).warnings
    assert [item.code for item in found] == (["FB5016"] if warned else [])
    places = [(item.span.line, item.span.column) for item in found if item.span is not None]
    assert places == ([(15, 30)] if warned else [])


def test_a_sequence_that_differs_between_two_series_is_fb5001(tmp_path: Path) -> None:
    (tmp_path / "drives").mkdir()
    (tmp_path / "sequences").mkdir()
    (tmp_path / "gateways").mkdir()
    drive = (ROOT / "catalog" / "drives" / "vf-s11.yaml").read_text("utf-8")
    other = drive.replace("id: vf-s11", "id: vf-x", 1).replace("FA01", "FA05")
    (tmp_path / "drives" / "vf-x.yaml").write_text(other, "utf-8")
    text = SEQUENCE.replace("series: [vf-s11]", "series: [vf-s11, vf-x]")
    (tmp_path / "sequences" / "set_frequency.yaml").write_text(text, "utf-8")
    gateway = (ROOT / "catalog" / "gateways" / "tospbdp001.yaml").read_text("utf-8")
    gateway = gateway.replace("series: [vf-s11]", "series: [vf-s11, vf-x]")
    (tmp_path / "gateways" / "tospbdp001.yaml").write_text(gateway, "utf-8")
    catalog = load_catalog([tmp_path])
    own = EXAMPLE.replace("[manual_example]", "[set_frequency]") + (
        "      - {name: other, inv_no: 12, series: vf-x, max_frequency_hz: 50.0}\n"
    )
    with pytest.raises(DiagnosticError) as failure:
        plan_blocks(read_plant(Source("plant.yaml", own), catalog), catalog)
    (found,) = failure.value.diagnostics
    assert found.code == "FB5001"
    assert found.span is not None
    assert found.span.source.name.endswith("set_frequency.yaml")
    assert "each series" in found.help


def test_every_code_has_a_page_with_a_failing_and_a_fixed_example() -> None:
    texts = [
        path.read_text("utf-8")
        for folder in ("emit", "blocks", "artefacts")
        for path in (PACKAGE / folder).rglob("*.py")
    ]
    texts.append((PACKAGE / "kept_folder.py").read_text("utf-8"))
    codes = set(re.findall(r'"(FB5\d{3})"', "\n".join(texts)))
    assert len(codes) > 20
    for code in codes:
        page = (shipped("diagnostics") / f"{code}.md").read_text("utf-8")
        assert page.startswith(f"# {code}: ")
        assert "## Fails\n\n```" in page
        assert "## Fixed\n\n```" in page
    assert {path.stem for path in shipped("diagnostics").glob("FB5*.md")} == codes
