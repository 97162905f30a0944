"""Generated text in German: nothing is left in English, and only texts change."""

import ast
import re
from pathlib import Path

import pytest
import yaml

import fbgen
from fbgen.blocks.literals import one_line
from fbgen.blocks.texts import texts_in
from fbgen.catalog import DeviceNetGateway, Located, ProcessDataGateway, load_catalog
from fbgen.diagnostics import DiagnosticError
from fbgen.emit.generator import generate
from fbgen.emit.template_texts import texts_of, translated
from fbgen.plant import LANGUAGES, Plant, changed, in_dialect, load_plant
from fbgen.resources import shipped

ROOT = Path(__file__).parents[3]
PACKAGE = Path(str(fbgen.__file__)).parent
CATALOG = load_catalog()
GERMAN = texts_in("de")
TEMPLATES = sorted(shipped("templates").rglob("*.jinja"))
BAD = ROOT / "tests" / "unit" / "bad" / "FB1112_translation.yaml"


def plant(dialect: str, language: str) -> Plant:
    """All sequences, one gateway, in a dialect and a language."""
    read = load_plant(ROOT / "examples" / "five_drives" / "plant.yaml", CATALOG)
    gateways = tuple(item.model_copy(update={"access": "process_image"}) for item in read.gateways)
    there = in_dialect(read.model_copy(update={"gateways": gateways}), dialect, CATALOG)
    return changed(there, CATALOG, language=language, sequences=tuple(sorted(CATALOG.sequences)))


def written(dialect: str, language: str) -> str:
    files = generate(plant(dialect, language), CATALOG)
    text = "\n".join(file.text for file in files.files if file.is_program)
    return text.replace(files.inputs_hash, "HASH")


@pytest.mark.parametrize("template", TEMPLATES, ids=lambda path: path.name)
def test_every_text_of_a_template_has_a_german_one(template: Path) -> None:
    missing = [text for text in texts_of(template.read_text("utf-8")) if text not in GERMAN]
    assert not missing, "add them to templates/texts/de.yaml"


@pytest.mark.parametrize("template", TEMPLATES, ids=lambda path: path.name)
def test_a_template_that_is_not_translated_stays_as_it_is(template: Path) -> None:
    text = template.read_text("utf-8")
    assert translated(text, lambda english: english) == text


def of_generator() -> set[str]:
    """What the generator says by `texts("...")`."""
    return {
        argument.value
        for folder in ("blocks", "emit")
        for path in (PACKAGE / folder).rglob("*.py")
        for node in ast.walk(ast.parse(path.read_text("utf-8")))
        if isinstance(node, ast.Call)
        and isinstance(node.func, ast.Name | ast.Attribute)
        and getattr(node.func, "id", getattr(node.func, "attr", "")) == "texts"
        for argument in node.args
        if isinstance(argument, ast.Constant) and isinstance(argument.value, str)
    }


def test_every_text_of_the_generator_has_a_german_one() -> None:
    used = of_generator()
    assert "Inputs and outputs: none" in used
    assert not {text for text in used if text not in GERMAN}


def shown(entry: Located, names: tuple[str, ...]) -> set[str]:
    return {one_line(str(value)) for name in names if (value := getattr(entry, name, None))}


def of_catalogue() -> set[str]:
    """What blocks show of trips and sequences."""
    found: set[str] = set()
    for drive in CATALOG.drives.values():
        found |= {text for trip in drive.trips for text in shown(trip, ("meaning",))}
    for sequence in CATALOG.sequences.values():
        found |= shown(sequence, ("title", "description", "does_not_protect"))
        for entry in (*sequence.parameters, *sequence.results, *sequence.steps):
            found |= shown(entry, ("title",))
    return found


def of_devicenet() -> set[str]:
    """What blocks, parameter sheets and tables of inputs and outputs show of DeviceNet options."""
    found: set[str] = set()
    for gateway in CATALOG.gateways.values():
        if isinstance(gateway, DeviceNetGateway):
            found |= {text for item in gateway.parameters for text in shown(item, ("title",))}
            found |= {text for item in gateway.parameters for text in item.values.values()}
            found |= set(gateway.word("extended_status").field("drive_status").values.values())
            for pair in gateway.assemblies:
                fields = (*pair.output.fields, *pair.input.fields)
                found |= {text for field in fields for text in shown(field, ("title",))}
    return found


def test_everything_shown_of_a_devicenet_option_has_german_texts() -> None:
    found = {text for text in of_devicenet() if re.search("[a-z]{3}", text)}
    assert "Startup" in found
    assert not {text for text in found if text not in GERMAN}


def test_every_trip_and_sequence_of_the_catalogue_has_german_texts() -> None:
    found = of_catalogue()
    assert len(found) > 60
    assert not {text for text in found if text not in GERMAN}


