"""The vectors are well formed and agree with themselves.

Checks form and arithmetic only, with sums written out here: nothing of the product is imported, so
an error in a codec cannot hide an error in a vector.
"""

import re
from collections.abc import Hashable
from typing import Any

import pytest
import yaml

from tests.vectors.reading import FOLDER, LOADER

FILES = (
    "dev003z_words.yaml",
    "pbdp110_words.yaml",
    "toshiba_frames.yaml",
    "tospbdp001_telegrams.yaml",
    "vf_as1_command_word.yaml",
    "wire_facts.yaml",
)
ORIGINS = {"printed", "second_hand", "calculated", "derived", "reconstructed"}
BYTES = re.compile(r"(?:[0-9A-F]{2}|xx)(?: (?:[0-9A-F]{2}|xx))*")
HEX = re.compile(r"(?:[0-9A-F]{2})+")
BITS = re.compile(r"[01?]{8}|[01?]{16}")
COMNO = re.compile(r"[0-9A-F]{4}")
TEXT_KEYS = {"send", "receive", "word", "words", "hex", "comno", "comnos", "code", "checksum"}

Entry = dict[str, Any]


class NoDuplicateKeys(LOADER):
    """Refuses a key named twice, where the safe loader keeps the last one, and a key in words.

    A key with blanks is what follows the comma of a text that was left without quotes.
    """

    def construct_mapping(self, node: yaml.MappingNode, deep: bool = False) -> dict[Hashable, Any]:
        keys = [self.construct_object(key, deep=True) for key, _ in node.value]
        assert len(keys) == len(set(keys)), f"key named twice: {keys}"
        assert not any(" " in str(key) for key in keys), f"text without quotes: {keys}"
        return super().construct_mapping(node, deep)


def _load(name: str) -> Entry:
    document = yaml.load((FOLDER / name).read_text(encoding="utf-8"), Loader=NoDuplicateKeys)
    assert isinstance(document, dict)
    return document


LOADED = {name: _load(name) for name in FILES}
ENTRIES: list[Entry] = [entry for name in FILES for entry in LOADED[name]["entries"]]
BY_ID: dict[str, Entry] = {entry["id"]: entry for entry in ENTRIES}

# Kinds of which only the form common to all entries is checked: prose, or numbers printed once.
PROSE = {
    "attributes", "bit_group", "cell_order", "comnos", "error_code", "format", "gsd_comment",
    "gsd_module", "input_functions", "instance_rule", "monitors", "observation", "path",
    "procedure", "properties", "rule", "run_stop_matrix", "serial_line", "value",
}  # fmt: skip
CHECKED: set[str] = set()


def _of(*kinds: str) -> pytest.MarkDecorator:
    CHECKED.update(kinds)
    chosen = [entry for entry in ENTRIES if entry["kind"] in kinds]
    assert chosen, f"no entry of {kinds}"
    return pytest.mark.parametrize("entry", chosen, ids=[entry["id"] for entry in chosen])


def _known_bytes(text: str) -> list[int]:
    return [int(part, 16) for part in text.split()]


def _leaves(value: Any, key: str = "") -> list[tuple[str, Any]]:
    """Every scalar under `value` with the key it stands under."""
    if isinstance(value, dict):
        return [leaf for name, child in value.items() for leaf in _leaves(child, str(name))]
    if isinstance(value, list):
        return [leaf for child in value for leaf in _leaves(child, key)]
    return [(key, value)]


def test_every_vector_file_of_the_folder_is_checked() -> None:
    assert sorted(path.name for path in FOLDER.glob("*.yaml")) == sorted(FILES)


def test_ids_are_unique_over_all_files() -> None:
    assert len(BY_ID) == len(ENTRIES)


@pytest.mark.parametrize("name", FILES)
def test_every_entry_names_its_place(name: str) -> None:
    documents = LOADED[name]["documents"]
    for entry in LOADED[name]["entries"]:
        assert entry["document"] in documents, entry["id"]
        assert isinstance(entry["section"], str), entry["id"]
        assert entry["section"].strip(), entry["id"]
        assert entry["origin"] in ORIGINS, entry["id"]
        if entry["origin"] in {"calculated", "derived"}:
            assert entry.get("rule") or entry.get("remark"), entry["id"]
        if entry["origin"] == "reconstructed":
            assert entry["given"], entry["id"]


