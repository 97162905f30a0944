"""The catalogue against the second reading of the manuals in tests/vectors.

The names on both sides were chosen by different people, so each comparison spells out which name
stands for which. A bit or figure that differs is looked up in the manual.
"""

from typing import Any

import pytest

from fbgen.catalog import WriteStep, load_catalog
from tests.vectors.reading import FOLDER, entries

CATALOG = load_catalog()
GATEWAY = CATALOG.telegram_gateway("tospbdp001")
DRIVE = CATALOG.drive("vf-s11")
PROTOCOL = CATALOG.toshiba_protocol("toshiba")


def _entries() -> dict[str, dict[str, Any]]:
    found = {}
    for path in sorted(FOLDER.glob("*.yaml")):
        found |= entries(path.stem)
    return found


ENTRIES = _entries()

COMMAND = [
    "preset_speed_1", "preset_speed_2", "preset_speed_3", "preset_speed_4", "motor_2",
    "pi_control_off", "pattern_2", "dc_braking", "jog", "reverse", "run", "coast_stop",
    "emergency_stop", "fault_reset", "network_frequency", "network_command",
]  # fmt: skip
"""Our names for what the entries below call bit 0 to bit 15 (checked by the words beside them)."""

NAMES = {
    # VF-AS1, table 1, and the fragments of the DEV003Z-1 manual
    "Preset speed operation frequencies 1": "preset_speed_1",
    "Preset speed operation frequencies 2": "preset_speed_2",
    "Preset speed operation frequencies 3": "preset_speed_3",
    "Preset speed operation frequencies 4": "preset_speed_4",
    "Motor selection (1 or 2) (THR 2 selection)": "motor_2",
    "PI control": "pi_control_off",
    "PI(D) control": "pi_control_off",
    "Acceleration/deceleration pattern selection (1 or 2) (AD2 selection)": "pattern_2",
    "DC braking": "dc_braking",
    "Jog run": "jog",
    "Forward/reverse run selection": "reverse",
    "Run/stop": "run",
    "Coast stop command": "coast_stop",
    "Emergency stop": "emergency_stop",
    "Fault reset": "fault_reset",
    "Frequency priority selection": "network_frequency",
    "Command priority selection": "network_command",
    # PBDP-110
    "Command source": "network_command",
    "Frequency command source": "network_frequency",
    "Emergency OFF command": "emergency_stop",
    "Run / stop command": "run",
    "Forward / reverse selection": "reverse",
    "Jog command": "jog",
    "DC injection braking": "dc_braking",
    "Accel / decel #1/#2 selection": "pattern_2",
    "Preset speed 1": "preset_speed_1",
    "Preset speed 2": "preset_speed_2",
    "Preset speed 3": "preset_speed_3",
    "Preset speed 4": "preset_speed_4",
}
STATUS_NAMES = {
    "Run / stop status": "running",
    "Forward / reverse status": "reverse",
    "Jog status": "jog",
    "DC injection braking status": "dc_braking",
    "Accel / decel #1/#2 status": "pattern_2",
    "Coast stop (ST=OFF)": "coast_stopped",
    "Emergency stop": "emergency_stopped",
    "Standby ST=ON": "standby_st_on",
    "Standby": "standby",
}
TERMINALS = {"F": "f", "R": "r", "RES": "res", "S1": "s1", "S2": "s2", "S3": "s3"}

TABLES = [
    ("as1.command_word", "vf-s11.FA00", NAMES, 16),
    ("pbdp.command_word", "vf-s11.FA00", NAMES, 14),
    ("dev.fa06", "vf-s11.FA00", NAMES, 4),
    ("pbdp.status_word", "vf-s11.FE01", STATUS_NAMES, 5),
    ("dev.fd01", "vf-s11.FD01", STATUS_NAMES, 4),
    ("dev.fd06", "vf-s11.FD06", TERMINALS, 6),
]


@pytest.mark.parametrize(("entry", "path", "names", "count"), TABLES)
def test_every_bit_of_the_manual_has_its_place_in_the_catalogue(
    entry: str, path: str, names: dict[str, str], count: int
) -> None:
    word = CATALOG.word(path)
    ours = {field.low: field.name for field in word.bits}
    compared = {
        bit["bit"]: names[bit["name"]] for bit in ENTRIES[entry]["bits"] if bit["name"] in names
    }
    assert {bit: ours.get(bit) for bit in compared} == compared
    assert len(compared) == count


def test_only_what_the_tables_do_not_define_is_left_out_of_the_comparison() -> None:
    left_out = {
        (entry, bit["bit"], bit["name"])
        for entry, _, names, _ in TABLES
        for bit in ENTRIES[entry]["bits"]
        if bit["name"] not in names
    }
    reserved = {(entry, bit) for entry, bit, name in left_out if name == "Reserved"}
    assert reserved == {("pbdp.command_word", bit) for bit in (4, 5)} | {
        ("pbdp.status_word", bit) for bit in (0, 1, 2, 3, 4, 5, 11, 12, 13, 14)
    }
    others = {(entry, bit) for entry, bit, name in left_out if name != "Reserved"}
    assert others == {("pbdp.status_word", 15), ("dev.fd01", 10)}


