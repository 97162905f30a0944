"""The shipped catalogue: everything loads, and the sequences are sound."""

import pytest

from fbgen.catalog import DelayStep, Located, ReadStep, Sequence, WriteStep, load_catalog, origin
from fbgen.catalog.sourced import Sourced

CATALOG = load_catalog()
DRIVE = CATALOG.drive("vf-s11")
GATEWAY = CATALOG.gateway("tospbdp001")


def command_words(sequence: Sequence) -> list[int]:
    """The words that a sequence writes to FA00, BOOL parameters FALSE."""
    return [
        DRIVE.command_word.encode(step.bits) if step.bits is not None else step.literal or 0
        for step in sequence.steps
        if isinstance(step, WriteStep) and DRIVE.comno(step.write).hex == "FA00"
    ]


def written(sequence: Sequence) -> list[str]:
    return [DRIVE.comno(s.write).hex for s in sequence.steps if isinstance(s, WriteStep)]


def test_the_shipped_entries_are_there() -> None:
    series = {
        *("g7", "vf-a7", "vf-as1", "vf-mb1", "vf-nc1", "vf-p7"),
        *("vf-s11", "vf-s15", "vf-s7", "vf-s9"),
    }
    assert set(CATALOG.drives) == series
    assert set(CATALOG.gateways) == {"dev003z", "pbdp110", "tospbdp001"}
    assert set(CATALOG.protocols) == {"modbus", "toshiba"}
    assert set(CATALOG.sequences) == {
        "start_forward",
        "start_reverse",
        "stop",
        "set_frequency",
        "read_current",
        "read_status",
        "fault_reset",
        "emergency_stop",
        "manual_example",
        "check_parameters",
    }


@pytest.mark.parametrize(
    "number",
    ["FA00", "FA01", "FC90", "FC91", "0009", "0010", "0011", "0012", "0013", "0800", "0801",
     "0802", "0803", "0805", "0811", "0814", "0880", "0018", "0294"]
    + [f"FD{n:02d}" for n in range(8)]
    + [f"FE{n:02d}" for n in range(15)],
)  # fmt: skip
def test_the_drive_has_the_communication_number(number: str) -> None:
    assert DRIVE.comno(number).hex == number


def test_every_fact_names_its_source_or_says_that_it_has_none() -> None:
    def unsourced(entry: object) -> list[object]:
        if isinstance(entry, tuple):
            return [found for item in entry for found in unsourced(item)]
        if not isinstance(entry, Located):
            return []
        fields = [getattr(entry, name) for name in type(entry).model_fields]
        here = isinstance(entry, Sourced) and entry.status == "verified" and not entry.source
        return ([entry] if here else []) + unsourced(tuple(fields))

    entries = [CATALOG.drives, CATALOG.gateways, CATALOG.protocols, CATALOG.sequences]
    assert [
        found for kind in entries for entry in kind.values() for found in unsourced(entry)
    ] == []


def test_held_monitors_repeat_the_present_ones() -> None:
    for number in range(8):
        present, held = DRIVE.comno(f"FD{number:02d}"), DRIVE.comno(f"FE{number:02d}")
        assert held.frozen_copy_of == present.name
        assert (held.unit, held.resolution, held.word) == (
            present.unit,
            present.resolution,
            present.word,
        )


def test_only_two_trip_codes_rest_on_a_document() -> None:
    verified = {(trip.code, trip.display) for trip in DRIVE.trips if trip.status == "verified"}
    assert verified == {(0x0000, "nErr"), (0x0018, "Err5")}
    assert DRIVE.trip(0x0011) is not None
    assert DRIVE.trip(0xFFFF) is None


@pytest.mark.parametrize(("name", "word"), [("start_forward", 0xC400), ("start_reverse", 0xC600)])
def test_a_start_writes_the_set_point_before_the_run_command(name: str, word: int) -> None:
    sequence = CATALOG.sequence(name)
    assert written(sequence) == ["FA01", "FA00"]
    assert command_words(sequence) == [word]


