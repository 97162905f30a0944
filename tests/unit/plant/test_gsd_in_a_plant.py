"""Plant files that name a GSD file: layout, identifiers, contradictions, hash, simulated slave."""

import json
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import pytest

from fbgen.catalog import load_catalog
from fbgen.catalog.differences import differences
from fbgen.cli import main
from fbgen.diagnostics import DiagnosticError
from fbgen.emit.generator import generate
from fbgen.plant import Plant, changed, layout_of, load_plant
from harness.fieldbus import SlaveState
from harness.installation import PlantSetup, build_plant
from harness.kernel import NS_PER_MS

ROOT = Path(__file__).parents[3]
CATALOG = load_catalog()
ESCO = (ROOT / "examples" / "manual_example" / "esco1803.gsd").read_text()
MADE_UP = (ROOT / "tests" / "unit" / "wire" / "made_up_pbdp110.gsd").read_text()
MANUAL = (ROOT / "examples" / "manual_example" / "plant.yaml").read_text()
PBDP = (ROOT / "examples" / "pbdp110" / "plant.yaml").read_text()
TWO_DRIVES = 'modules: ["Module 2: two drives with parameters"]'
WHOLE = ("0x30,0x30,0x20,0x30,0x30,0x70,0x20,0x70", "0xC0,0x89,0x87")
NINE = ("0x70,0x20,0x70", "0x70,0x70")


@dataclass(frozen=True)
class Folder:
    """A folder with a plant file and a GSD file."""

    path: Path

    def plant_file(self, text: str, *changes: tuple[str, str]) -> Path:
        for old, new in changes:
            assert old in text, old
            text = text.replace(old, new)
        path = self.path / "plant.yaml"
        path.write_text(text)
        return path

    def manual(self, gsd: str, *changes: tuple[str, str]) -> Path:
        """The manual's example with this GSD file instead of a layout."""
        (self.path / "esco1803.gsd").write_text(gsd)
        return self.plant_file(MANUAL, ("layout: gsd10", "gsd: esco1803.gsd"), *changes)

    def pbdp(self, gsd: str, *changes: tuple[str, str]) -> Path:
        """Two drives at a PBDP-110 with this GSD file instead of a layout."""
        (self.path / "made_up.gsd").write_text(gsd)
        named = ("layout: module2", f"gsd: made_up.gsd\n    {TWO_DRIVES}")
        return self.plant_file(PBDP, named, *changes)


@pytest.fixture
def folder(tmp_path: Path) -> Folder:
    return Folder(tmp_path)


def told(path: Path) -> list[tuple[str, str]]:
    with pytest.raises(DiagnosticError) as failure:
        load_plant(path, CATALOG)
    return [(item.code, item.message) for item in failure.value.diagnostics]


def layout_in(path: Path) -> tuple[str, str]:
    (gateway,) = load_plant(path, CATALOG).gateways
    layout = layout_of(gateway, CATALOG.gateway(gateway.type))
    return layout.name, layout.identifiers.hex(" ").upper()


def with_module(gsd: str, change: tuple[str, str]) -> str:
    assert change[0] in gsd
    return gsd.replace(*change)


def test_the_layout_of_the_tospbdp001_comes_from_its_file(folder: Folder) -> None:
    assert layout_in(folder.manual(ESCO)) == ("gsd10", "30 30 20 30 30 70 20 70")
    nine = with_module(ESCO, NINE)
    assert layout_in(folder.manual(nine)) == ("doc9", "30 30 20 30 30 70 70")
    whole = with_module(ESCO, WHOLE)
    assert layout_in(
        folder.manual(
            whole, ("access: per_identifier", "access: dpxx_dat"), ("plc: s7-1500", "plc: s7-300")
        )
    ) == ("whole10", "C0 89 87")


def test_identifiers_that_the_catalogue_does_not_have_take_its_fields_with_as_many_bytes(
    folder: Folder,
) -> None:
    by_words = with_module(ESCO, (WHOLE[0], "0x64,0x73"))
    assert told(folder.manual(by_words))[0][0] == "FB2042"
    other = with_module(ESCO, (WHOLE[0], "0x70,0x20,0x31,0x70,0x20,0x70"))
    path = folder.manual(other)
    assert layout_in(path) == ("gsd10", "70 20 31 70 20 70")
    generated = generate(load_plant(path, CATALOG), CATALOG)
    assert [(item.code, item.message) for item in generated.warnings] == [
        (
            "FB2043",
            "the identifiers of 'Binary Mode' are 70 20 31 70 20 70, those of layout 'gsd10' "
            "30 30 20 30 30 70 20 70",
        )
    ]