@pytest.mark.parametrize(
    ("entry", "bits"),
    [
        (key, entry["set_bits"])
        for key, entry in ENTRIES.items()
        if entry["kind"] == "word_example" and entry.get("comno") == "FA00" and "set_bits" in entry
    ],
)
def test_command_words_of_the_manuals_come_out_of_the_bit_names(
    entry: str, bits: list[int]
) -> None:
    names = [COMMAND[bit] for bit in bits]
    assert f"{DRIVE.command_word.encode(names):04X}" == ENTRIES[entry]["word"]


def test_the_status_word_shows_no_error_in_all_four_trouble_free_states() -> None:
    for entry in ("tos.8a.status_states", "tos.8a.power_on"):
        for state in ENTRIES[entry]["states"]:
            word = int(state["word"], 16)
            fields = {item.field.name: item.value for item in GATEWAY.status_word.decode(word)}
            assert fields["status_code"] == 0x1F
            assert fields["status_data"] == 0
            assert fields["data_valid"] == 0
            assert fields["status_changed"] == int(state["bits"][0])
            assert fields["command_done"] == int(state["bits"][1])
    assert f"{GATEWAY.power_on_status:04X}" == ENTRIES["tos.8a.power_on"]["states"][0]["word"]


def test_handshake_bits_are_those_of_the_table() -> None:
    shake = GATEWAY.handshake
    by_gateway = {item["bit"] for item in ENTRIES["tos.8a.handshake"]["bits"] if
                  item["toggled_by"] == "gateway"}  # fmt: skip
    by_plc = {item["bit"] for item in ENTRIES["tos.8a.handshake"]["bits"]} - by_gateway
    assert {GATEWAY.status_word.field(shake.status_changed).low} == by_gateway
    assert {GATEWAY.control.field(shake.status_taken).low} == by_gateway
    assert {GATEWAY.control.field(shake.command_new).low} == by_plc
    assert {GATEWAY.status_word.field(shake.command_done).low} == by_plc


FIELDS = {
    "Control": "control",
    "Trigger": "trigger",
    "INV-NO": "inv_no",
    "CMD": "cmd",
    "ComNo": "comno",
    "DATA": "data",
    "Status": "status",
}


@pytest.mark.parametrize(("entry", "side"), [("tos.layout.send", "output"),
                                             ("tos.layout.receive", "input")])  # fmt: skip
def test_doc9_is_the_layout_of_the_tables(entry: str, side: str) -> None:
    layout = GATEWAY.layout("doc9")
    ours = {field.name: (field.offset, field.length) for field in getattr(layout, side)}
    theirs = {
        FIELDS[field["name"]]: (
            field["first_byte"] - 1,
            field["last_byte"] - field["first_byte"] + 1,
        )
        for field in ENTRIES[entry]["fields"]
    }
    assert ours == theirs
    assert getattr(layout, f"{side}_length") == ENTRIES[entry]["length"]


def test_gsd10_has_the_identifiers_of_the_printed_gsd_file() -> None:
    layout = GATEWAY.layout("gsd10")
    decoded = ENTRIES["tos.gsd.module.decoded"]
    assert layout.identifiers == bytes.fromhex(ENTRIES["tos.gsd.module"]["identifiers"])
    parsed = layout.parsed_identifiers
    assert [item.output_length for item in parsed] == decoded["to_slave_bytes"]
    assert [item.input_length for item in parsed] == decoded["to_master_bytes"]
    assert not any(item.consistent for item in parsed if item.output_length > item.unit_length)


def test_the_profibus_facts_are_those_of_the_gsd_file() -> None:
    gsd = {item["keyword"]: item["value"] for item in ENTRIES["tos.gsd.keywords"]["keywords"]}
    facts = GATEWAY.profibus
    assert facts.ident_number == gsd["Ident_Number"]
    assert facts.sync == bool(gsd["Sync_Mode_supp"])
    assert facts.freeze == bool(gsd["Freeze_Mode_supp"])
    assert facts.fail_safe == bool(gsd["Fail_Safe"])
    assert facts.auto_baud == bool(gsd["Auto_Baud_supp"])
    assert facts.set_slave_address == bool(gsd["Set_Slave_Add_supp"])
    assert facts.max_diagnosis_bytes == gsd["Max_Diag_Data_Len"]
    assert facts.min_slave_interval_us == gsd["Min_Slave_Intervall"] * 100
    assert {f"MaxTsdr_{rate}": bits for rate, bits in facts.max_tsdr_bits.items()} == {
        keyword: value for keyword, value in gsd.items() if keyword.startswith("MaxTsdr_")
    }
    assert facts.default_address == ENTRIES["tos.3.address.factory"]["address"]


