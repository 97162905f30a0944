"""What cannot be generated: code, place and help; and a page for each code of this range."""

import re
from pathlib import Path

import pytest

import fbgen
from fbgen.blocks.plan import plan_blocks
from fbgen.catalog import load_catalog
from fbgen.diagnostics import DiagnosticError, Severity
from fbgen.emit.generator import generate
from fbgen.plant import Plant, read_plant
from fbgen.resources import shipped
from fbgen.source import Source

ROOT = Path(__file__).parents[3]
PACKAGE = Path(str(fbgen.__file__)).parent
EXAMPLE = (ROOT / "examples" / "manual_example" / "plant.yaml").read_text("utf-8")
SEQUENCE = (ROOT / "catalog" / "sequences" / "set_frequency.yaml").read_text("utf-8")


def plant(text: str, *extra: Path) -> Plant:
    return read_plant(Source("plant.yaml", text), load_catalog(extra))


def test_an_access_way_that_iec_has_not_is_fb5006_at_its_place() -> None:
    with pytest.raises(DiagnosticError) as failure:
        generate(plant(EXAMPLE), load_catalog(), "iec")
    (found,) = failure.value.diagnostics
    assert found.code == "FB5006"
    assert found.span is not None
    assert found.span.text == "per_identifier"
    assert "process_image" in found.help


def test_a_sequence_that_writes_into_the_eeprom_is_the_warning_fb5005(tmp_path: Path) -> None:
    (tmp_path / "sequences").mkdir()
    text = SEQUENCE.replace("id: set_frequency", "id: keep").replace(
        "    parameter: frequency\n", "    parameter: frequency\n    memory: eeprom\n"
    )
    (tmp_path / "sequences" / "keep.yaml").write_text(text, "utf-8")
    catalog = load_catalog([tmp_path])
    own = EXAMPLE.replace("[manual_example]", "[keep]")
    files = generate(read_plant(Source("plant.yaml", own), catalog), catalog)
    (found,) = files.warnings
    assert (found.code, found.severity) == ("FB5005", Severity.WARNING)
    assert found.span is not None
    assert found.span.text == "eeprom"
    assert "10,000" in found.help
    block = next(file.text for file in files.files if file.name == "TOS_Seq_keep.scl")
    assert "#channel.request.cmd := 16#57;" in block


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
        plan_blocks(read_plant(Source("plant.yaml", own), catalog), catalog, "tia")
    (found,) = failure.value.diagnostics
    assert found.code == "FB5001"
    assert found.span is not None
    assert found.span.source.name.endswith("set_frequency.yaml")
    assert "each series" in found.help


def test_every_code_has_a_page_with_a_failing_and_a_fixed_example() -> None:
    texts = [
        path.read_text("utf-8")
        for folder in ("emit", "blocks")
        for path in (PACKAGE / folder).rglob("*.py")
    ]
    codes = set(re.findall(r'"(FB5\d{3})"', "\n".join(texts)))
    assert len(codes) > 20
    for code in codes:
        page = (shipped("diagnostics") / f"{code}.md").read_text("utf-8")
        assert page.startswith(f"# {code}: ")
        assert "## Fails\n\n```" in page
        assert "## Fixed\n\n```" in page
    assert {path.stem for path in shipped("diagnostics").glob("FB5*.md")} == codes
