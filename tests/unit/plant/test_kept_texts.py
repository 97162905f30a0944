"""The text of a plant is kept for the next process, and made anew after any change of an input."""

import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

from fbgen.catalog import Catalog, load_catalog, with_own_sequences
from fbgen.diagnostics import DiagnosticError
from fbgen.emit import generator
from fbgen.emit.generated import GeneratedSet
from fbgen.plant import Plant, changed, in_dialect, load_plant
from fbgen.resources import shipped
from fbgen.source import Source
from harness.installation import generated_sources, programs
from harness.sweep.rig import with_reply_time

PLANT = """\
version: 1
name: small
dialect: tia
language: de
plc: s7-1500
sequences: [stop, mine]
gateways:
  - name: gw1
    type: tospbdp001
    layout: gsd10
    access: per_identifier
    profibus_address: 2
    input_address: 256
    output_address: 256
    hardware_identifier: 260
    drives:
      - {name: pump, inv_no: 11, series: vf-s11, max_frequency_hz: 50.0}
"""


class Inputs:
    """A plant with a sequence of its own, a catalogue and templates, all in one folder."""

    def __init__(self, folder: Path) -> None:
        self.plant = folder / "plant.yaml"
        self.plant.write_text(PLANT, encoding="utf-8")
        own = folder / "sequences" / "mine.yaml"
        own.parent.mkdir()
        text = (shipped("catalog") / "sequences" / "stop.yaml").read_text("utf-8")
        own.write_text(text.replace("id: stop", "id: mine"), encoding="utf-8")
        self.catalog = folder / "catalog"
        shutil.copytree(shipped("catalog"), self.catalog)
        self.templates = folder / "templates"
        shutil.copytree(shipped("templates"), self.templates)

    def read(self) -> tuple[Plant, Catalog]:
        """Plant and catalogue as the next process reads them."""
        catalog = with_own_sequences(load_catalog([self.catalog]), self.plant.parent)
        return load_plant(self.plant, catalog), catalog

    def add_to(self, path: str) -> None:
        """One more byte in a file, with no meaning."""
        with (self.plant.parent / path).open("ab") as file:
            file.write(b"\n")


@pytest.fixture
def inputs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Inputs:
    made = Inputs(tmp_path)
    monkeypatch.setenv("FBGEN_CACHE", str(tmp_path / "cache"))
    monkeypatch.setattr(programs, "shipped", lambda kind: made.templates)
    return made


@pytest.fixture(scope="module")
def generated(tmp_path_factory: pytest.TempPathFactory) -> GeneratedSet:
    """What the generator gives for the inputs: the real thing, made once."""
    return generator.generate(*Inputs(tmp_path_factory.mktemp("once")).read())


@pytest.fixture
def calls(monkeypatch: pytest.MonkeyPatch, generated: GeneratedSet) -> list[str]:
    """The dialects in which the generator was asked."""
    asked: list[str] = []

    def generate(plan: Plant, catalog: Catalog) -> GeneratedSet:
        asked.append(plan.dialect)
        return generated

    monkeypatch.setattr(generator, "generate", generate)
    return asked


def parts(sources: list[Source]) -> list[tuple[object, ...]]:
    return [(source.name, source.text, source.origins) for source in sources]


def test_the_second_time_the_same_comes_without_the_generator(
    inputs: Inputs, calls: list[str]
) -> None:
    first = generated_sources(*inputs.read())
    second = generated_sources(*inputs.read())
    assert calls == ["tia"]
    assert parts(second) == parts(first)
    assert any(origin is not None and origin.inputs for one in second for _, origin in one.origins)


@pytest.mark.parametrize(
    "path",
    [
        "plant.yaml",
        "sequences/mine.yaml",
        "catalog/drives/vf-s11.yaml",
        "catalog/gateways/tospbdp001.yaml",
        "catalog/sequences/stop.yaml",
        "templates/blocks/TOS_Line.scl.jinja",
        "templates/texts/de.yaml",
    ],
)
def test_a_byte_more_in_any_file_asks_the_generator_again(
    inputs: Inputs, calls: list[str], path: str
) -> None:
    generated_sources(*inputs.read())
    inputs.add_to(path)
    generated_sources(*inputs.read())
    assert calls == ["tia", "tia"]


def test_a_new_template_asks_the_generator_again(inputs: Inputs, calls: list[str]) -> None:
    generated_sources(*inputs.read())
    (inputs.templates / "blocks" / "New.scl.jinja").touch()
    generated_sources(*inputs.read())
    assert calls == ["tia", "tia"]


@pytest.mark.parametrize(
    "change",
    [
        lambda plan, catalog: (in_dialect(plan, "step7", catalog), catalog),
        lambda plan, catalog: (changed(plan, catalog, prefix="A_"), catalog),
        lambda plan, catalog: (changed(plan, catalog, cycle_time_ms=20.0), catalog),
        lambda plan, catalog: (plan, with_reply_time(catalog, 77)),
    ],
)
def test_what_is_changed_after_reading_asks_the_generator_again(
    inputs: Inputs,
    calls: list[str],
    change: Callable[[Plant, Catalog], tuple[Plant, Catalog]],
) -> None:
    plan, catalog = inputs.read()
    generated_sources(plan, catalog)
    generated_sources(*change(plan, catalog))
    assert len(calls) == 2


def test_a_plant_at_another_place_asks_the_generator_again(
    inputs: Inputs, calls: list[str]
) -> None:
    generated_sources(*inputs.read())
    inputs.plant = inputs.plant.rename(inputs.plant.with_name("other.yaml"))
    generated_sources(*inputs.read())
    assert len(calls) == 2


def test_a_plant_that_cannot_be_generated_fails_the_second_time_too(
    inputs: Inputs, calls: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(plan: Plant, catalog: Catalog) -> GeneratedSet:
        calls.append(plan.dialect)
        raise DiagnosticError([])

    monkeypatch.setattr(generator, "generate", refuse)
    for _ in range(2):
        with pytest.raises(DiagnosticError):
            generated_sources(*inputs.read())
    assert len(calls) == 2


@pytest.mark.usefixtures("calls")
def test_nothing_is_written_but_in_the_cache_folder(inputs: Inputs) -> None:
    folder = inputs.plant.parent
    before = set(folder.rglob("*"))
    generated_sources(*inputs.read())
    written = set(folder.rglob("*")) - before
    assert {path.parent for path in written} == {folder, folder / "cache"}
    assert [path for path in written if path.parent == folder] == [folder / "cache"]
