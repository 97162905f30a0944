"""The PBDP-110 in the catalogue against the second reading of its manual in tests/vectors."""

from pathlib import Path
from typing import Any

import pytest

from fbgen.catalog import Layout, ProcessDataGateway, load_catalog, load_yaml, validate
from fbgen.diagnostics import DiagnosticError
from fbgen.resources import shipped
from fbgen.source import Source
from tests.vectors.reading import entries

ENTRIES = entries("pbdp110_words")
CATALOG = load_catalog()
FILE = shipped("catalog") / "gateways" / "pbdp110.yaml"
GATEWAY = CATALOG.process_data_gateway("pbdp110")

NAMES = {
    "command": "command",
    "frequency command": "frequency",
    "Reserved / action bits": "action",
    "parameter number": "number",
    "parameter data to write": "data",
    "status": "status",
    "output frequency": "frequency",
    "output current": "current",
    "output voltage": "voltage",
    "Reserved / response bits": "response",
    "parameter number response": "number",
    "parameter data response": "data",
}
"""What the manual calls the data of a drive -> our field, after the name of the channel."""


def _modules() -> list[Any]:
    return [
        pytest.param(entry, number, length, id=f"{side} of module {number}")
        for side in ("output", "input")
        for pair in ("1_2", "3_4")
        for entry in [ENTRIES[f"pbdp.{side}.module_{pair}"]]
        for number, length in entry["modules"].items()
    ]


def _fields(layout: Layout, entry: dict[str, Any]) -> tuple[Any, int]:
    if entry["direction"] == "master to slave":
        return layout.output, layout.output_length
    return layout.input, layout.input_length


@pytest.mark.fact("pb.layouts")
@pytest.mark.parametrize(("entry", "number", "length"), _modules())
def test_every_row_of_the_data_tables_is_in_the_layout(
    entry: dict[str, Any], number: int, length: int
) -> None:
    fields, ours = _fields(GATEWAY.layout(f"module{number}"), entry)
    assert ours == length
    by_start = {field.offset: field for field in fields}
    offsets = entry["drive_offsets"]
    channels = [name for name in offsets if offsets[name] < length]
    for channel in channels:
        for row in entry["fields"]:
            at = offsets[channel] + row["offset"]
            if row["name"] == "Reserved":
                covered = [field for field in fields if field.offset <= at < field.end]
                assert covered[0].pad or at == covered[0].offset + 1, at
                continue
            field = by_start[at]
            assert field.name == f"{channel.lower()}_{NAMES[row['name']]}"
            assert not field.pad
    assert [item.name.upper() for item in GATEWAY.channels_of(GATEWAY.layout(f"module{number}"))] \
        == channels  # fmt: skip


@pytest.mark.parametrize("side", ["output", "input"])
def test_every_cyclic_value_is_the_drives_cell_of_the_manual(side: str) -> None:
    theirs = {
        NAMES[row["name"]]: int(row["comno"], 16)
        for row in ENTRIES[f"pbdp.{side}.module_3_4"]["fields"]
    }
    ours = GATEWAY.outputs if side == "output" else GATEWAY.inputs
    assert {item.field: item.comno for item in ours} == theirs


def test_modules_1_and_2_have_a_parameter_channel_and_the_compact_ones_none() -> None:
    assert [GATEWAY.has_parameter_channel(item) for item in GATEWAY.layouts] == [
        *(True, True, False, False)
    ]


@pytest.mark.parametrize(
    ("entry", "ours"),
    [
        ("pbdp.request_codes", GATEWAY.parameter_channel.requests),
        ("pbdp.response_codes", GATEWAY.parameter_channel.responses),
    ],
)
def test_request_and_response_codes_are_those_of_the_manual(entry: str, ours: Any) -> None:
    names = {
        "No action (idle state)": "idle",
        "No action (idle state acknowledge)": "idle",
        "Parameter read": "read",
        "Parameter read success acknowledge": "read",
        "Parameter write (RAM & EEPROM)": "write_eeprom",
        "Parameter write (RAM only)": "write_ram",
        "Parameter write success acknowledge": "written",
        "Error indication": "error",
    }
    theirs = {
        row["high"] * 2 + row["low"]: names[row["meaning"]] for row in ENTRIES[entry]["codes"]
    }
    assert {item.code: item.name for item in ours} == theirs