def test_the_9_bytes_of_the_manuals_text_contradict_the_10_of_its_gsd_file(folder: Folder) -> None:
    path = folder.manual(ESCO, ("gsd: esco", "layout: doc9\n    gsd: esco"))
    with pytest.raises(DiagnosticError) as failure:
        load_plant(path, CATALOG)
    (found,) = failure.value.diagnostics
    assert found.code == "FB2042"
    assert found.message == (
        "'Binary Mode' of esco1803.gsd carries 10 bytes out and 8 in, layout 'doc9' has 9 and 8"
    )
    assert found.help == "write layout: gsd10, or leave layout out"
    assert found.span is not None
    assert found.span.text == "doc9"


def test_the_blocks_are_those_of_the_layout_but_for_the_hash(folder: Folder) -> None:
    from_file = generate(load_plant(folder.manual(ESCO), CATALOG), CATALOG)
    from_layout = generate(load_plant(folder.plant_file(MANUAL), CATALOG), CATALOG)
    assert from_file.inputs_hash != from_layout.inputs_hash
    assert [
        file.text.replace(from_file.inputs_hash, from_layout.inputs_hash)
        for file in from_file.files
    ] == [file.text for file in from_layout.files]
    assert from_file.warnings == ()


def test_an_access_way_that_the_identifiers_do_not_have_is_told(folder: Folder) -> None:
    whole = with_module(ESCO, WHOLE)
    assert ("FB2005", "layout 'whole10' cannot be reached by per_identifier: one identifier "
            "covers the whole frame") in told(folder.manual(whole))  # fmt: skip


@pytest.mark.parametrize(
    ("change", "expected"),
    [
        (
            ("= 0x1803", "= 0x1804"),
            ("FB2041", "esco1803.gsd is the file of another device: its ident number is 1804, the "
             "catalogue says for tospbdp001 1803"),
        ),
        (("Station_Type          = 0", "Station_Type = 1"),
         ("FB2041", "esco1803.gsd describes a DP master, not a slave")),
        ((",0x20,0x70\n", "\n"),
         ("FB2042", "'Binary Mode' of esco1803.gsd carries 7 bytes out and 6 in, layout 'gsd10' "
          "has 10 and 8")),
        (("0x30,0x30,0x20", "0xC0,0x89"), ("FB1305", "the identifier C0 lacks a length byte")),
        (("EndModule", ""), ("FB1304", "Module has no EndModule: the file ends before it")),
    ],
    ids=["ident", "master", "lengths", "identifiers", "cut off"],
)  # fmt: skip
def test_a_file_that_does_not_fit_is_told(
    change: tuple[str, str], expected: tuple[str, str], folder: Folder
) -> None:
    gsd = with_module(ESCO, change)
    if expected[0] == "FB1305":
        gsd = gsd.replace("0xC0,0x89,0x30,0x30,0x70,0x20,0x70", "0xC0,0x89")
    assert told(folder.manual(gsd)) == [expected]


def test_what_no_block_depends_on_is_a_warning(folder: Folder) -> None:
    gsd = ESCO.replace("Freeze_Mode_supp      = 1", "Freeze_Mode_supp = 0")
    gsd = gsd.replace("MaxTsdr_12M           = 800", "MaxTsdr_12M = 400\nFail_Saf = 1")
    plant = load_plant(folder.manual(gsd), CATALOG)
    found = generate(plant, CATALOG).warnings
    assert [(item.code, item.message) for item in found] == [
        ("FB1308", "the keyword Fail_Saf is not known"),
        ("FB2043", "Freeze: no in esco1803.gsd, yes in the catalogue for tospbdp001"),
        ("FB2043", "MaxTsdr at 12M: 400 in esco1803.gsd, 800 in the catalogue for tospbdp001"),
    ]


def test_a_module_that_is_not_there_is_told_in_the_plant_file(folder: Folder) -> None:
    path = folder.manual(
        ESCO, ("gsd: esco1803.gsd", "gsd: esco1803.gsd\n    modules: [ASCII Mode]")
    )
    with pytest.raises(DiagnosticError) as failure:
        load_plant(path, CATALOG)
    (found,) = failure.value.diagnostics
    assert found.code == "FB1310"
    assert found.span is not None
    assert (found.span.text, found.span.source.name) == ("ASCII Mode", path.as_posix())


def test_a_file_that_is_not_there_is_told_in_the_plant_file(folder: Folder) -> None:
    path = folder.plant_file(MANUAL, ("layout: gsd10", "gsd: gone.gsd"))
    with pytest.raises(DiagnosticError) as failure:
        load_plant(path, CATALOG)
    (found,) = failure.value.diagnostics
    assert found.code == "FB1008"
    assert found.message.startswith("gone.gsd cannot be read: ")
    assert found.span is not None
    assert found.span.text == "gone.gsd"
    assert told(folder.plant_file(MANUAL, ("layout: gsd10", "gsd: 5"))) == [
        ("FB1006", "the key 'layout' is missing here"),
        ("FB1007", "the GSD file is named by a text: its path from the plant file"),
    ]


