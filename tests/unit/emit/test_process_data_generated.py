"""What is generated for gateways with process data: alone, beside a line, with a prefix."""

import re

import pytest

from fbgen.artefacts import with_artefacts
from fbgen.catalog import load_catalog
from fbgen.diagnostics import DiagnosticError, Severity
from fbgen.emit.generated import GeneratedSet
from fbgen.emit.generator import generate
from fbgen.plant import Plant, read_plant
from fbgen.resources import shipped
from fbgen.source import Source

CATALOG = load_catalog()
EXAMPLE = (shipped("examples") / "pbdp110" / "plant.yaml").read_text("utf-8")
LINE = """\
  - name: gw2
    type: tospbdp001
    layout: gsd10
    profibus_address: 4
    access: per_identifier
    input_address: 256
    output_address: 256
    drives:
      - {name: mixer, inv_no: 1, series: vf-s11, max_frequency_hz: 50.0}
"""


def plant(text: str) -> Plant:
    return read_plant(Source("plant.yaml", text))


def names(text: str) -> set[str]:
    return {block.name for block in generate(plant(text), CATALOG).blocks}


@pytest.fixture(scope="module")
def example() -> GeneratedSet:
    return with_artefacts(generate(plant(EXAMPLE), CATALOG), plant(EXAMPLE), CATALOG)


def content(files: GeneratedSet, name: str) -> str:
    return files.contents[name].decode("utf-8")


def test_a_plant_has_only_the_families_that_it_needs() -> None:
    alone = names(EXAMPLE)
    assert {"PBDP_Drive", "PBDP_Parameter", "TOS_Main", "TOS_HzToWord"} <= alone
    assert not alone & {"TOS_Line", "TOS_Drive", "typeTosDrive", "TOS_TripText"}
    both = names(EXAMPLE + LINE)
    assert {"PBDP_Drive", "PBDP_Gateway_gw1", "TOS_Line", "TOS_Gateway_gw2"} <= both


def test_a_module_without_parameter_channel_needs_no_block_for_it() -> None:
    assert not names(EXAMPLE.replace("module2", "module4")) & {
        "PBDP_Parameter",
        "PBDP_Poll",
        "PBDP_TripText_vf_s11",
    }


def test_main_calls_the_gateways_of_both_families_in_the_order_of_the_plant() -> None:
    files = {file.name: file.text for file in generate(plant(EXAMPLE + LINE), CATALOG).files}
    main = files["TOS_Main.scl"]
    assert 0 < main.index('"PBDP_Gateway_gw1_DB"(') < main.index('"TOS_Gateway_gw2_DB"(')


def test_a_prefix_keeps_the_family_behind_it() -> None:
    found = names(EXAMPLE.replace("cycle_time_ms", "prefix: HALL_\ncycle_time_ms") + LINE)
    assert {"HALL_Main", "HALL_PBDP_Drive", "typeHallPbdpDrive", "HALL_Line"} <= found
    assert not [name for name in found if name.startswith(("TOS_", "PBDP_", "typePbdp"))]


def test_what_is_inferred_is_called_unverified_in_the_blocks(example: GeneratedSet) -> None:
    parameter = content(example, "PBDP_Parameter.scl")
    assert "Unverified: the bits of the request." in parameter
    assert "// Unverified: the bit names are lost in the text of the manual at hand." in parameter
    assert "Unverified: the GSD file is not public" in content(example, "PBDP_Io_gw1.scl")


def test_identifiers_of_the_plant_file_are_not_called_unverified() -> None:
    text = EXAMPLE.replace("layout: module2", "layout: module2\n    identifiers: C0 CF D7")
    files = {file.name: file.text for file in generate(plant(text), CATALOG).files}
    assert "Unverified" not in files["PBDP_Io_gw1.scl"]


def test_where_a_cycle_may_fall_between_two_accesses_their_order_is_safe() -> None:
    """Offsets of tables 1 and 4: what depends on other words is written last and read first."""
    by_words = EXAMPLE.replace("layout: module2", "layout: module2\n    identifiers: 6F 5F 57")
    by_words = by_words.replace("dpxx_dat", "per_identifier").replace(
        "hardware_identifier: 270", "input_address: 256\n    output_address: 512"
    )
    files = {file.name: file.text for file in generate(plant(by_words), CATALOG).files}
    accesses = re.findall(r"%([IQ])[BW](\d+):P", files["PBDP_Io_gw1.scl"])
    read = [int(address) - 256 for area, address in accesses if area == "I"]
    written = [int(address) - 512 for area, address in accesses if area == "Q"]
    for drive in (0, 16):
        frequency, command = written.index(drive + 6), written.index(drive + 2)
        assert frequency < command
        data, number = written.index(drive + 14), written.index(drive + 10)
        assert max(data, number) < written.index(drive + 8)
    for drive in (0, 24):
        number, data = read.index(drive + 18), read.index(drive + 22)
        assert read.index(drive + 16) < min(number, data)


