"""The DEV003Z in the catalogue against the second reading of its manual in tests/vectors."""

from typing import Any

import pytest

from fbgen.catalog import Assembly, DeviceNetGateway, Word, load_catalog, load_yaml, validate
from fbgen.diagnostics import DiagnosticError
from fbgen.resources import shipped
from fbgen.source import Source
from tests.vectors.reading import entries

ENTRIES = entries("dev003z_words")
CATALOG = load_catalog()
GATEWAY = CATALOG.devicenet_gateway("dev003z")
TEXT = (shipped("catalog") / "gateways" / "dev003z.yaml").read_text("utf-8")
ASSEMBLIES = {
    item.instance: item for pair in GATEWAY.assemblies for item in (pair.output, pair.input)
}
OF_BYTE = {
    "dev.instance_101.byte_0": (101, 0, 0),
    "dev.instance_101.byte_5": (101, 4, 8),
    "dev.instance_151.byte_0": (151, 0, 0),
    "dev.instance_21.byte_0": (21, 0, 0),
    "dev.instance_100.byte_1": (100, 0, 8),
}
"""A bit table of one byte -> assembly, place of the word, first bit of the byte in the word."""
NAMES = {
    "Net Ref": "net_reference",
    "Net Ctrl": "net_control",
    "At reference": "at_reference",
    "Ref from Net": "reference_from_net",
    "Ctrl from Net": "control_from_net",
    "Faulted/tripped": "faulted",
    "Command link": "network_command",
}
"""What the manual calls a bit -> our name, where it is not the same in small letters."""


def word_at(instance: int, offset: int) -> Word:
    name = next(field.word for field in ASSEMBLIES[instance].fields if field.offset == offset)
    assert name is not None
    return GATEWAY.word(name)


def words_of(data: Assembly, rows: list[dict[str, Any]]) -> dict[int, str]:
    """The words of an example by the offset of their low byte."""
    return {int(row["bytes"].split()[1]): row["word"] for row in rows if row.get("word")}


@pytest.mark.fact("dev.assemblies")
def test_every_assembly_has_the_length_of_the_manual() -> None:
    lengths = {number: item.length for number, item in ASSEMBLIES.items()}
    assert lengths == {
        20: 4, 70: 4, 21: 4, 71: 4, 100: 4, 150: 4,
        101: 8, 151: 8, 102: 12, 152: 12, 105: 18, 155: 18,
    }  # fmt: skip
    drawn = [entry for entry in ENTRIES.values() if entry["kind"] == "io_layout"]
    assert {entry["instance"] for entry in drawn} == {101, 151, 102, 152, 105, 155, 150}
    for entry in drawn:
        assert ASSEMBLIES[entry["instance"]].length == entry["drive_bytes"]
        for row in entry["fields"]:
            field = next(
                one for one in ASSEMBLIES[entry["instance"]].fields
                if one.offset <= row["offset"] < one.offset + one.length
            )  # fmt: skip
            name = row["name"].lower()
            if "index" in name or "data" in name or "speed" in name or "c0" in name:
                wanted = ("index", "data", "speed", "frequency", "command_", "monitor_")
                assert field.name.startswith(wanted), row
            if name.startswith("c0"):
                assert field.parameter is not None
                assert GATEWAY.parameter(field.parameter).display == name.split()[0]


@pytest.mark.parametrize("name", OF_BYTE)
def test_every_bit_of_the_tables_is_in_the_word(name: str) -> None:
    instance, offset, shift = OF_BYTE[name]
    word = word_at(instance, offset)
    for row in ENTRIES[name]["bits"]:
        if row["name"] is None:
            continue
        theirs = NAMES.get(row["name"], row["name"].lower().replace(" ", "_"))
        assert word.field(theirs).mask == 1 << (row["bit"] + shift)


@pytest.mark.fact("dev.drive_status")
def test_drive_status_and_the_state_attribute_have_the_states_of_the_manual() -> None:
    ours = GATEWAY.word("extended_status").field("drive_status").values
    attribute = GATEWAY.object("control_supervisor").attribute("state")
    assert attribute.values == ours
    for row in (*ENTRIES["dev.drive_status"]["states"], *ENTRIES["dev.state_attribute"]["states"]):
        assert ours[row["value"]].lower() == row["name"].replace("_", " ").lower()
    assert attribute.id == ENTRIES["dev.state_attribute"]["attribute"]


