"""Which block uses which bit and number: against the lines themselves, and for a user's sources."""

import re
from pathlib import Path

import pytest

from fbgen.catalog import load_catalog, with_own_sequences
from fbgen.diagnostics import DiagnosticError
from fbgen.docs.program import PlantProgram, read_program
from fbgen.docs.subject import Subject
from fbgen.docs.usage import BitItem, ComNoItem, Usage, usage_of
from fbgen.emit.generator import generate
from fbgen.plant import in_dialect, load_plant
from fbgen.resources import shipped

CATALOG = load_catalog()
WORDS = {
    (device.id, word.name): word
    for device in (*CATALOG.gateways.values(), *CATALOG.drives.values())
    for word in device.words
}


@pytest.fixture(scope="module")
def usage(subject: Subject) -> Usage:
    return usage_of(subject.programs, CATALOG)


def program_of(
    dialect: str = "tia", sources: tuple[Path, ...] = (), plant: Path | None = None
) -> PlantProgram:
    path = plant or shipped("examples") / "five_drives" / "plant.yaml"
    known = with_own_sequences(CATALOG, path.parent)
    entry = in_dialect(load_plant(path, known), dialect, known)
    return read_program(entry, generate(entry, known), sources)


def lines_of(usage: Usage, item: BitItem | ComNoItem, does: str) -> list[str]:
    return [f"{use.block}:{use.line}" for use in usage.of(item) if use.does == does]


def test_each_use_stands_in_the_line_that_it_names(subject: Subject, usage: Usage) -> None:
    texts: dict[str, list[str]] = {}
    for program in reversed(subject.programs):
        texts |= {name: file.text.splitlines() for name, file in program.files.items()}
    for item, uses in usage.uses.items():
        for use in uses:
            numbers = {
                int(one, 16) for one in re.findall(r"16#([0-9A-F]+)", texts[use.file][use.line - 1])
            }
            numbers |= {int(one) for one in re.findall(r"\b\d+\b", texts[use.file][use.line - 1])}
            if isinstance(item, ComNoItem):
                assert item.number in numbers, use
            else:
                field = WORDS[item.device, item.word].field(item.bit)
                wanted = {0xFFFF ^ one for one in numbers} | numbers
                assert any(one & field.mask for one in wanted) or field.low in numbers, use


def test_no_number_of_a_telegram_is_missed(subject: Subject, usage: Usage) -> None:
    """The texts are searched a second time, without a parser."""
    program = subject.programs[0]
    numbers = {cell.number for cell in CATALOG.drives["vf-s11"].comnos if cell.number > 0xFA00 - 1}
    seen = set()
    for name, file in program.files.items():
        for number, line in enumerate(file.text.splitlines(), start=1):
            code = line.partition("//")[0]
            if "omNo" in code and ":=" in code:
                found = {int(one, 16) for one in re.findall(r"16#(F[A-F0-9]{3})", code)}
                seen |= {(name, number, one) for one in found & numbers}
    known = {
        (use.file, use.line, item.number)
        for item, uses in usage.uses.items()
        if isinstance(item, ComNoItem)
        for use in uses
    }
    assert seen
    assert seen <= known


def test_a_bit_is_set_asked_for_and_never_used(usage: Usage) -> None:
    coast = usage.of(BitItem("vf-s11", "command", "coast_stop"))
    assert [(use.block, use.does) for use in coast] == [
        ("TOS_Drive", "sets"),
        ("TIP_Drive", "sets"),
    ]
    running = usage.of(BitItem("vf-s11", "status", "running"))
    assert {use.does for use in running} == {"reads"}
    assert usage.of(BitItem("vf-s11", "command", "pi_control_off")) == ()


def test_a_telegram_is_read_or_written_as_its_command_says(usage: Usage) -> None:
    assert any(
        "TOS_StatusPoll" in one for one in lines_of(usage, ComNoItem("vf-s11", 0xFD01), "reads")
    )
    written = lines_of(usage, ComNoItem("vf-s11", 0xFA01), "writes")
    assert any("TOS_Seq_set_frequency" in one for one in written)
    assert not any("TOS_StatusPoll" in one for one in written)


def test_a_word_that_a_sequence_sends_counts_bit_by_bit(usage: Usage) -> None:
    run = lines_of(usage, BitItem("vf-s11", "command", "run"), "writes")
    assert any("TOS_Seq_start_forward" in one for one in run)
    assert not any("TOS_Seq_stop" in one for one in run)


def test_bits_from_a_value_that_is_worked_out_are_told(usage: Usage) -> None:
    found = usage.worked_out("vf-s11", "command")
    assert [one.block for one in found] == ["TOS_Drive", "TIP_Drive"]
    assert usage.worked_out("tospbdp001", "status") == ()


@pytest.mark.parametrize("dialect", ["step7", "iec", "twincat", "plcopen"])
def test_every_dialect_has_the_same_uses(usage: Usage, dialect: str, tmp_path: Path) -> None:
    example = shipped("examples") / "five_drives" / "plant.yaml"
    plant = tmp_path / "plant.yaml"
    plant.write_text(example.read_text("utf-8").replace("per_identifier", "process_image"))
    found = usage_of([program_of(dialect, plant=plant)], CATALOG)
    for block in ("TOS_Drive", "TOS_Handshake", "TOS_Line", "TOS_Seq_stop", "TOS_Telegram"):
        assert done_by(found, block) == done_by(usage, block)


def done_by(usage: Usage, block: str) -> set[tuple[object, str]]:
    return {
        (item, use.does) for item, uses in usage.uses.items() for use in uses if use.block == block
    }


OWN = """\
FUNCTION_BLOCK "Cooling"
VERSION : 0.1
   VAR_IN_OUT
      drive : "typeTosDrive";
      channel : "typeTosChannel";
   END_VAR
   VAR
      alarm : Bool;
      word : Word;
   END_VAR
BEGIN
   #alarm := #drive.polled.statusWord.%X2;
   #word := #drive.polled.statusWord;
   IF (#word AND 16#0200) <> 16#0000 THEN
      #channel.request.comNo := 16#FD00;
   END_IF;
END_FUNCTION_BLOCK
"""


def test_sources_of_the_user_are_followed_by_what_flows_into_them(tmp_path: Path) -> None:
    own = tmp_path / "cooling.scl"
    own.write_text(OWN)
    usage = usage_of([program_of(sources=(own,))], CATALOG)
    for bit, line in (("alarm", 12), ("reverse", 14)):
        uses = [use for use in usage.of(BitItem("vf-s11", "status", bit)) if use.own]
        assert [(use.block, use.does, use.line) for use in uses] == [("Cooling", "reads", line)]
    asked = [use for use in usage.of(ComNoItem("vf-s11", 0xFD00)) if use.own]
    assert [(use.block, use.does, use.line) for use in asked] == [("Cooling", "names", 15)]


def test_a_source_that_is_wrong_is_told(tmp_path: Path) -> None:
    own = tmp_path / "cooling.scl"
    own.write_text(OWN.replace("#alarm :=", "#nothing :="))
    with pytest.raises(DiagnosticError, match="nothing"):
        program_of(sources=(own,))
