"""The parameter block is written once and then belongs to the user."""

import json
import re
from pathlib import Path

import pytest

from fbgen.diagnostics import Diagnostic, Severity
from fbgen.emit.folder import FILE_LIST
from fbgen.emit.owned import misfits
from fbgen.emit.writing import write_set
from harness import load_program
from tests.unit.artefacts.reading import TWO_GATEWAYS, generated

FILES = {
    "tia": "TOS_Parameters.db",
    "step7": "hall_parameters.scl",
    "twincat": "TOS_ParameterList.TcGVL",
}
DIALECTS = list(FILES)
WITHOUT_FAN = "".join(line for line in TWO_GATEWAYS.splitlines(True) if "name: fan" not in line)


def written(folder: Path, dialect: str, text: str = TWO_GATEWAYS) -> Path:
    """The user's file after generating into the folder."""
    write_set(generated(text, dialect), folder)
    return folder / FILES[dialect]


def found(folder: Path, dialect: str, text: str = TWO_GATEWAYS) -> list[Diagnostic]:
    return misfits(generated(text, dialect), folder)


@pytest.mark.parametrize("dialect", DIALECTS)
@pytest.mark.parametrize("force", [False, True])
def test_what_the_user_wrote_is_never_overwritten(
    dialect: str, force: bool, tmp_path: Path
) -> None:
    path = written(tmp_path, dialect)
    mine = path.read_bytes().replace(b"60.0", b"45.0")
    assert mine != path.read_bytes()
    path.write_bytes(mine)
    write_set(generated(TWO_GATEWAYS, dialect), tmp_path, force=force)
    assert path.read_bytes() == mine
    write_set(generated(WITHOUT_FAN, dialect), tmp_path, force=force)
    assert path.read_bytes() == mine


@pytest.mark.parametrize("dialect", DIALECTS)
def test_a_file_that_is_not_there_is_written(dialect: str, tmp_path: Path) -> None:
    path = written(tmp_path, dialect)
    original = path.read_bytes()
    path.unlink()
    assert path.name in write_set(generated(TWO_GATEWAYS, dialect), tmp_path).written
    assert path.read_bytes() == original


def test_it_is_in_no_list_of_files_that_may_go(tmp_path: Path) -> None:
    path = written(tmp_path, "tia")
    assert path.name not in json.loads((tmp_path / FILE_LIST).read_text("ascii"))["files"]
    write_set(generated(TWO_GATEWAYS, "step7"), tmp_path)
    assert path.exists()


@pytest.mark.parametrize("dialect", DIALECTS)
def test_other_values_fit(dialect: str, tmp_path: Path) -> None:
    path = written(tmp_path, dialect)
    mine = path.read_bytes().replace(b"atSetpoint := 0.5", b"atSetpoint := 0.2")
    assert mine != path.read_bytes()
    path.write_bytes(mine)
    assert found(tmp_path, dialect) == []


@pytest.mark.parametrize("dialect", DIALECTS)
def test_a_highest_frequency_that_the_plant_file_has_changed_is_told_at_its_line(
    dialect: str, tmp_path: Path
) -> None:
    path = written(tmp_path, dialect)
    text = TWO_GATEWAYS.replace("max_frequency_hz: 60.0", "max_frequency_hz: 70.5")
    misfits_found = found(tmp_path, dialect, text)
    assert len(misfits_found) == TWO_GATEWAYS.count("max_frequency_hz: 60.0")
    for misfit in misfits_found:
        assert (misfit.code, misfit.severity) == ("FB5023", Severity.WARNING)
        assert ".maxFrequency is 60 Hz here, and max_frequency_hz of the plant" in misfit.message
        assert misfit.message.endswith(" 70.5 Hz")
        assert misfit.span is not None
        line, _ = misfit.span.source.line_column(misfit.span.start)
        assert "60.0" in path.read_text("utf-8").splitlines()[line - 1]