@pytest.mark.parametrize(
    ("word", "value", "bits"),
    [
        ("basic_control", "0001", {"run_forward"}),
        ("extended_control", "0062", {"net_reference", "net_control", "run_reverse"}),
        ("command", "C600", {"network_command", "network_frequency", "run", "reverse"}),
        ("command", "8401", {"network_command", "run", "preset_speed_1"}),
        ("status", "6600", {"standby", "standby_st_on", "running", "reverse"}),
        ("index_request", "8018", {"write", "index"}),
    ],
)
def test_the_words_of_the_examples_say_what_the_manual_says(
    word: str, value: str, bits: set[str]
) -> None:
    found = GATEWAY.word(word)
    number = int(value, 16)
    assert {item.field.name for item in found.decode(number) if item.value} == bits
    assert found.undefined(number) == 0
    printed = {
        row["word"] for entry in ENTRIES.values() if entry["kind"] == "assembly_example"
        for side in ("output", "input") for row in entry.get(side, {}).get("rows", ())
    }  # fmt: skip
    assert value in printed | {"8401"}, "8401: one bit of it is cut off"


@pytest.mark.parametrize(
    ("value", "direction"), [(0x04F4, "running_forward"), (0x04F8, "running_reverse")]
)
def test_the_states_of_the_examples_are_enabled_and_at_reference(
    value: int, direction: str
) -> None:
    fields = {item.field.name: item.value for item in GATEWAY.word("extended_status").decode(value)}
    on = {"at_reference", "reference_from_net", "control_from_net", "ready", direction}
    assert {name for name, bit in fields.items() if bit} == {*on, "drive_status"}
    assert fields["drive_status"] == 4


@pytest.mark.fact("dev.map")
def test_every_monitor_of_the_manual_has_its_code() -> None:
    ours = {item.code: item for item in GATEWAY.monitors}
    for row in ENTRIES["dev.monitor_choices"]["monitors"]:
        wanted = "0880" if row["comno"] == "F880" else row["comno"]
        assert f"{ours[row['choice']].comno:04X}" == wanted
    assert f"{ours[3].comno:04X}" == "FD03", "dev.example.c021"
    assert [f"{item.comno:04X}" for item in GATEWAY.commands if item.code == 1] == ["FA06"]


@pytest.mark.fact("dev.param")
def test_instances_of_the_parameter_object_are_numbers_shifted() -> None:
    rule = GATEWAY.parameter_object
    entry = ENTRIES["dev.parameter_object"]
    assert rule.attribute == entry["attribute"]
    for row in entry["examples"]:
        assert rule.instance(int(row["comno"], 16)) == int(row["instance"], 16)
    for row in ENTRIES["dev.parameter_object.examples"]["examples"]:
        assert rule.instance(int(row["comno"], 16)) == int(row["instance"], 16)
    assert rule.instance(0xFA00) == 0x7A00
    for number in (0x0000, 0x0003, 0x0268, 0x0880, 0xC101, 0xFA00, 0xFD00, 0xFFFF):
        assert rule.number(rule.instance(number)) == number
    assert rule.instance(0xC203) == 0x0203


@pytest.mark.fact("dev.classes")
def test_the_classes_are_those_of_the_manual_with_their_attributes() -> None:
    codes = {item.code: item for item in GATEWAY.objects}
    assert set(codes) == {1, 2, 3, 4, 5, 0x28, 0x29, 0x2A, 0x2B, 0x64}
    supervisor = [item.id for item in codes[0x29].attributes]
    assert supervisor == [1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 15]
    assert {item.id for item in codes[1].attributes} == {*range(1, 9), 10}
    drive = {item.id: item for item in codes[0x2A].attributes}
    assert (drive[11].title, drive[18].settable, drive[19].settable) == (
        "Torque, in Nm",
        True,
        True,
    )


OBJECTS = [entry for entry in ENTRIES.values() if entry["kind"] == "object_attributes"]
NOT_AS_PRINTED = {("28", "0E")}
"""It lists attributes of the class without a service for them: finding class_attributes_unread."""