def test_a_write_keeps_the_value_where_its_request_says() -> None:
    access = GATEWAY.parameter_channel
    assert {item.name: item.memory for item in access.requests} == {
        "idle": None, "read": None, "write_eeprom": "eeprom", "write_ram": "ram",
    }  # fmt: skip


ERROR_TITLES = {
    "cannot execute": "Cannot execute",
    "data error (written data value outside of valid range)": (
        "Written value outside the valid range"
    ),
    "invalid parameter number": "Invalid parameter number",
    "attempt to write to a read-only parameter": "Attempt to write a read-only parameter",
    "attempt to read from a write-only parameter": "Attempt to read a write-only parameter",
    "other / unclassified error": "Other error",
}
"""What the manual's list of error codes says -> what ours says, as it stands in the blocks."""


def test_error_codes_are_those_of_the_manual() -> None:
    theirs = [int(row["code"], 16) for row in ENTRIES["pbdp.error_codes"]["codes"]]
    assert [item.code for item in GATEWAY.parameter_channel.errors] == theirs
    titles = [row["meaning"] for row in ENTRIES["pbdp.error_codes"]["codes"]]
    assert [ERROR_TITLES[title] for title in titles] == [
        item.title for item in GATEWAY.parameter_channel.errors
    ]
    names = ("cannot_execute", "data_error", "invalid_number", "read_only", "write_only", "other")
    assert [GATEWAY.parameter_channel.error(name).code for name in names] == theirs


def test_the_firmware_is_a_parameter_of_the_interface_itself() -> None:
    theirs = [int(row["comno"], 16) for row in ENTRIES["pbdp.firmware"]["comnos"]]
    assert [item.number for item in GATEWAY.parameter_channel.local] == theirs


def test_request_and_response_stand_in_bits_13_and_12() -> None:
    """Other copies of the manual than the one in the vectors have these bit numbers."""
    assert GATEWAY.word("action").field("request").mask == 0x3000
    assert GATEWAY.word("response").field("response").mask == 0x3000


@pytest.mark.parametrize("example", ["forward", "reverse", "stop", "reset"])
def test_the_command_examples_come_out_of_the_names_of_bits(example: str) -> None:
    entry = ENTRIES[f"pbdp.example.{example}"]
    word = GATEWAY.word("command")
    names = [field.name for field in word.bits if field.low in entry["set_bits"]]
    assert len(names) == len(entry["set_bits"])
    assert f"{word.encode(names):04X}" == entry["word"]


BITS = {
    "Command source": ("network_command", "local", "network"),
    "Frequency command source": ("network_frequency", "local", "network"),
    "Fault reset": ("fault_reset", "no", "reset"),
    "Emergency OFF command": ("emergency_stop", "no", "emergency off"),
    "Coast stop command": ("coast_stop", "no", "coast stop"),
    "Run / stop command": ("run", "stop", "run"),
    "Forward / reverse selection": ("reverse", "forward", "reverse"),
    "Jog command": ("jog", "no", "jog run"),
    "DC injection braking": ("dc_braking", "no", "DC injection braking"),
    "Accel / decel #1/#2 selection": ("pattern_2", "pattern 1", "pattern 2"),
    "Preset speed 4": ("preset_speed_4", "off", "on"),
    "Preset speed 3": ("preset_speed_3", "off", "on"),
    "Preset speed 2": ("preset_speed_2", "off", "on"),
    "Preset speed 1": ("preset_speed_1", "off", "on"),
    "Drive online / offline status": ("online", "offline, or searching for the drive", "online"),
    "Run / stop status": ("running", "stopped", "running"),
    "Forward / reverse status": ("reverse", "forward", "reverse"),
    "Jog status": ("jog", "no", "jogging"),
    "DC injection braking status": ("dc_braking", "no", "DC injection braking"),
    "Accel / decel #1/#2 status": ("pattern_2", "pattern 1", "pattern 2"),
}
"""What the manual's tables 3 and 6 call a bit -> our name of it, and of its values 0 and 1."""