def test_identifiers_and_a_gsd_file_are_one_too_many(folder: Folder) -> None:
    path = folder.pbdp(MADE_UP, ("gsd: made", "identifiers: C0 CF D7\n    gsd: made"))
    assert told(path) == [
        ("FB2040", "identifiers and gsd both say what the module's identifiers are")
    ]


def test_of_a_modular_station_the_plugged_module_says_the_layout(folder: Folder) -> None:
    assert layout_in(folder.pbdp(MADE_UP)) == ("module2", "C0 CF D7")
    by_layout = folder.pbdp(MADE_UP, (TWO_DRIVES, "layout: module4"))
    assert layout_in(by_layout) == ("module4", "C0 C3 C7")
    alone = ("      - {name: fan, channel: B, series: vf-s11, max_frequency_hz: 50.0}", "")
    by_words = folder.pbdp(
        MADE_UP,
        (TWO_DRIVES, 'modules: ["module 3: one drive"]'),
        ("access: dpxx_dat", "access: per_identifier\n    input_address: 0\n    output_address: 0"),
        alone,
    )
    assert layout_in(by_words) == ("module3", "61 53")
    (gateway,) = load_plant(by_words, CATALOG).gateways
    assert layout_of(gateway, CATALOG.gateway("pbdp110")).unverified == ()


def test_where_nothing_says_which_module_is_plugged_that_alone_is_told(folder: Folder) -> None:
    assert told(folder.pbdp(MADE_UP, (TWO_DRIVES, ""))) == [
        ("FB1311", "made_up.gsd has 4 modules, and nothing says which of them are plugged")
    ]


def test_the_hash_of_the_inputs_covers_the_content_of_the_file(folder: Folder) -> None:
    before = load_plant(folder.manual(ESCO), CATALOG)
    same = load_plant(folder.manual(ESCO), CATALOG)
    after = load_plant(folder.manual(ESCO + "; another version\n"), CATALOG)
    assert before == same
    assert before.model_dump_json() == same.model_dump_json() != after.model_dump_json()
    assert list(differences(before, same)) == []
    (found,) = differences(before, after)
    assert found.path.endswith("gsd")
    assert found.before.startswith("esco1803.gsd (content ")
    assert found.before != found.after


def test_a_plant_without_a_gsd_file_has_the_hash_that_it_had(folder: Folder) -> None:
    (gateway,) = json.loads(load_plant(folder.plant_file(MANUAL), CATALOG).model_dump_json())[
        "gateways"
    ]
    assert not {"gsd", "modules"} & set(gateway)


def test_generate_and_diff_notice_a_changed_file(
    folder: Folder, capsys: pytest.CaptureFixture[str]
) -> None:
    path = folder.manual(ESCO)
    out = str(folder.path / "out")
    assert main(("generate", str(path), "-o", out)) == 0
    assert main(("generate", str(path), "-o", out, "--check")) == 0
    text = (folder.path / "out" / "README.md").read_text("utf-8")
    assert "`gw1` is configured from the GSD file `esco1803.gsd` (ident number 1803h" in text
    assert "plug 'Binary Mode' and nothing else" in text
    folder.manual(ESCO + "; another version\n")
    capsys.readouterr()
    assert main(("generate", str(path), "-o", out, "--check")) == 1
    other = folder.path / "other"
    other.mkdir()
    Folder(other).manual(ESCO)
    capsys.readouterr()
    assert main(("diff", str(path), str(other / "plant.yaml"))) == 1
    assert ".gsd: esco1803.gsd (content " in capsys.readouterr().out


def test_a_changed_plant_keeps_its_file(folder: Folder) -> None:
    plant = load_plant(folder.manual(ESCO), CATALOG)
    other = changed(plant, CATALOG, prefix="HALL_")
    assert other.gateways == plant.gateways


@pytest.mark.parametrize(
    "made", [lambda folder: folder.manual(ESCO), lambda folder: folder.pbdp(MADE_UP)]
)
def test_the_simulated_slave_is_that_of_the_file(
    made: Callable[[Folder], Path], folder: Folder
) -> None:
    plant: Plant = load_plant(made(folder), CATALOG)
    installation = build_plant(plant, CATALOG, PlantSetup())
    slave = installation.devices.slave("gw1")
    (gateway,) = plant.gateways
    assert gateway.gsd is not None
    assert gateway.gsd.station is not None
    assert slave.type.ident_number == gateway.gsd.station.ident_number
    assert slave.type.user_parameter_bytes == len(gateway.gsd.station.parameters)
    assert slave.type.configuration == layout_of(gateway, CATALOG.gateway(gateway.type)).identifiers
    for module in gateway.gsd.station.modules:
        assert slave.type.accepts(module.code)
    installation.start()
    installation.run_for(100 * NS_PER_MS)
    assert slave.state is SlaveState.DATA_EXCHANGE