@pytest.mark.parametrize("dialect", DIALECTS)
def test_a_drive_that_is_new_has_no_values_in_it(dialect: str, tmp_path: Path) -> None:
    written(tmp_path, dialect, WITHOUT_FAN)
    (misfit,) = found(tmp_path, dialect)
    assert (misfit.code, misfit.severity) == ("FB5023", Severity.WARNING)
    assert "south.fan.minFrequency, south.fan.maxFrequency" in misfit.message
    assert FILES[dialect] in misfit.message


@pytest.mark.parametrize("dialect", DIALECTS)
def test_a_drive_that_is_gone_is_told_once_at_its_first_line(dialect: str, tmp_path: Path) -> None:
    path = written(tmp_path, dialect)
    (gone,) = found(tmp_path, dialect, WITHOUT_FAN)
    assert gone.code == "FB5023"
    assert gone.span is not None
    line, _ = gone.span.source.line_column(gone.span.start)
    text = path.read_text("utf-8").splitlines()[line - 1]
    assert "minFrequency" in text
    assert "south.fan does not exist any more" in gone.message
    assert "the 6 lines of south.fan" in (gone.help or "")


def test_one_parameter_that_is_unknown_is_told_by_its_name(tmp_path: Path) -> None:
    path = written(tmp_path, "tia")
    text = path.read_text("ascii")
    path.write_text(text.replace("END_DATA", "   south.fan.ramp := 1.0;\nEND_DATA"), "ascii")
    (unknown,) = found(tmp_path, "tia")
    assert unknown.message == "the parameter south.fan.ramp does not exist any more"


@pytest.mark.parametrize("dialect", DIALECTS)
def test_a_parameter_that_an_older_file_does_not_have_is_told_and_has_its_safe_default(
    dialect: str, tmp_path: Path
) -> None:
    path = written(tmp_path, dialect)
    line = rb".*interlockInhibits.*\n" if dialect != "twincat" else rb",\s*interlockInhibits := \w+"
    older, taken_out = re.subn(line, b"", path.read_bytes())
    assert taken_out == 3
    path.write_bytes(older)
    (misfit,) = found(tmp_path, dialect)
    assert "north.infeed.interlockInhibits" in misfit.message
    names = [file.name for file in generated(TWO_GATEWAYS, dialect).files if file.is_program]
    program = load_program([tmp_path / name for name in names], dialect=dialect)
    assert program.globals.TOS_Parameters.north.infeed.interlockInhibits


def test_a_file_that_cannot_be_read_is_told(tmp_path: Path) -> None:
    written(tmp_path, "tia").write_text("DATA_BLOCK oops", "utf-8")
    (misfit,) = found(tmp_path, "tia")
    assert "cannot be read" in misfit.message


@pytest.mark.parametrize("dialect", ["iec", "plcopen"])
def test_a_dialect_with_one_text_takes_the_values_from_the_plant_file(
    dialect: str, tmp_path: Path
) -> None:
    text = TWO_GATEWAYS.replace(
        "max_frequency_hz: 60.0}", "max_frequency_hz: 60.0, parameters: {min_frequency_hz: 12.5}}"
    )
    files = generated(text, dialect).files
    assert not any(file.is_owned for file in files)
    assert any(re.search(r"minFrequency.{0,80}12\.5", file.text, re.DOTALL) for file in files)


@pytest.mark.parametrize("dialect", DIALECTS)
def test_the_users_values_run(dialect: str, tmp_path: Path) -> None:
    """The whole folder, with the user's file in it, is a program that starts with their values."""
    path = written(tmp_path, dialect)
    path.write_bytes(path.read_bytes().replace(b"60.0", b"45.0"))
    names = [file.name for file in generated(TWO_GATEWAYS, dialect).files if file.is_program]
    program = load_program([tmp_path / name for name in names], dialect=dialect)
    parameters = program.globals.TOS_Parameters
    assert parameters.south.pump.maxFrequency == 45.0
    assert parameters.north.infeed.maxFrequency == 50.0