@pytest.mark.parametrize("name", ["command", "status"])
def test_every_bit_of_the_words_is_the_manuals_with_its_meaning(name: str) -> None:
    rows = ENTRIES[f"pbdp.{name}_word"]["bits"]
    theirs = {row["bit"]: BITS[row["name"]] for row in rows if row["name"] != "Reserved"}
    bits = GATEWAY.word(name).bits
    assert {bit.low: (bit.name, bit.values[0], bit.values[1]) for bit in bits} == theirs
    online = GATEWAY.word("status").field("online")
    assert (online.low, online.values[0][:7], online.values[1]) == (15, "offline", "online")


@pytest.mark.parametrize(
    "example", ENTRIES["pbdp.address"]["examples"], ids=lambda item: item["switches"]
)
def test_the_address_switches_stand_as_in_the_manuals_table(example: dict[str, Any]) -> None:
    stands = [item.position(example["address"]) for item in GATEWAY.switches if item.adds]
    assert stands == ["ON" if digit == "1" else "OFF" for digit in example["switches"]]
    assert [item.stands for item in GATEWAY.switches if not item.adds] == ["OFF"]


def test_the_profibus_side_is_that_of_the_manual() -> None:
    facts, theirs = GATEWAY.profibus, ENTRIES["pbdp.address"]
    assert (facts.minimum_address, facts.maximum_address) == (theirs["lowest"], theirs["highest"])
    assert (facts.sync, facts.freeze, facts.auto_baud) == (True, True, True)
    assert not facts.set_slave_address


def test_what_no_document_tells_is_marked() -> None:
    assert all(item.unverified == ("identifiers",) for item in GATEWAY.layouts)
    assert GATEWAY.option("ident_number").status == "unverified"
    assert GATEWAY.option("bus_lost").status == "unverified"
    assert GATEWAY.autoscan.status == "unverified"
    assert GATEWAY.word("action").status_of(GATEWAY.word("action").field("request")) == "unverified"


def test_a_gateway_of_the_other_kind_is_refused() -> None:
    with pytest.raises(DiagnosticError) as raised:
        CATALOG.telegram_gateway("pbdp110")
    assert [found.code for found in raised.value.diagnostics] == ["FB1206"]
    with pytest.raises(DiagnosticError) as raised:
        CATALOG.process_data_gateway("tospbdp001")
    (found,) = raised.value.diagnostics
    assert (found.code, found.help) == ("FB1206", "a gateway for process data is pbdp110")


def test_a_kind_that_is_not_there_is_named_at_its_place(tmp_path: Path) -> None:
    folder = tmp_path / "gateways"
    folder.mkdir()
    (folder / "mine.yaml").write_text("version: 1\nkind: telegram\n", encoding="utf-8")
    with pytest.raises(DiagnosticError) as raised:
        load_catalog([tmp_path])
    found = raised.value.diagnostics[0]
    assert found.code == "FB1007"
    assert found.span is not None
    assert (found.span.line, found.span.column) == (2, 7)
    assert "telegrams" in found.help


def test_a_field_of_no_channel_is_refused() -> None:
    named = FILE.read_text("utf-8")
    text = named.replace("{name: b_voltage, offset: 14,", "{name: c_voltage, offset: 14,")
    with pytest.raises(DiagnosticError) as raised:
        validate(load_yaml(Source("pbdp110.yaml", text)), ProcessDataGateway)
    (found,) = raised.value.diagnostics
    assert found.code == "FB1105"
    assert "'c_voltage' is none that a channel" in found.message
    assert found.span is not None
    assert found.span.text == "c_voltage"
