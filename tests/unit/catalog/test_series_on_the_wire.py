"""VF-AS1, VF-S15 and VF-MB1 against the second reading of their manuals in tests/vectors."""

from pathlib import Path
from typing import Any

import pytest
import yaml

from fbgen.catalog import (
    Communication,
    Drive,
    SerialPort,
    ToshibaService,
    load_catalog,
    load_yaml,
    validate,
)
from fbgen.catalog.kinship import with_relative
from fbgen.diagnostics import DiagnosticError
from fbgen.source import Source
from tests.unit.catalog.test_catalog_vectors import ENTRIES, NAMES, STATUS_NAMES, TERMINALS

CATALOG = load_catalog()
AS1, S15, MB1 = (CATALOG.drive(name) for name in ("vf-as1", "vf-s15", "vf-mb1"))
OTHERS = (AS1, S15, MB1)

COMMAND_2 = {
    "Control switching": (0, "torque_control"),
    "Electric power quantity reset": (1, "power_reset"),
    "Braking request (BC)": (3, "brake_request"),
    "Preliminary excitation": (4, "preliminary_excitation"),
    "Brake release (B)": (5, "brake_release"),
    "Braking answer (BA)": (6, "brake_answer"),
    "Maximum deceleration forced stop": (7, "quick_stop"),
    "Acceleration/deceleration pattern selection 1": (8, "pattern"),
    "Acceleration/deceleration pattern selection 2": (9, "pattern"),
}


def _properties(entry: str) -> dict[str, Any]:
    return {row["name"]: row["value"] for row in ENTRIES[entry]["properties"]}


def _of(drive: Drive) -> Communication:
    assert drive.communication is not None
    return drive.communication


def _toshiba(drive: Drive) -> ToshibaService:
    service = _of(drive).toshiba
    assert service is not None
    return service


# The command word of the VF-AS1


def test_both_command_words_of_the_vf_as1_have_the_bits_of_its_table() -> None:
    theirs = {bit["bit"]: NAMES[bit["name"]] for bit in ENTRIES["as1.command_word"]["bits"]}
    for number in ENTRIES["as1.command_word"]["comnos"]:
        word = CATALOG.word(f"vf-as1.{number}")
        assert {field.low: field.name for field in word.bits} == theirs
        assert {word.status_of(field) for field in word.bits} == {"verified"}


@pytest.mark.parametrize("example", ["forward", "reverse", "reverse_with_frequency"])
def test_the_words_of_its_examples_come_out_of_the_names(example: str) -> None:
    word = int(ENTRIES[f"as1.example.{example}"]["word"], 16)
    names = {item.field.name for item in AS1.command_word.decode(word) if item.value}
    assert names >= {"network_command", "run"}
    assert ("reverse" in names) is ("reverse" in example)
    assert ("network_frequency" in names) is (example == "reverse_with_frequency")
    assert AS1.command_word.encode(names) == word


def test_priorities_stay_until_one_of_four_things_happens() -> None:
    assert "until OFF is set, power is off or reset, or the" in ENTRIES["as1.priority_kept"][
        "statement"
    ].replace("\n", " ")
    for name in ("network_command", "network_frequency"):
        field = AS1.command_word.field(name)
        assert field.stays_until == ("cleared", "power_off", "reset", "factory_setting")
    staying = {field.name for field in AS1.command_word.bits if field.stays_until}
    assert staying == {"network_command", "network_frequency"}


def test_the_emergency_stop_needs_no_priority_and_running_does() -> None:
    word = AS1.command_word
    assert word.needs == "network_command"
    always = {field.name for field in word.bits if field.always}
    assert always == {"network_command", "network_frequency", "fault_reset", "emergency_stop"}
    (remark,) = [
        bit["remark"]
        for bit in ENTRIES["as1.command_word"]["bits"]
        if bit["name"] == "Emergency stop"
    ]
    assert remark.startswith("Always enabled")


def test_only_a_reset_is_not_answered() -> None:
    silent = {field.name for field in AS1.command_word.bits if not field.answered}
    unanswered = {
        NAMES[bit["name"]]
        for bit in ENTRIES["as1.command_word"]["bits"]
        if "No data is returned" in bit.get("remark", "")
    }
    assert silent == unanswered == {"fault_reset"}


def test_the_ramp_is_chosen_by_either_word() -> None:
    assert "ORed with bits 8 and 9 of FA20 and FA22" in ENTRIES["as1.pattern_or"]["statement"]
    assert AS1.command_word.field("pattern_2").ored_with == ("command_2.pattern",)
    pattern = AS1.word("command_2").field("pattern")
    assert (pattern.high, pattern.low) == (9, 8)
    assert pattern.ored_with == ("command.pattern_2",)
    second = AS1.command_word.field("pattern_2").parameters[1]
    assert [AS1.comno(name).display for name in second] == ["F500", "F501"]