def test_no_german_text_is_left_of_what_is_not_said_any_more() -> None:
    used = of_catalogue() | of_devicenet()
    used |= {
        node.value
        for folder in ("blocks", "emit")
        for path in (PACKAGE / folder).rglob("*.py")
        for node in ast.walk(ast.parse(path.read_text("utf-8")))
        if isinstance(node, ast.Constant) and isinstance(node.value, str)
    }
    for drive in CATALOG.drives.values():
        used |= {text for comno in drive.comnos for text in shown(comno, ("title",))}
        used |= {text for comno in drive.comnos for text in comno.values.values()}
        used |= shown(drive, ("title",)) | {switch.name for switch in drive.switches}
        for entry in (*drive.settings, *drive.switches):
            used |= shown(entry, ("why", "when", "where", "stands"))
    for gateway in CATALOG.profibus_gateways.values():
        used |= {text for switch in gateway.switches for text in shown(switch, ("where", "stands"))}
        if isinstance(gateway, ProcessDataGateway):
            for wrong in gateway.parameter_channel.errors:
                used |= shown(wrong, ("title",))
        for layout in gateway.layouts:
            used |= {
                text
                for field in (*layout.input, *layout.output)
                for text in shown(field, ("title",))
            }
    for template in TEMPLATES:
        used |= set(texts_of(template.read_text("utf-8")))
    file = yaml.safe_load((shipped("templates") / "texts" / "de.yaml").read_text("utf-8"))
    known = [entry["en"] for entry in file["texts"]]
    assert not set(known) - used
    assert len(known) == len(set(known))


def test_trip_texts_fit_in_german_too() -> None:
    german = GERMAN.in_catalog(CATALOG)
    for drive in german.drives.values():
        for trip in drive.trips:
            assert len(f"{trip.display}: {trip.meaning}") <= 40, trip.meaning


@pytest.mark.parametrize("dialect", LANGUAGES)
def test_only_texts_change(dialect: str) -> None:
    english, german = (_code(written(dialect, language)) for language in ("en", "de"))
    assert german == english
    assert len(english) > 1000


def _code(text: str) -> list[str]:
    """The code without comments, titles, documentation and messages."""
    bare = re.sub(r"<documentation>.*?</documentation>", "", text, flags=re.DOTALL)
    bare = re.sub(r"\(\*.*?\*\)|//[^\n]*|'[^'\n]*'", "", bare, flags=re.DOTALL)
    bare = re.sub(r"(?m)^ *TITLE *=[^\n]*$", "", bare)
    return bare.split()


def test_no_comment_is_left_in_english() -> None:
    english, german = (
        [line.strip() for line in written("tia", language).splitlines()]
        for language in ("en", "de")
    )
    assert len(english) == len(german) or abs(len(english) - len(german)) < 60
    same = {line for line in english if line.startswith("//")} & set(german)
    words = re.compile(r"\b(the|of|and|is|to|for|not|by)\b")
    catalogue = " ".join(" ".join(source.text for source in CATALOG.sources).split())
    left = {line for line in same if words.search(line)}
    # the names of documents stay as they are
    assert not {
        line for line in left if line.lstrip("/ ").removeprefix("Quelle: ") not in catalogue
    }


def test_german_text_is_ascii_and_says_so_in_the_head() -> None:
    text = written("tia", "de")
    assert text.isascii()
    assert "// Erzeugt von fbgen" in text
    assert "TITLE = Ordnet, was auf der Linie" in text
    assert "'OC1: Ueberstrom beim Beschleunigen'" in text
    assert "Generated by" not in text


def test_umlauts_of_a_person_are_spelled_out() -> None:
    assert one_line("Förderer Ü für Größe") == "Foerderer Ue fuer Groesse"


def test_templates_of_a_person_may_bring_translations(tmp_path: Path) -> None:
    own = tmp_path / "blocks" / "TOS_TriggerCounter.scl.jinja"
    own.parent.mkdir()
    shipped_text = (shipped("templates") / "blocks" / own.name).read_text("utf-8")
    own.write_text(shipped_text.replace("\nBEGIN\n", "\nBEGIN\n   // my own remark\n\n"), "utf-8")
    read = plant("tia", "de")
    first = generate(read, CATALOG, [tmp_path])
    assert "// my own remark" in "".join(file.text for file in first.files)
    (tmp_path / "texts").mkdir()
    (tmp_path / "texts" / "de.yaml").write_text(
        "version: 1\ntexts:\n  - {en: my own remark, de: meine Anmerkung}\n", "utf-8"
    )
    second = generate(read, CATALOG, [tmp_path])
    assert "// meine Anmerkung" in "".join(file.text for file in second.files)
    assert first.inputs_hash != second.inputs_hash


def test_a_translation_that_does_not_fit_is_fb1112_at_its_place(tmp_path: Path) -> None:
    (tmp_path / "texts").mkdir()
    (tmp_path / "texts" / "de.yaml").write_text(BAD.read_text("utf-8"), "utf-8")
    with pytest.raises(DiagnosticError) as failure:
        texts_in("de", [tmp_path])
    found = failure.value.diagnostics
    assert [item.code for item in found] == ["FB1112"] * 3
    places = [(item.span.line, item.span.column) for item in found if item.span]
    assert places == [(6, 9), (9, 9), (11, 9)]
    assert all(item.help for item in found)