@pytest.mark.parametrize(
    ("dialect", "plc", "call"),
    [
        ("tia", "s7-1500", "DPNRM_DG(REQ := TRUE, LADDR := 2046, "),
        ("tia", "s7-1200", "DPNRM_DG(REQ := TRUE, LADDR := 2046, "),
        ("tia", "s7-300", "DPNRM_DG(REQ := TRUE, LADDR := W#16#7FE, "),
        ("step7", "s7-400", "SFC13(REQ := TRUE, LADDR := W#16#7FE, "),
        ("iec", "iec", ""),
        ("twincat", "twincat", ""),
    ],
)
def test_an_s7_reads_the_diagnosis_where_its_address_is_given(
    dialect: str, plc: str, call: str
) -> None:
    text = EXAMPLE.replace("dialect: tia", f"dialect: {dialect}").replace("s7-1500", plc)
    text = text.replace("dpxx_dat", "process_image").replace(
        "hardware_identifier: 270", "input_address: 64\n    output_address: 64"
    )
    if plc.startswith("s7-"):
        text = text.replace("process_image", "dpxx_dat\n    hardware_identifier: 270")
    without = "".join(file.text for file in generate(plant(text), CATALOG).files)
    assert "DPNRM_DG" not in without
    text = text.replace("layout: module2", "layout: module2\n    diagnosis_address: 2046")
    with_it = "".join(file.text for file in generate(plant(text), CATALOG).files)
    assert (call in with_it) if call else ("PBDP_Diagnosis" not in with_it)


def test_leave_to_write_the_eeprom_is_a_warning_at_its_place() -> None:
    text = EXAMPLE.replace("layout: module2", "layout: module2\n    eeprom: true")
    (found,) = generate(plant(text), CATALOG).warnings
    assert (found.code, found.severity) == ("FB5005", Severity.WARNING)
    assert found.span is not None
    assert found.span.text == "true"
    assert not generate(plant(EXAMPLE), CATALOG).warnings


def test_two_types_of_gateways_for_process_data_are_fb5009() -> None:
    entry = CATALOG.process_data_gateway("pbdp110").model_copy(update={"id": "ours"})
    catalog = CATALOG.__class__(
        CATALOG.drives,
        {**CATALOG.gateways, "ours": entry},
        CATALOG.protocols,
        CATALOG.sequences,
        sources=CATALOG.sources,
    )
    text = EXAMPLE + EXAMPLE[EXAMPLE.index("  - name: gw1") :].replace("gw1", "gw2").replace(
        "pbdp110", "ours"
    ).replace("address: 3", "address: 5").replace("270", "271").replace("pump", "p2").replace(
        "fan", "f2"
    )
    with pytest.raises(DiagnosticError) as failure:
        generate(read_plant(Source("plant.yaml", text), catalog), catalog)
    assert [item.code for item in failure.value.diagnostics] == ["FB5009"]


def test_series_that_count_in_other_units_are_fb5013() -> None:
    series = CATALOG.drive("vf-s11")
    setpoint = series.comno(series.link.setpoint)
    coarse = setpoint.model_copy(update={"resolution": 0.1})
    numbers = tuple(coarse if item is setpoint else item for item in series.comnos)
    other = series.model_copy(update={"id": "coarse", "comnos": numbers})
    gateway = CATALOG.process_data_gateway("pbdp110")
    served = gateway.model_copy(update={"series": (*gateway.series, "coarse")})
    catalog = CATALOG.__class__(
        {**CATALOG.drives, "coarse": other},
        {**CATALOG.gateways, "pbdp110": served},
        CATALOG.protocols,
        CATALOG.sequences,
        sources=CATALOG.sources,
    )
    text = EXAMPLE.replace("channel: B, series: vf-s11", "channel: B, series: coarse")
    with pytest.raises(DiagnosticError) as failure:
        generate(read_plant(Source("plant.yaml", text), catalog), catalog)
    (found,) = failure.value.diagnostics
    assert found.code == "FB5013"
    assert found.span is not None
    assert found.span.text == "coarse"


def test_the_lists_beside_it_name_channels_and_its_own_alarms(example: GeneratedSet) -> None:
    alarms = content(example, "pbdp110_alarms.csv")
    assert "gw1_pump_lost" in alarms
    assert "gw1_pump_parameter_failed" in alarms
    assert "telegram_errors" not in alarms
    assert '"TOS_Plant".gw1.fan.polled.tripCode' in content(example, "pbdp110_watch.csv").replace(
        '""', '"'
    )
    sheets = content(example, "pbdp110_parameters.md")
    assert "channel B" in sheets
    assert "F800" not in sheets.split("## Gateway")[1]
    readme = content(example, "README.md")
    assert "The identifiers of gw1 are an assumption." in readme
    assert "watchdog of the slave must be on" in readme
    assert "| gw1 | fan | B | vf-s11 | 50 Hz |" in readme
    assert "F801" not in readme


def test_the_address_switches_are_told_one_by_one(example: GeneratedSet) -> None:
    sheets = content(example, "pbdp110_parameters.md")
    assert "| SW1 | Address switches, ON is down | **ON** |" in sheets
    assert "| SW3 | Address switches, ON is down | **OFF** |" in sheets