def test_the_lamps_show_what_the_manual_lists() -> None:
    lights = {
        "off": "off",
        "green": "green",
        "red": "red",
        "green flashing": "green_flashing",
        "red flashing": "red_flashing",
        "red flashing 1 Hz": "red_1hz",
        "red flashing 2 Hz": "red_2hz",
        "red flashing 4 Hz": "red_4hz",
        "alternating red and green": "red_green_alternating",
    }
    theirs = {
        (led["led"], lights[state["state"]], state["normal"])
        for led in ENTRIES["tos.3.leds"]["leds"]
        for state in led["states"]
    }
    ours = {(led.number, state.light, state.normal) for led in GATEWAY.leds for state in led.states}
    assert ours == theirs
    assert [led.number for led in GATEWAY.leds] == [1, 2, 3, 4, 5, 6]


def test_times_are_those_of_the_manual() -> None:
    assert GATEWAY.times.processing.ms == ENTRIES["tos.9.gateway_time"]["typical_ms"]
    assert GATEWAY.times.heartbeat.ms == ENTRIES["tos.7.heartbeat"]["typical_ms"]
    assert GATEWAY.times.total_min.ms == ENTRIES["tos.9.total"]["minimum_ms"]
    assert GATEWAY.times.total_max.ms == ENTRIES["tos.9.total"]["maximum_ms"]
    assert DRIVE.times.reply_max.ms == ENTRIES["tos.9.reply.vf_s11"]["maximum_ms"]


def test_the_line_is_that_of_the_manual() -> None:
    theirs = ENTRIES["tos.1.subnet"]
    ours = GATEWAY.subnetwork
    names = ("baud", "parity", "data_bits", "stop_bits", "wires")
    assert {name: getattr(ours, name) for name in names} == {name: theirs[name] for name in names}


def test_the_trigger_counts_as_the_manual_recommends() -> None:
    counter = ENTRIES["tos.8b.counter"]
    assert (GATEWAY.trigger.first, GATEWAY.trigger.last) == (counter["minimum"], counter["maximum"])
    assert GATEWAY.trigger.power_on == ENTRIES["tos.8b.power_on"]["value"]


@pytest.mark.parametrize("entry", ["tos.8d.commands", "tip.commands"])
def test_commands_have_the_codes_of_the_manuals(entry: str) -> None:
    codes = {command.code: command for command in PROTOCOL.commands}
    for theirs in ENTRIES[entry]["commands"]:
        if theirs["ascii"] in "XY":
            continue  # block communication is not in the catalogue of this protocol's first form
        ours = codes[int(theirs["hex"], 16)]
        assert ours.letter == theirs["ascii"]
        assert ours.writes == (not theirs["action"].startswith("read"))
        if theirs.get("acknowledged") is False:
            assert ours.reply_code is None


def test_errors_have_the_codes_of_the_manuals() -> None:
    theirs = {int(entry["code"], 16) for key, entry in ENTRIES.items()
              if key.startswith("tip.error.") and entry["kind"] == "error_code"}  # fmt: skip
    assert {error.code for error in PROTOCOL.errors} == theirs


def test_communication_numbers_of_the_gateways_manual_are_in_the_catalogue() -> None:
    for entry in ("tos.8e.comnos", "tos.7.fc90", "tos.8g.comnos"):
        for theirs in ENTRIES[entry]["comnos"]:
            assert DRIVE.comno(theirs["comno"]).status == "verified"


def test_parameters_to_be_set_for_the_gateway_are_possible() -> None:
    by_display = {comno.display: comno for comno in DRIVE.comnos}
    for theirs in ENTRIES["tos.6.parameters.s9_s11_nc1"]["parameters"]:
        comno = by_display[theirs["parameter"]]
        assert (comno.effect == "after_restart") == theirs["restart"]
        if theirs["value"] is not None:
            assert comno.minimum_word <= theirs["value"] <= comno.maximum_word


@pytest.mark.parametrize("entry", ["tos.g.current", "tos.8f.maximum_frequency"])
def test_scaling_gives_the_words_of_the_manual(entry: str) -> None:
    theirs = ENTRIES[entry]
    comno = DRIVE.comno("FE03" if theirs["quantity"] == "current" else "maximum_frequency")
    assert comno.resolution == theirs["unit_step"]
    assert f"{comno.to_word(theirs['value']):04X}" == theirs["word"]


def test_the_manuals_example_has_the_telegrams_of_the_manual() -> None:
    sequence = CATALOG.sequence("manual_example")
    rows = [ENTRIES[f"tos.g.row{number}"] for number in range(1, 5)]
    assert [(item.output, item.input) for item in sequence.telegrams] == [
        (row["send"], row["receive"]) for row in rows
    ]


def test_the_manuals_example_writes_the_words_of_its_telegrams() -> None:
    sequence = CATALOG.sequence("manual_example")
    written = {
        number: (DRIVE.comno(step.write).number, step.literal)
        for number, step in enumerate(sequence.steps, 1)
        if isinstance(step, WriteStep)
    }
    telegrams = {item.step: item.output_bytes for item in sequence.telegrams}
    assert written == {
        number: ((data[5] or 0) << 8 | (data[6] or 0), (data[7] or 0) << 8 | (data[8] or 0))
        for number, data in telegrams.items()
        if number in written
    }
    assert written.keys() == {1, 2, 5}