@pytest.mark.fact("dev.drive", "dev.motor")
@pytest.mark.parametrize("entry", OBJECTS, ids=lambda entry: str(entry["id"]))
def test_tables_of_attributes_and_services_are_those_of_the_manual(entry: dict[str, Any]) -> None:
    known = next(item for item in GATEWAY.objects if item.code == int(entry["class"], 16))
    printed = {
        row["attribute"]: (row["type"].lower().replace(" ", "_"), row["access"] == "Get/Set")
        for row in entry["attributes"]
    }
    if printed:
        assert {item.id: (item.type, item.settable) for item in known.attributes} == printed
        assert entry.get("count", len(printed)) == len(known.attributes)
    for row in entry["services"]:
        service = next(one for one in known.services if one.code == int(row["service"], 16))
        assert service.on_instance is row["instance"]
        if (entry["class"], row["service"]) not in NOT_AS_PRINTED:
            assert service.on_class is row["class"]
    printed_services = {row["service"] for row in entry["services"]}
    assert printed_services == {f"{one.code:02X}" for one in known.services}


@pytest.mark.parametrize(
    ("class_name", "attributes"),
    [
        pytest.param(
            "identity",
            {"product_name": 7, "serial_number": 6, "state": 8},
            marks=pytest.mark.fact("dev.ident"),
        ),
        pytest.param(
            "devicenet",
            {"bus_off_interrupt": 3, "bus_off_counter": 4, "allocation": 5},
            marks=pytest.mark.fact("dev.dn"),
        ),
        pytest.param(
            "motor_data",
            {"motor_type": 3, "rated_current": 6},
            marks=pytest.mark.fact("dev.motor"),
        ),
        pytest.param(
            "connection",
            {"expected_packet_rate": 9, "produced_connection_path": 14},
            marks=pytest.mark.fact("dev.conn"),
        ),
    ],
)
def test_attributes_have_the_numbers_of_the_manual(
    class_name: str, attributes: dict[str, int]
) -> None:
    found = GATEWAY.object(class_name)
    assert {name: found.attribute(name).id for name in attributes} == attributes


def test_what_the_text_at_hand_has_lost_is_unverified() -> None:
    assert "values" in GATEWAY.parameter("assembly_instances").unverified
    assert GATEWAY.word("function_request").status_of(
        GATEWAY.word("function_request").field("write")
    ) == "unverified"  # fmt: skip
    assert {item.code for item in GATEWAY.monitors if item.status == "unverified"} == {
        1, 2, 4, 5, 6, 7, 8,
    }  # fmt: skip
    assert "product_codes" in GATEWAY.devicenet.unverified


@pytest.mark.parametrize(
    ("old", "new", "code", "marked"),
    [
        ("{name: data, offset: 6,", "{name: data, offset: 7,", "FB1106", "7"),
        ("word: basic_status}", "word: basic_state}", "FB1105", "basic_state"),
        ("parameter: monitor_2}", "parameter: monitor_9}", "FB1105", "monitor_9"),
        ("assembly_parameter: assembly_instances", "assembly_parameter: c203", "FB1105", "c203"),
        ("    setting: 5\n", "    setting: 4\n", "FB1102", "4"),
        ("maximum_mac: 63", "maximum_mac: 64", "FB1108", "64"),
        ("type: usint, default: 7,", "type: usint, default: 700,", "FB1104", "700"),
        ("type: usint, maximum: 2", "type: usint, maximum: 300", "FB1108", None),
        ("vf-s15: 3001", "vf-s11: 3001", "FB1105", None),
        ("{assemblies: chosen_parameter", "{assemblies: chosen_not", "FB1105", "chosen_not"),
        ("request: function, response", "request: functions, response", "FB1105", "functions"),
        ("maximum: 15, default: 0,", "maximum: 15, default: 16,", "FB1108", "16"),
        ("{code: 26, comno", "{code: 25, comno", "FB1102", "25"),
    ],
)  # fmt: skip
def test_what_contradicts_itself_is_told_at_its_place(
    old: str, new: str, code: str, marked: str | None
) -> None:
    assert old in TEXT
    with pytest.raises(DiagnosticError) as raised:
        validate(load_yaml(Source("dev003z.yaml", TEXT.replace(old, new, 1))), DeviceNetGateway)
    found = raised.value.diagnostics[0]
    assert found.code == code
    assert found.span is not None
    assert marked is None or found.span.text == marked


def test_a_gateway_on_another_network_is_refused_by_name() -> None:
    with pytest.raises(DiagnosticError) as raised:
        CATALOG.profibus_gateway("dev003z")
    (found,) = raised.value.diagnostics
    assert found.code == "FB1206"
    assert found.help == "a PROFIBUS gateway is pbdp110, tospbdp001"
    with pytest.raises(DiagnosticError) as raised:
        CATALOG.devicenet_gateway("pbdp110")
    assert raised.value.diagnostics[0].help == "a DeviceNet adapter is dev003z"