def test_the_terminal_functions_that_have_priority_are_those_of_the_manual() -> None:
    theirs = {
        tuple(row["numbers"]) for row in ENTRIES["as1.terminal_over_communication"]["functions"]
    }
    ours = {(item.number, item.inverted) for item in AS1.terminal_functions}
    assert ours == theirs
    names = tuple(item.name for item in AS1.terminal_functions)
    assert AS1.command_word.overridden_by == AS1.word("command_2").overridden_by == names


def test_the_second_command_word_has_the_bits_of_the_manual() -> None:
    rows = {row["bit"]: row["name"] for row in ENTRIES["as1.command_2"]["bits"]}
    for number in ENTRIES["as1.command_2"]["comnos"]:
        word = CATALOG.word(f"vf-as1.{number}")
        ours = {bit: field.name for field in word.bits for bit in range(field.low, field.high + 1)}
        assert ours == dict(COMMAND_2[name] for name in rows.values() if name != "Reserved")
        assert word.needs == "command.network_command"


def test_each_port_of_the_vf_as1_has_command_words_of_its_own() -> None:
    ports = {f"{port.wires}-wire": port for port in _of(AS1).ports}
    for row in ENTRIES["as1.commands_by_port"]["comnos"]:
        port, comno = ports[row["port"]], AS1.comno(row["comno"])
        if row["meaning"] == "communication command":
            assert port.command == comno.name
        elif row["meaning"] == "frequency command":
            assert port.setpoint == comno.name
        else:
            assert comno.word == "command_2"
        assert comno.status == "verified"
    assert len(ports) == 2


# Monitors


@pytest.mark.parametrize("row", ENTRIES["as1.monitors"]["monitors"], ids=lambda row: row["comno"])
def test_a_monitor_of_the_vf_as1_has_its_unit_and_its_held_copy(row: dict[str, Any]) -> None:
    comno = AS1.comno(row["comno"])
    assert (comno.status, comno.access) == ("verified", "r")
    if row["unit_step"] is not None:
        assert (comno.resolution, comno.unit) == (row["unit_step"], row["unit"])
    if "held" in row:
        held = AS1.comno(row["held"])
        assert held.frozen_copy_of == comno.name
        assert (held.status, held.unit, held.resolution) == (
            "verified", comno.unit, comno.resolution,
        )  # fmt: skip


@pytest.mark.parametrize("row", ENTRIES["as1.index.status"]["comnos"], ids=lambda row: row["comno"])
def test_the_vf_as1_has_the_numbers_of_its_contents(row: dict[str, Any]) -> None:
    assert AS1.comno(row["comno"]).status == "verified"


@pytest.mark.parametrize("drive", [S15, MB1], ids=["vf-s15", "vf-mb1"])
@pytest.mark.parametrize(
    "row", ENTRIES["dev.monitor_choices"]["monitors"], ids=lambda row: row["comno"]
)
def test_the_options_monitors_are_there(drive: Drive, row: dict[str, Any]) -> None:
    number = "0880" if row["comno"] == "F880" else row["comno"]
    comno = drive.comno(number)
    assert comno.status == "verified"
    if row["unit_step"] is not None and "resolution" not in comno.unverified:
        assert comno.resolution == row["unit_step"]
    if row["unit"] is not None:
        assert comno.unit == {"hour": "h"}.get(row["unit"], row["unit"])


@pytest.mark.parametrize("drive", [S15, MB1], ids=["vf-s15", "vf-mb1"])
@pytest.mark.parametrize(
    ("entry", "names"),
    [("dev.fa06", NAMES), ("dev.fd01", STATUS_NAMES | {None: "running"}), ("dev.fd06", TERMINALS)],
)
def test_the_options_words_are_there(
    drive: Drive, entry: str, names: dict[str | None, str]
) -> None:
    for number in ENTRIES[entry]["comnos"]:
        word = CATALOG.word(f"{drive.id}.{number}")
        ours = {field.low: field for field in word.bits}
        for row in ENTRIES[entry]["bits"]:
            assert ours[row["bit"]].name == names[row["name"]]
            assert word.status_of(ours[row["bit"]]) == "verified"


# Lines


