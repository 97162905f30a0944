"""Series with `like:`: what they take over of another, and how sure it is then."""

from pathlib import Path

import pytest

from fbgen.catalog import load_catalog
from fbgen.diagnostics import Diagnostic, DiagnosticError
from harness.drives import Inverter
from harness.kernel import NS_PER_MS, Kernel
from harness.line import Line
from tests.vectors.reading import entries

CATALOG = load_catalog()
OTHERS = ("g7", "vf-a7", "vf-nc1", "vf-p7", "vf-s7", "vf-s9")


def _findings(tmp_path: Path, text: str) -> list[Diagnostic]:
    folder = tmp_path / "drives"
    folder.mkdir()
    (folder / "mine.yaml").write_text(text, encoding="utf-8")
    with pytest.raises(DiagnosticError) as raised:
        load_catalog([tmp_path])
    return list(raised.value.diagnostics)


MINE = """version: 1
id: mine
like: vf-s9
title: Mine
protocol: toshiba
source: my manual
link:
  {command: command_word, setpoint: frequency_setpoint, status: status, trip: trip_code,
   alarm: alarm, output_frequency: output_frequency, output_current: output_current_held,
   maximum_frequency: maximum_frequency, timeout: communication_timeout, inv_no: inverter_number}
times:
  reply_max: {ms: 9, source: my manual}
  boot: {ms: 1, source: my manual}
  reset_silence: {ms: 1, source: my manual}
"""


@pytest.mark.parametrize("series", OTHERS)
def test_a_series_has_every_comno_of_the_vf_s11_under_the_same_name(series: str) -> None:
    names = {item.name: item.number for item in CATALOG.drive("vf-s11").comnos}
    ours = {item.name: item.number for item in CATALOG.drive(series).comnos}
    assert ours.items() >= names.items()


@pytest.mark.parametrize("series", OTHERS)
def test_what_is_taken_over_is_unverified_unless_it_is_confirmed(series: str) -> None:
    drive = CATALOG.drive(series)
    own = {item.name for item in drive.comnos if not (item.source or "").startswith("as ")}
    verified = {item.name for item in drive.comnos if item.status == "verified"}
    confirmed = {number for entry in drive.confirmed for number in entry.comnos}
    assert {item.number for item in drive.comnos if item.name in verified} >= confirmed
    assert verified == own
    assert all(trip.status == "unverified" for trip in drive.trips)


def test_the_vf_s9_has_the_words_of_the_interfaces_manual_and_no_other_bits() -> None:
    drive = CATALOG.drive("vf-s9")
    for entry, word in (("command", drive.command_word), ("status", drive.word("status"))):
        rows = entries("pbdp110_words")[f"pbdp.{entry}_word"]["bits"]
        theirs = {row["bit"] for row in rows if row["name"] != "Reserved"} - (
            {15} if entry == "status" else set()
        )
        assert {bit.low for bit in word.bits} == theirs
        assert word.status == "verified"


@pytest.mark.parametrize("series", ["g7", "vf-a7", "vf-nc1", "vf-p7", "vf-s7"])
def test_the_words_of_the_others_are_those_of_the_vf_s9_and_unverified(series: str) -> None:
    word, known = CATALOG.drive(series).command_word, CATALOG.drive("vf-s9").command_word
    assert word.bits == known.bits
    assert (word.status, known.status) == ("unverified", "verified")


@pytest.mark.parametrize(
    ("series", "vector"), [("vf-nc1", "vf_nc1"), ("vf-a7", "vf_a7_p7"), ("vf-p7", "vf_a7_p7")]
)
def test_reply_times_are_those_of_the_manual(series: str, vector: str) -> None:
    time = CATALOG.drive(series).times.reply_max
    assert time.ms == entries("tospbdp001_telegrams")[f"tos.9.reply.{vector}"]["maximum_ms"]
    assert time.status == "verified"


@pytest.mark.parametrize("series", ["g7", "vf-s7", "vf-s9"])
def test_a_reply_time_that_no_document_tells_is_marked(series: str) -> None:
    assert CATALOG.drive(series).times.reply_max.status == "unverified"


@pytest.mark.parametrize("series", OTHERS)
def test_every_series_can_be_simulated(series: str) -> None:
    kernel = Kernel(1)
    drive = Inverter(kernel, Line(kernel), CATALOG.drive(series))
    drive.write_ram(0xFA01, 2000)
    drive.write_ram(0xFA00, 0xC600)
    kernel.run_for(100 * NS_PER_MS)
    assert drive.running
    status = drive.read_word(0xFE01)
    assert status == 0x0600, "run and reverse, and no bit that this series does not have"


def test_a_series_like_one_that_is_not_there_is_told_at_its_place(tmp_path: Path) -> None:
    (found,) = _findings(tmp_path, MINE.replace("like: vf-s9", "like: vf-s8"))
    assert (found.code, found.message) == ("FB1105", "there is no drive series 'vf-s8'")
    assert found.span is not None
    assert (found.span.line, found.span.column) == (3, 7)


def test_a_series_like_itself_is_told(tmp_path: Path) -> None:
    (found,) = _findings(tmp_path, MINE.replace("like: vf-s9", "like: mine"))
    assert found.code == "FB1105"
    assert "which is like it" in found.message


def test_a_confirmed_comno_must_be_there(tmp_path: Path) -> None:
    text = MINE + "confirmed:\n  - {comnos: [FA00, FA99], source: my manual}\n"
    (found,) = _findings(tmp_path, text)
    assert (found.code, found.message) == ("FB1105", "'vf-s9' has no ComNo 'FA99'")
    assert found.span is not None
    assert found.span.text == "FA99"


def test_to_confirm_without_another_series_says_nothing(tmp_path: Path) -> None:
    text = MINE.replace("like: vf-s9\n", "")
    found = _findings(tmp_path, text + "confirmed:\n  - {comnos: [FA00], source: my manual}\n")
    assert any("this series is like no other" in item.message for item in found)


def test_an_own_comno_replaces_the_other_one(tmp_path: Path) -> None:
    folder = tmp_path / "drives"
    folder.mkdir()
    own = "comnos:\n  - {number: FA01, name: frequency_setpoint, title: Own, source: my manual}\n"
    (folder / "mine.yaml").write_text(MINE + own, encoding="utf-8")
    drive = load_catalog([tmp_path]).drive("mine")
    assert drive.comno("FA01").title == "Own"
    assert [item.number for item in drive.comnos].count(0xFA01) == 1
