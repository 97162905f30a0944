"""The log of a campaign: what is gone on with, and what is refused with its place."""

import json
import shutil
from pathlib import Path

import pytest

from fbgen.diagnostics import Diagnostic, DiagnosticError
from harness.verify.campaign import CampaignSettings
from harness.verify.campaign.files import campaign_settings
from harness.verify.campaign.log import open_log

ROOT = Path(__file__).parents[4]
ONE = ROOT / "tests" / "scenarios" / "one_drive.yaml"
BAD = ROOT / "tests" / "unit" / "bad" / "FB8072_other_campaign.jsonl"


def refused(path: Path, settings: CampaignSettings) -> Diagnostic:
    with pytest.raises(DiagnosticError) as failure:
        open_log(path, settings)
    (found,) = failure.value.diagnostics
    assert found.code == "FB8072"
    return found


def begun(folder: Path) -> tuple[Path, CampaignSettings]:
    """A campaign about a plant of its own, and the log that it has begun."""
    plant = folder / "plant.yaml"
    shutil.copy(ONE, plant)
    settings = campaign_settings([plant], [])
    log = folder / "log.jsonl"
    open_log(log, settings)[0].close()
    return log, settings


def test_the_log_of_another_campaign_is_refused_at_its_first_line() -> None:
    found = refused(BAD, CampaignSettings((ONE.as_posix(),), ("line_noise",)))
    assert found.span is not None
    assert (found.span.line, found.span.column) == (1, 1)
    assert "is not the log of this campaign" in found.message


def test_what_is_no_log_is_refused(tmp_path: Path) -> None:
    log = tmp_path / "log.jsonl"
    log.write_bytes(b"\xff no log\n")
    assert "is not the log" in refused(log, CampaignSettings((ONE.as_posix(),), ())).message


def test_a_log_is_gone_on_with_while_the_plant_is_the_same(tmp_path: Path) -> None:
    log, settings = begun(tmp_path)
    journal, chunks = open_log(log, settings)
    journal.close()
    assert chunks == []


def test_a_plant_that_has_changed_since_is_told(tmp_path: Path) -> None:
    log, settings = begun(tmp_path)
    plant = tmp_path / "plant.yaml"
    plant.write_text(plant.read_text("utf-8") + "# 20 Hz from now on\n", "utf-8")
    assert f"{plant.as_posix()} has changed since" in refused(log, settings).message


def test_a_sequence_of_the_plant_that_has_changed_since_is_told(tmp_path: Path) -> None:
    (tmp_path / "sequences").mkdir()
    own = ROOT / "tests" / "scenarios" / "own_sequences" / "sequences"
    sequence = Path(shutil.copy(next(own.glob("*.yaml")), tmp_path / "sequences"))
    log, settings = begun(tmp_path)
    sequence.write_text(sequence.read_text("utf-8") + "\n# changed\n", "utf-8")
    assert "has changed since" in refused(log, settings).message


def test_another_version_of_fbgen_is_told(tmp_path: Path) -> None:
    log, settings = begun(tmp_path)
    head = json.loads(log.read_text("utf-8"))
    log.write_text(json.dumps(head | {"fbgen": "0.0.1"}) + "\n", "utf-8")
    assert "was written by fbgen 0.0.1" in refused(log, settings).message