@pytest.mark.parametrize("entry", ENTRIES, ids=list(BY_ID))
def test_hex_is_well_formed(entry: Entry) -> None:
    for key, value in _leaves(entry):
        if not isinstance(value, str):
            quoted = key in TEXT_KEYS or (key == "bits" and entry["kind"] != "bit_group")
            assert value is None or not quoted, f"{key}: {value} needs quotes"
        elif key in {"send", "receive", "identifiers", "commands"} or (
            key == "bytes" and entry["kind"] in {"frame", "path"}
        ):
            assert BYTES.fullmatch(value), (key, value)
        elif key in {"word", "words"}:
            assert re.fullmatch(r"[0-9A-F]{4}", value), (key, value)
        elif key == "hex":
            assert HEX.fullmatch(value), (key, value)
        elif key in {"comno", "comnos", "code"}:
            assert COMNO.fullmatch(value), (key, value)
        elif key == "bits":
            assert BITS.fullmatch(value), (key, value)


@_of("frame")
def test_checksum_of_the_frame_is_right(entry: Entry) -> None:
    if entry["mode"] == "ascii":
        if entry["checksum"] is None:
            assert "&" not in entry["text"]
            return
        summed, rest = entry["text"].split("&")
        total = sum(ord(sign) for sign in summed + "&")
        assert f"{total:X}" == entry["total"]
        assert f"{total & 0xFF:02X}" == entry["checksum"] == rest.removesuffix(")\r")
        return
    if "xx" in entry["bytes"]:
        known = [int(part, 16) for part in entry["bytes"].split() if part != "xx"]
        assert f"{sum(known) & 0xFF:02X}" == entry["sum_without_data"]
        return
    if entry["mode"] == "binary":
        *summed_bytes, found = _known_bytes(entry["bytes"])
        right = sum(summed_bytes) & 0xFF == found
        assert f"{found:02X}" == entry["checksum"]
        assert summed_bytes[0] == 0x2F
    else:
        frame = _known_bytes(entry["bytes"])
        crc = 0xFFFF
        for byte in frame[:-2]:
            crc ^= byte
            for _ in range(8):
                crc = crc >> 1 ^ (0xA001 if crc & 1 else 0)
        right = frame[-2:] == [crc & 0xFF, crc >> 8]
        assert entry["bytes"].endswith(entry["checksum"])
    assert right is entry.get("checksum_ok", True)


@_of("frame")
def test_frame_points_at_existing_entries(entry: Entry) -> None:
    if "reply_to" in entry:
        assert BY_ID[entry["reply_to"]]["direction"] == "request"
        assert entry["direction"] == "reply"
    if "telegram" in entry:
        telegram = BY_ID[entry["telegram"]]
        if entry["direction"] == "request":
            expected = telegram["send"].split()[3:]
        else:
            expected = telegram["receive"].split()[2:]
        payload = entry["bytes"].split()[1:-1]
        assert len(payload) == len(expected)
        assert all(want in ("xx", have) for want, have in zip(expected, payload, strict=True))


@_of("frame")
def test_words_and_texts_said_to_be_inside_the_frame_are_inside(entry: Entry) -> None:
    joined = entry.get("bytes", "").replace(" ", "")
    assert "".join(entry.get("words", [])) in joined
    for text in entry.get("strings", []):
        assert f"{len(text):02X}" + text.encode("ascii").hex().upper() in joined


@_of("telegram")
def test_telegram_has_the_printed_length_and_echoes_its_command(entry: Entry) -> None:
    sent = entry["send"].split()
    assert len(sent) == BY_ID["tos.layout.send"]["length"]
    assert int(sent[3], 16) == entry["inverter"]
    if entry["receive"] is not None:
        received = entry["receive"].split()
        assert len(received) == BY_ID["tos.layout.receive"]["length"]
        assert received[2:6] == sent[3:7]
        assert (int(received[0], 16) ^ int(sent[0], 16)) & 0x40 == 0, "status copies control bit 14"