@pytest.mark.parametrize(
    ("series", "entry"), [("vf-s11", "s11.line"), ("vf-s15", "s15.line"), ("vf-as1", "as1.line")]
)
def test_rates_silences_and_times_are_those_of_the_manual(series: str, entry: str) -> None:
    drive, theirs = CATALOG.drive(series), _properties(entry)
    toshiba = _toshiba(drive)
    for port in _of(drive).ports:
        assert list(drive.baud_rates(port).values()) == theirs["rates"]
        _delivered_as(drive, port, theirs)
    assert toshiba.silence_characters == theirs.get("silence in characters")
    assert drive.times.boot.ms == theirs["start-up s"] * 1000
    assert drive.times.boot.status == "verified"
    if "reception time-out s" in theirs:
        assert toshiba.reception_timeout_ms == theirs["reception time-out s"] * 1000
        assert toshiba.max_frame_bytes == theirs["longest telegram"]
    if "greatest time-out s" in theirs:
        assert drive.comno("0803").maximum == theirs["greatest time-out s"]
        assert drive.comno("0804").maximum == theirs["greatest time-out action"]


def _delivered_as(drive: Drive, port: SerialPort, theirs: dict[str, Any]) -> None:
    rate, parity = drive.comno(port.baud_rate), drive.comno(port.parity)
    if "default rate" in theirs:
        assert drive.baud_rates(port)[rate.default_word] == theirs["default rate"]
        assert drive.parities(port)[parity.default_word] == theirs["default parity"]


@pytest.mark.parametrize(
    ("series", "entry"),
    [
        ("vf-s9", "tos.6.parameters.s9_s11_nc1"),
        ("vf-s11", "tos.6.parameters.s9_s11_nc1"),
        ("vf-nc1", "tos.6.parameters.s9_s11_nc1"),
        ("vf-a7", "tos.6.parameters.a7_p7"),
        ("vf-p7", "tos.6.parameters.a7_p7"),
    ],
)
def test_what_the_gateways_manual_sets_is_the_gateways_line(series: str, entry: str) -> None:
    drive, line = CATALOG.drive(series), ENTRIES["tos.1.subnet"]
    (port,) = _of(drive).ports
    wanted = {row["parameter"]: row["value"] for row in ENTRIES[entry]["parameters"]}
    names = (port.baud_rate, port.parity, port.inv_no, port.timeout)
    assert {drive.comno(name).display for name in names} == set(wanted)
    rate, parity = (wanted[drive.comno(name).display] for name in names[:2])
    assert drive.baud_rates(port)[rate] == line["baud"]
    assert drive.parities(port)[parity] == line["parity"]
    assert set(port.protocols.values()) == (
        {"toshiba", "modbus"} if series == "vf-s11" else {"toshiba"}
    )


# MODBUS of the VF-S15


def test_the_vf_s15_has_the_functions_of_its_manual() -> None:
    theirs, known = _properties("s15.modbus.functions"), CATALOG.modbus_protocol("modbus")
    modbus = _of(S15).modbus
    assert modbus is not None
    codes = {known.function(use.function).code for use in modbus.accesses}
    assert codes == {int(code, 16) for code in theirs["functions"]}
    indirect = {
        known.function(use.function).code for use in modbus.accesses if use.way == "indirect"
    }
    assert indirect == {int(code, 16) for code in theirs["functions on words that parameters name"]}
    keeps = {use.keeps for use in modbus.accesses if use.way == "direct" and use.most_written}
    assert keeps == {"eeprom"}
    assert S15.comno("inverter_number").maximum == theirs["highest number"]


@pytest.mark.parametrize(
    ("request_entry", "cause"),
    [
        ("s15.write.unknown", "unknown_comno"),
        ("modbus.read_two", "wrong_quantity"),
        ("modbus.block.bad_count", "wrong_quantity"),
        ("modbus.block", "not_executable"),
    ],
)
def test_an_exception_of_the_manual_is_the_one_of_its_cause(request_entry: str, cause: Any) -> None:
    modbus, known = _of(S15).modbus, CATALOG.modbus_protocol("modbus")
    assert modbus is not None
    refusals = [
        bytes.fromhex(entry["bytes"])
        for entry in ENTRIES.values()
        if entry.get("reply_to") == request_entry
    ]
    (refusal,) = [frame for frame in refusals if frame[1] & known.exception_bit]
    assert refusal[2] == known.exception(modbus.exceptions[cause]).code


def test_two_words_from_fd00_on_are_refused_unless_an_option_says_otherwise() -> None:
    request = bytes.fromhex(ENTRIES["modbus.read_two"]["bytes"])
    words = int.from_bytes(request[4:6])
    modbus = _of(S15).modbus
    assert modbus is not None
    fitting = [
        use
        for use in modbus.accesses
        if (use.function, use.way) == ("read", "direct")
        and use.least_read <= words <= use.most_read
    ]
    assert [use.option for use in fitting] == ["modbus_block_reads"]
    assert next(item for item in S15.options if item.id == "modbus_block_reads").default is False


