"""Manuals: what is wrong in them, and examples of words that they print."""

from pathlib import Path

import pytest

from fbgen.catalog import load_catalog
from fbgen.diagnostics import DiagnosticError

CATALOG = load_catalog()
MANUAL = """\
version: 1
id: mine
title: Mine
source: Mine
devices: [vf-s11]
findings:
  - {name: one, kind: typo, says: a, taken: b, why: c, source: "Mine, 1"}
"""


def wrong(folder: Path, text: str) -> tuple[str, str]:
    (folder / "manuals").mkdir(exist_ok=True)
    (folder / "manuals" / "mine.yaml").write_text(text)
    with pytest.raises(DiagnosticError) as failure:
        load_catalog((folder,))
    found = failure.value.diagnostics[0]
    return found.code, found.message


def test_every_manual_of_the_four_is_there_with_a_reason_for_each_reading() -> None:
    assert {"tospbdp001-manual", "pbdp110-manual", "vf-as1-rs485-manual", "dev003z-manual"} <= set(
        CATALOG.manuals
    )
    for manual in CATALOG.manuals.values():
        for finding in manual.findings:
            assert finding.source is not None
            assert manual.title.split()[0] in finding.source or manual.source in finding.source


def test_a_reading_that_is_an_option_names_one_that_there_is() -> None:
    layouts = {layout.name for layout in CATALOG.telegram_gateway("tospbdp001").layouts}
    assert {"gsd10", "doc9"} <= layouts
    options = {option.id for option in CATALOG.drive("vf-s11").options}
    assert {"timeout_restart", "broadcast_reads"} <= options


def test_a_manual_of_an_own_catalogue_is_read(tmp_path: Path) -> None:
    (tmp_path / "manuals").mkdir()
    (tmp_path / "manuals" / "mine.yaml").write_text(MANUAL)
    assert load_catalog((tmp_path,)).manuals["mine"].findings[0].taken == "b"


def test_an_unknown_device_a_name_twice_and_no_source_are_told(tmp_path: Path) -> None:
    assert wrong(tmp_path, MANUAL.replace("[vf-s11]", "[vf-s99]"))[0] == "FB1105"
    again = MANUAL + MANUAL.splitlines()[-1] + "\n"
    assert wrong(tmp_path, again)[0] == "FB1102"
    assert wrong(tmp_path, MANUAL.replace(', source: "Mine, 1"', ""))[0] == "FB1103"


def test_examples_of_words_have_the_bits_that_their_titles_speak_of() -> None:
    word = CATALOG.word("vf-s11.command")
    shown = {
        f"{one.value:04X}": {item.field.name for item in word.decode(one.value) if item.value}
        for one in word.examples
    }
    assert shown["C400"] == {"network_command", "network_frequency", "run"}
    assert shown["C200"] == {"network_command", "network_frequency", "reverse"}
    assert shown["2000"] == {"fault_reset"}


def test_an_example_with_bits_that_the_word_does_not_have_is_told(tmp_path: Path) -> None:
    shipped = (Path(__file__).parents[3] / "catalog/gateways/tospbdp001.yaml").read_text("utf-8")
    (tmp_path / "gateways").mkdir()
    begin = shipped.index("  - name: status\n")
    spoilt = shipped[:begin] + shipped[begin:].replace("- bit: 12..8", "- bit: 11..8", 1)
    (tmp_path / "gateways" / "tospbdp001.yaml").write_text(spoilt)
    with pytest.raises(DiagnosticError, match="example DF00 sets bits"):
        load_catalog((tmp_path,))
