"""Any line of any generated file says which template line and which entries it is from."""

import random
import re
from pathlib import Path

import pytest

from fbgen.catalog import load_catalog
from fbgen.diagnostics import DiagnosticError
from fbgen.emit.generated import GeneratedSet
from fbgen.emit.generator import generate
from fbgen.emit.origin_map import ORIGIN_MAP, explain_line
from fbgen.emit.writing import write_set
from fbgen.plant import LANGUAGES, in_dialect, load_plant
from fbgen.resources import shipped
from fbgen.source import Origin

PLANT = Path(__file__).parents[3] / "examples" / "five_drives" / "plant.yaml"
CATALOG = load_catalog()
SEED = 20
WORD = re.compile(r"[A-Za-z_]{3,}")


@pytest.fixture(scope="module")
def folders(tmp_path_factory: pytest.TempPathFactory) -> dict[str, tuple[Path, GeneratedSet]]:
    """The folder and the files of each dialect."""
    plant = load_plant(PLANT, CATALOG)
    gateways = tuple(item.model_copy(update={"access": "process_image"}) for item in plant.gateways)
    plant = plant.model_copy(update={"gateways": gateways})
    found = {}
    for dialect in LANGUAGES:
        folder = tmp_path_factory.mktemp(dialect)
        files = generate(in_dialect(plant, dialect, CATALOG), CATALOG)
        write_set(files, folder)
        found[dialect] = (folder, files)
    return found


def line_of(origin: Origin) -> str:
    """The line that an origin names, in the template, the catalogue or the plant file."""
    folder, _, name = origin.file.partition("/")
    shipped_folder = folder in ("templates", "catalog") and not origin.file.startswith("/")
    path = shipped(folder) / name if shipped_folder else Path(origin.file)
    return path.read_text("utf-8").splitlines()[origin.line - 1]


def around(origin: Origin) -> str:
    """The lines of a template about that one: a dialect may say one line in several."""
    lines = (shipped("templates") / origin.file.removeprefix("templates/")).read_text("utf-8")
    return "\n".join(lines.splitlines()[max(0, origin.line - 4) : origin.line + 3])


def words(text: str) -> set[str]:
    """The words of a line; of one of a template without what Jinja fills in."""
    plain = re.sub(r"\{[{%].*?[%}]\}", " ", text)
    return {word.casefold() for word in WORD.findall(plain)}


@pytest.mark.parametrize("dialect", LANGUAGES)
def test_twenty_lines_at_random_are_from_the_lines_that_they_name(
    dialect: str, folders: dict[str, tuple[Path, GeneratedSet]]
) -> None:
    folder, files = folders[dialect]
    chosen = random.Random(SEED)
    programs = [file for file in files.files if file.is_program]
    places = [(file.name, n) for file in programs for n in range(1, file.text.count("\n") + 1)]
    told = near = exact = 0
    for name, number in chosen.sample(places, 20):
        found = explain_line(folder / name, number)
        assert found.origins, (name, number)
        template, *values = found.origins
        assert template.is_template
        assert not any(value.is_template for value in values)
        for origin in (*values, *(item for value in values for item in value.inputs)):
            assert line_of(origin).strip()
        mine = words(found.text)
        # the head of a block, which the generator writes itself, is from its first line
        if found.own and mine and template.line > 1 and not found.text.lstrip().startswith("<"):
            told += 1
            printed = "{{" in line_of(template)
            exact += printed or bool(mine & words(line_of(template)))
            near += printed or bool(mine & words(around(template)))
    # a dialect adds lines of its own: these have the block
    assert near >= 0.85 * told
    assert exact >= 0.7 * told


@pytest.mark.parametrize("dialect", LANGUAGES)
def test_a_comno_leads_to_its_entry_with_manual_and_section(
    dialect: str, folders: dict[str, tuple[Path, GeneratedSet]]
) -> None:
    folder, files = folders[dialect]
    setpoint = CATALOG.drive("vf-s11").comno("frequency_setpoint")
    lines = [
        explain_line(folder / file.name, number)
        for file in files.files
        if file.is_program
        for number, text in enumerate(file.text.splitlines(), start=1)
        if f"16#{setpoint.hex};" in text and "comNo" in text
    ]
    assert lines
    for line in lines:
        values = [one for one in line.origins if one.what.startswith(f"ComNo {setpoint.hex}")]
        assert len(values) == 1, line
        assert values[0].file == "catalog/drives/vf-s11.yaml"
        assert values[0].source == setpoint.source


def test_a_time_names_the_times_it_was_worked_out_from(
    folders: dict[str, tuple[Path, GeneratedSet]],
) -> None:
    folder, files = folders["tia"]
    (gateway,) = [file for file in files.files if file.name == "TOS_Gateway_gw1.scl"]
    number = next(n for n, text in enumerate(gateway.text.splitlines(), 1) if "gap := T#" in text)
    (value,) = explain_line(folder / gateway.name, number).origins[1:]
    assert "reply_max" in " ".join(item.what for item in value.inputs)
    for item in value.inputs:
        assert "ms" in line_of(item) or "baud" in line_of(item) or item.line


def test_a_file_that_was_changed_since_is_fb9017(
    folders: dict[str, tuple[Path, GeneratedSet]], tmp_path: Path
) -> None:
    folder, _ = folders["tia"]
    for name in ("TOS_Main.scl", ORIGIN_MAP):
        (tmp_path / name).write_bytes((folder / name).read_bytes())
    assert explain_line(tmp_path / "TOS_Main.scl", 1).origins
    with (tmp_path / "TOS_Main.scl").open("a") as file:
        file.write("// mine\n")
    for name in ("TOS_Main.scl", ORIGIN_MAP, "missing.scl"):
        with pytest.raises(DiagnosticError) as failure:
            explain_line(tmp_path / name, 1)
        assert failure.value.diagnostics[0].code == "FB9017"
        assert failure.value.diagnostics[0].help
    (tmp_path / ORIGIN_MAP).write_text("{")
    with pytest.raises(DiagnosticError, match="damaged"):
        explain_line(tmp_path / "TOS_Main.scl", 1)
    (tmp_path / ORIGIN_MAP).unlink()
    with pytest.raises(DiagnosticError, match="there is no"):
        explain_line(tmp_path / "TOS_Main.scl", 1)


def test_a_line_beyond_the_end_is_fb9018(folders: dict[str, tuple[Path, GeneratedSet]]) -> None:
    folder, files = folders["tia"]
    count = next(file for file in files.files if file.name == "TOS_Main.scl").text.count("\n")
    for line in (0, count + 1):
        with pytest.raises(DiagnosticError) as failure:
            explain_line(folder / "TOS_Main.scl", line)
        assert failure.value.diagnostics[0].code == "FB9018"
        assert str(count) in failure.value.diagnostics[0].help