@_of("bit_table")
def test_bit_table_has_no_overlap_and_no_bit_outside(entry: Entry) -> None:
    numbers = [row["bit"] for row in entry["bits"]]
    assert len(numbers) == len(set(numbers))
    assert all(0 <= number < entry["width"] for number in numbers)
    assert entry["complete"] is (set(numbers) == set(range(entry["width"])))
    for row in entry["bits"]:
        assert row["name"] or row["illegible"], row
        assert ({"zero", "one"} <= row.keys()) or row["always"] in (0, 1), row
    if not entry["complete"]:
        assert entry.get("illegible") or any("basis" in row for row in entry["bits"])


@_of("byte_layout")
def test_telegram_fields_cover_the_telegram_without_overlap(entry: Entry) -> None:
    covered = [
        number
        for field in entry["fields"]
        for number in range(field["first_byte"], field["last_byte"] + 1)
    ]
    assert covered == list(range(1, entry["length"] + 1))


@_of("io_layout")
def test_fields_of_one_drive_do_not_overlap(entry: Entry) -> None:
    covered = [
        number
        for field in entry["fields"]
        for number in range(field["offset"], field["offset"] + field["length"])
    ]
    assert covered == sorted(set(covered))
    assert covered[-1] < entry["drive_bytes"]
    if not entry.get("illegible"):
        assert covered == list(range(entry["drive_bytes"]))
        offsets = list(entry["drive_offsets"].values())
        for module, size in entry["modules"].items():
            drives = 1 + (module + 1) % 2
            assert size == offsets[drives - 1] + entry["drive_bytes"]


@_of("word_states", "word_example", "states", "assembly_example", "word_bytes")
def test_hex_and_bits_of_a_word_agree(entry: Entry) -> None:
    rows = [entry, *entry.get("states", [])]
    for side in ("input", "output"):
        rows += entry.get(side, {}).get("rows", [])
    compared = 0
    for row in rows:
        if row.get("word") is not None and "bits" in row:
            assert int(row["bits"], 2) == int(row["word"], 16)
            compared += 1
        if "value" in row and "bits" in row:
            assert int(row["bits"], 2) == row["value"]
            compared += 1
        if "set_bits" in row:
            assert sum(1 << bit for bit in row["set_bits"]) == int(row["word"], 16)
            compared += 1
        if row.get("ascii"):
            assert row["ascii"] == f"(P{row['comno']}{row['word']})\r"
            compared += 1
        if isinstance(row.get("bytes"), list):
            assert "".join(byte["value"] for byte in reversed(row["bytes"])) == row["word"]
            compared += 1
        if "?" in str(row.get("bits", "")):
            assert row["word"] is None
            compared += 1
    assert compared or entry["id"] == "dev.state_attribute"


@_of("scaling")
def test_scaled_number_agrees_with_its_word(entry: Entry) -> None:
    assert int(entry["word"], 16) == entry["decimal"]
    agrees = round(entry["value"] / entry["unit_step"]) == entry["decimal"]
    assert agrees is ("contradicted_by" not in entry)
    if not agrees:
        assert BY_ID[entry["contradicted_by"]]["kind"] == "contradiction"


@_of("identifier_decoding")
def test_identifier_bytes_decode_to_the_recorded_lengths(entry: Entry) -> None:
    assert entry["identifiers"] == BY_ID["tos.gsd.module"]["identifiers"]
    identifiers = _known_bytes(entry["identifiers"])
    sizes = [((byte & 0xF) + 1) * (2 if byte & 0x40 else 1) for byte in identifiers]
    to_slave = [size if byte & 0x20 else 0 for byte, size in zip(identifiers, sizes, strict=True)]
    to_master = [size if byte & 0x10 else 0 for byte, size in zip(identifiers, sizes, strict=True)]
    assert to_slave == entry["to_slave_bytes"]
    assert to_master == entry["to_master_bytes"]
    assert (sum(to_slave), sum(to_master)) == (entry["to_slave_total"], entry["to_master_total"])


@_of("switch_address")
def test_switch_examples_are_binary_with_the_first_switch_lowest(entry: Entry) -> None:
    for example in entry["examples"]:
        assert int(example["switches"][::-1], 2) == example["address"]


@_of("two_bit_codes")
def test_two_bit_codes_name_each_code_once(entry: Entry) -> None:
    codes = [(code["high"], code["low"]) for code in entry["codes"]]
    assert sorted(codes) == [(0, 0), (0, 1), (1, 0), (1, 1)]