def test_the_block_is_written_where_the_manual_writes_it() -> None:
    modbus, blocks = _of(S15).modbus, _of(S15).blocks
    assert modbus is not None
    assert blocks is not None
    block = bytes.fromhex(ENTRIES["modbus.block"]["bytes"])
    (use,) = [item for item in modbus.accesses if item.function == "write_several" and item.starts]
    assert use.starts == (int.from_bytes(block[2:4]),)
    assert use.most_written == int.from_bytes(block[4:6])
    assert blocks.write_choices[1] == _of(S15).ports[0].command
    assert blocks.write_choices[3] == _of(S15).ports[0].setpoint
    assert modbus.missing_reads_as == 0x8000


def test_the_identification_is_that_of_the_manual() -> None:
    modbus, reply = _of(S15).modbus, ENTRIES["modbus.identify.reply"]
    assert modbus is not None
    texts = modbus.identification
    assert texts is not None
    assert [texts.vendor, texts.product, texts.revision] == reply["strings"]
    assert texts.conformity == bytes.fromhex(reply["bytes"])[4]


# Like another


def test_the_vf_mb1_has_the_vf_s15s_communication_as_a_guess() -> None:
    ours, theirs = _of(MB1), _of(S15)
    assert [port.name for port in ours.ports] == [port.name for port in theirs.ports]
    assert {port.status for port in ours.ports} == {"unverified"}
    assert ours.modbus is not None
    assert {use.status for use in ours.modbus.accesses} == {"unverified"}
    assert (ours.modbus.accesses[0].source or "").startswith("as vf-s15: E6581913")


def test_what_is_confirmed_of_a_word_keeps_its_doubtful_bits() -> None:
    word = MB1.word("status")
    assert (word.status, word.source) == ("verified", "E6581737, pages 19, 20 and 28 to 32")
    assert word.status_of(word.field("tripped")) == "unverified"


def test_a_confirmed_word_must_be_there(tmp_path: Path) -> None:
    folder = tmp_path / "drives"
    folder.mkdir()
    text = Path("catalog/drives/vf-mb1.yaml").read_text("utf-8")
    text = text.replace("id: vf-mb1", "id: mine").replace("[command, status,", "[comand, status,")
    (folder / "mine.yaml").write_text(text, encoding="utf-8")
    with pytest.raises(DiagnosticError) as raised:
        load_catalog([tmp_path])
    (found,) = raised.value.diagnostics
    assert (found.code, found.message) == ("FB1105", "'vf-s15' has no word 'comand'")
    assert found.help == "did you mean 'command'?"


def test_nothing_of_a_new_series_is_sure_without_a_document_of_its_own() -> None:
    """Every verified row names E6581315, E6581913 or E6581737, or what tells the same."""
    for drive in OTHERS:
        text = yaml.safe_dump([item.source for item in drive.comnos if item.status == "verified"])
        assert "as vf-" not in text
        assert "LinuxCNC" not in text


# Names that stand for nothing


@pytest.mark.parametrize(
    ("old", "new", "code", "said"),
    [
        ("overridden_by: [forced_local,", "overridden_by: [forced,", "FB1105", "terminal function"),
        ("needs: command.network_command", "needs: command.network", "FB1105", "no bit 'command.n"),
        ("ored_with: [command_2.pattern]", "ored_with: [command_2.p]", "FB1105", "no bit"),
        ("parameters: {1: [jog_frequency]}", "parameters: {1: [jog]}", "FB1105", "no ComNo 'jog'"),
        ("parameters: {1: [jog_frequency]}", "parameters: {2: [fa00]}", "FB1104", "the value 2"),
        ("{name: forced_run,", "{name: forced_local,", "FB1102", "terminal function"),
        ("sends: torque_command}", "sends: torgue}", "FB1105", "no ComNo 'torgue'"),
        ('{role: master, title: "master, sends its torque", sends: torque}',
         "{role: master, title: master}", "FB1115", "no complete master"),
        ("    write: [block_write_1,", "    write: [block_write,", "FB1105", "no ComNo 'block_w"),
    ],
)  # fmt: skip
def test_a_name_that_stands_for_nothing_is_told_at_its_place(
    old: str, new: str, code: str, said: str
) -> None:
    text = Path("catalog/drives/vf-as1.yaml").read_text("utf-8")
    assert old in text
    document = load_yaml(Source("mine.yaml", text.replace(old, new, 1)))
    with pytest.raises(DiagnosticError) as raised:
        validate(with_relative(document, CATALOG.drive("vf-s11")), Drive)
    found = [item for item in raised.value.diagnostics if item.code == code]
    assert any(said in item.message for item in found), raised.value.diagnostics
    line = text[: text.index(old)].count("\n") + 1
    assert any(item.span is not None and item.span.line == line for item in found)
