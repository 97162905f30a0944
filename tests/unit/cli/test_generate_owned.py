"""`fbgen generate` and the file that belongs to the user."""

from pathlib import Path

from tests.unit.artefacts.reading import TWO_GATEWAYS
from tests.unit.artefacts.test_owned_files import FILES, WITHOUT_FAN
from tests.unit.cli.running import Fbgen


def test_the_command_says_what_does_not_fit_and_keeps_the_file(
    fbgen: Fbgen, tmp_path: Path
) -> None:
    plant = tmp_path / "plant.yaml"
    out = tmp_path / "out"
    plant.write_text(WITHOUT_FAN, "utf-8")
    assert fbgen("generate", str(plant), "-o", str(out)).status == 0
    plant.write_text(TWO_GATEWAYS, "utf-8")
    run = fbgen("generate", str(plant), "-o", str(out))
    assert run.status == 0
    assert "warning[FB5023]" in run.err
    assert "south.fan.maxFrequency" in run.err
    assert "fan" not in (out / FILES["tia"]).read_text("utf-8")