@_of("commands")
def test_command_letter_is_its_code(entry: Entry) -> None:
    for command in entry["commands"]:
        assert chr(int(command["hex"], 16)) == command["ascii"]


@_of("tripped_replies")
def test_reply_of_a_tripped_inverter_is_the_lower_case_command(entry: Entry) -> None:
    for pair in entry["replies"]:
        assert int(pair["reply"], 16) - int(pair["request"], 16) == entry["offset"] == 0x20


@_of("contradiction")
def test_contradiction_has_two_readings_with_their_places(entry: Entry) -> None:
    readings = [(reading["section"], reading["reading"]) for reading in entry["readings"]]
    assert len(readings) >= 2
    assert len(set(readings)) == len(readings)
    assert all(isinstance(text, str) and text for reading in readings for text in reading)


@_of("handshake")
def test_each_handshake_bit_is_toggled_by_one_side_and_copied_by_the_other(entry: Entry) -> None:
    assert [row["bit"] for row in entry["bits"]] == [15, 14]
    for row in entry["bits"]:
        assert {row["toggled_by"], row["copied_by"]} == {"gateway", "PLC"}
        assert row["direction"] == f"{row['toggled_by']} to {row['copied_by']}"


@_of("leds")
def test_each_led_in_use_has_one_normal_state(entry: Entry) -> None:
    assert [led["led"] for led in entry["leds"]] == [1, 2, 3, 4, 5, 6]
    for led in entry["leds"]:
        states = [state["state"] for state in led["states"]]
        assert len(states) == len(set(states))
        normal = sum(state["normal"] for state in led["states"])
        assert normal == (0 if led["name"] == "unused" else 1)


@_of("timing")
def test_time_is_recorded_as_printed_and_in_milliseconds(entry: Entry) -> None:
    printed = [int(number) for number in re.findall(r"[0-9]+", entry["as_printed"])]
    times = {key: value for key, value in entry.items() if key.endswith("_ms")}
    assert times
    assert (
        set(printed) == set(times.values())
        or (not printed and times == {"maximum_ms": 1000})
        or ([number * 1000 for number in printed] == list(times.values()))
    )


@_of("range")
def test_range_runs_upwards(entry: Entry) -> None:
    assert entry["minimum"] < entry["maximum"]


@_of("gsd")
def test_each_gsd_keyword_stands_once_and_every_baud_rate_has_its_responder_time(
    entry: Entry,
) -> None:
    keywords = [row["keyword"] for row in entry["keywords"]]
    assert len(keywords) == len(set(keywords))
    rates = [
        word.removesuffix("_supp") for word in keywords if word[0].isdigit() and "_supp" in word
    ]
    assert rates == [word.removeprefix("MaxTsdr_") for word in keywords if "MaxTsdr_" in word]


@_of("parameters", "error_codes")
def test_table_names_each_key_once(entry: Entry) -> None:
    rows = entry.get("parameters") or entry["codes"]
    keys = [row.get("parameter") or row["code"] for row in rows]
    assert keys == sorted(set(keys))


@_of("address")
def test_factory_address_follows_the_switch_rule(entry: Entry) -> None:
    assert entry["switch_b"] * 10 + entry["switch_a"] == entry["address"]


@_of("status_bits")
def test_flags_and_numbers_of_a_status_do_not_overlap(entry: Entry) -> None:
    flags = [row["bit"] for row in entry["flags"]]
    number = range(entry["number"]["lowest"], entry["number"]["highest"] + 1)
    assert flags == sorted(set(flags) - set(number))
    values = [row["value"] for row in entry["values"]]
    assert values == sorted(set(values))
    assert values[-1] < 1 << len(number)


@_of("object_attributes")
def test_attributes_and_services_are_named_once_each(entry: Entry) -> None:
    numbers = [row["attribute"] for row in entry["attributes"]]
    assert numbers == sorted(set(numbers))
    assert entry.get("count", len(numbers)) == len(numbers)
    services = [row["service"] for row in entry["services"]]
    assert services == sorted(set(services))
    assert all(row["class"] or row["instance"] for row in entry["services"])


def test_every_kind_of_entry_is_known() -> None:
    assert not CHECKED & PROSE
    assert {entry["kind"] for entry in ENTRIES} == CHECKED | PROSE