def test_a_stop_keeps_the_direction() -> None:
    sequence = CATALOG.sequence("stop")
    assert command_words(sequence) == [0xC000]
    (step,) = sequence.steps
    assert isinstance(step, WriteStep)
    assert step.bits_from == {"reverse": "reverse"}
    assert [(item.name, item.type) for item in sequence.parameters] == [("reverse", "BOOL")]


def test_a_reset_takes_network_control_again_after_the_silence() -> None:
    reset, wait, control = CATALOG.sequence("fault_reset").steps
    assert isinstance(reset, WriteStep)
    assert reset.reply == "none"
    assert isinstance(wait, DelayStep)
    assert wait.delay.drive_time == "reset_silence"
    assert DRIVE.times.reset_silence.ms == 2000
    assert isinstance(control, WriteStep)
    assert control.reply == "expected"
    assert command_words(CATALOG.sequence("fault_reset")) == [0xE000, 0xC000]


def test_an_emergency_stop_trips_the_drive() -> None:
    assert command_words(CATALOG.sequence("emergency_stop")) == [0xD000]


def test_the_manuals_example_is_made_of_literals() -> None:
    sequence = CATALOG.sequence("manual_example")
    kinds = [type(step) for step in sequence.steps]
    assert kinds == [WriteStep, WriteStep, DelayStep, ReadStep, WriteStep]
    assert command_words(sequence) == [0xC400, 0xC200]


@pytest.mark.parametrize("name", list(CATALOG.sequences))
def test_every_sequence_says_what_it_does_not_protect(name: str) -> None:
    text = CATALOG.sequence(name).does_not_protect
    assert "no safety function" in text
    assert "STO" in text


def test_the_invented_module_is_named_as_invented() -> None:
    layouts = {layout.name: layout for layout in GATEWAY.layouts}
    assert {name for name, layout in layouts.items() if layout.invented} == {"whole10"}
    assert layouts["whole10"].identifiers == bytes.fromhex("C08987")
    assert layouts["whole10"].consistent
    assert layouts["whole10"].access_ways == ("dpxx_dat", "process_image")
    assert layouts["gsd10"].access_ways == ("per_identifier", "process_image")


@pytest.mark.parametrize(("name", "size"), [("gsd10", 10), ("doc9", 9), ("whole10", 10)])
def test_layouts_carry_eight_bytes_in_and_nine_or_ten_out(name: str, size: int) -> None:
    layout = GATEWAY.layout(name)
    assert (layout.output_length, layout.input_length) == (size, 8)
    assert layout.output_field("data").end == size
    pads = [field.offset for field in layout.output if field.pad]
    assert pads == ([7] if size == 10 else [])


def test_options_have_the_documented_defaults() -> None:
    assert {option.id: option.default for option in GATEWAY.options} == {
        "handshake": True,
        "trigger_poll": False,
        "error_counter": "restart",
        "error_status_code": "hms",
        "status_toggle": "when_taken",
        "offline_timeout_ms": 0,
        "offline_inputs": "freeze",
        "offline_outputs": "no_scanning",
        "startup_lock": "none",
        "subnet_error_led": "device_status",
        "startup_ms": 0,
        "heartbeat_frame": "(**P08800001)",
    }


def test_an_origin_names_the_place_in_the_catalogue() -> None:
    comno = DRIVE.comno("FA01")
    place = origin("ComNo FA01", comno, comno.source or "")
    assert place is not None
    assert place.file == "catalog/drives/vf-s11.yaml"
    assert comno.span is not None
    assert comno.span.source.line_text(place.line).strip() == "- number: FA01"


def test_the_catalogue_cannot_be_changed() -> None:
    with pytest.raises(ValueError, match="frozen"):
        DRIVE.id = "other"
    with pytest.raises(TypeError):
        CATALOG.drives["x"] = DRIVE  # type: ignore[index]  # that it fails is the test
