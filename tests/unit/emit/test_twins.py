"""Code of gateways that are alike is worked on once, and everything comes out as if it were not."""

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from random import Random

import pytest

from fbgen.artefacts import with_artefacts
from fbgen.catalog import load_catalog
from fbgen.diagnostics import Diagnostic, DiagnosticError
from fbgen.emit import generator
from fbgen.emit.exchanged_words import exchange, is_one_to_one
from fbgen.emit.generated import GeneratedSet
from fbgen.plant import LANGUAGES, in_dialect, read_plant
from fbgen.resources import shipped
from fbgen.source import Source

CATALOG = load_catalog()


def line_gateway(
    name: str, drives: Mapping[str, int], number: int = 0, access: str = "per_identifier"
) -> str:
    """A TOSPBDP001 with these drives and their INV-NOs; its addresses begin at ten times `number`,
    its hardware identifier is as much above 270."""
    place = f"    input_address: {number * 10}\n    output_address: {number * 10}\n"
    layout = "gsd10"
    if access == "dpxx_dat":
        place, layout = f"    hardware_identifier: {270 + number}\n", "whole10"
    listed = "".join(
        f"      - {{name: {drive}, inv_no: {inv_no}, series: vf-s11, max_frequency_hz: 50.0}}\n"
        for drive, inv_no in drives.items()
    )
    return (
        f"  - name: {name}\n    type: tospbdp001\n    layout: {layout}\n    access: {access}\n"
        f"    profibus_address: {number + 3}\n{place}    drives:\n{listed}"
    )


def channel_gateway(name: str, number: int) -> str:
    """A PBDP-110 with drives at both channels."""
    return (
        f"  - name: {name}\n    type: pbdp110\n    layout: module2\n    access: dpxx_dat\n"
        f"    profibus_address: {number + 3}\n    hardware_identifier: {270 + number}\n"
        "    drives:\n"
        f"      - {{name: {name}_a, channel: A, series: vf-s11, max_frequency_hz: 60.0}}\n"
        f"      - {{name: {name}_b, channel: B, series: vf-s11, max_frequency_hz: 50.0}}\n"
    )


def plant_text(*gateways: str, more: str = "") -> str:
    return (
        "version: 1\nname: hall\ndialect: tia\nplc: s7-1500\n"
        f"sequences: [start_forward, set_frequency]\n{more}gateways:\n{''.join(gateways)}"
    )


def made(text: str, *templates: Path, dialect: str = "tia") -> GeneratedSet:
    plant = in_dialect(read_plant(Source("plant.yaml", text), CATALOG), dialect, CATALOG)
    found = generator.generate(plant, CATALOG, templates)
    return with_artefacts(found, plant, CATALOG, templates)


@contextmanager
def each_for_itself() -> Iterator[None]:
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(generator, "twins_among", lambda units: [])
        yield


def twins_of(text: str, *templates: Path, dialect: str = "tia") -> set[str]:
    """The blocks with another one's code; all that is generated is what it is without that."""
    found = made(text, *templates, dialect=dialect)
    with each_for_itself():
        alone = made(text, *templates, dialect=dialect)
    assert found.canonical is not None
    assert alone.canonical is not None
    assert not alone.canonical.bodies
    assert found.contents == alone.contents
    assert [(file.name, file.origins) for file in found.files] == [
        (file.name, file.origins) for file in alone.files
    ]
    assert (found.blocks, found.warnings) == (alone.blocks, alone.warnings)
    return set(found.canonical.bodies)


ALIKE = (
    line_gateway("gw1", {"fan11": 1, "fan12": 2}, 1),
    line_gateway("gw2", {"fan21": 1, "fan22": 2}, 2),
    line_gateway("gw3", {"fan31": 1, "fan32": 2}, 3),
)


@pytest.mark.parametrize("more", ["", "prefix: HALL2_\nlanguage: de\n"])
def test_gateways_that_differ_in_digits_of_names_are_worked_on_once(more: str) -> None:
    prefix = "HALL2_" if more else "TOS_"
    assert twins_of(plant_text(*ALIKE, more=more)) == {
        f"{prefix}{block}_gw{number}" for block in ("Gateway", "ConsistentIo") for number in (2, 3)
    }


def test_only_the_access_to_other_identifiers_is_worked_on_for_itself() -> None:
    gateways = [
        line_gateway(f"gw{number}", {f"m{number}": 1}, number, "dpxx_dat") for number in (1, 2)
    ]
    assert twins_of(plant_text(*gateways)) == {"TOS_Gateway_gw2"}


def test_gateways_for_process_data_have_twins_too() -> None:
    gateways = [channel_gateway(f"hall{number}", number) for number in (4, 5)]
    assert "PBDP_Gateway_hall5" in twins_of(plant_text(*gateways, ALIKE[0]))


@pytest.mark.parametrize(
    ("what", "other"),
    [
        ("another length", line_gateway("gw10", {"fan101": 1, "fan102": 2}, 2)),
        ("other letters", line_gateway("gx1", {"fan21": 1, "fan22": 2}, 2)),
        ("other INV-NOs", line_gateway("gw2", {"fan21": 3, "fan22": 4}, 2)),
        ("another number of drives", line_gateway("gw2", {"fan21": 1}, 2)),
    ],
)
def test_others_are_worked_on_for_themselves(what: str, other: str) -> None:
    assert not twins_of(plant_text(ALIKE[0], other))


@pytest.mark.parametrize("dialect", [name for name in LANGUAGES if name != "tia"])
def test_other_dialects_have_everything_in_few_files_and_no_twins(dialect: str) -> None:
    gateways = (one.replace("per_identifier", "process_image") for one in ALIKE[:2])
    assert not twins_of(plant_text(*gateways), dialect=dialect)


@pytest.mark.parametrize("seed", range(6))
def test_any_plant_comes_out_the_same(seed: int) -> None:
    random = Random(seed)
    gateways = []
    for number in range(1, 6):
        name = random.choice(("gw{}", "gw0{}", "hall_{}", "m{}x1"))
        start, count = random.choice(((1, 1), (1, 3), (16, 2)))
        drives = {
            random.choice(("d{}_{}", "d{}_{}", "pump{}{}")).format(number, place): start + place
            for place in range(count)
        }
        access = random.choice(("per_identifier", "per_identifier", "dpxx_dat", "process_image"))
        gateways.append(line_gateway(name.format(number), drives, number, access))
    twins_of(plant_text(*gateways))


def own_template(folder: Path, name: str, old: str, new: str) -> Path:
    text = (shipped("templates") / name).read_text("utf-8")
    assert old in text
    (folder / name).parent.mkdir(parents=True, exist_ok=True)
    (folder / name).write_text(text.replace(old, new), "utf-8")
    return folder


def refused(text: str, *templates: Path) -> list[Diagnostic]:
    with pytest.raises(DiagnosticError) as found:
        made(text, *templates)
    return list(found.value.diagnostics)


def test_what_is_wrong_in_the_code_of_twins_is_reported_of_each(tmp_path: Path) -> None:
    templates = own_template(
        tmp_path,
        "blocks/TOS_Gateway.scl.jinja",
        "#drives.line.restart := ",
        "#drives.line.restarted := ",
    )
    found = refused(plant_text(*ALIKE), templates)
    assert [str(one.span).split(":")[0] for one in found] == [
        f"TOS_Gateway_gw{number}.scl" for number in (1, 2, 3)
    ]


def test_names_that_are_not_the_gateways_own_are_looked_up_for_each(tmp_path: Path) -> None:
    """`limit1` is an Int and `limit2` a Bool: the same exchange of digits, and no twins."""
    own_template(
        tmp_path,
        "types/typeTosLine.udt.jinja",
        "   STRUCT\n",
        "   STRUCT\n      limit1 : Int;\n      limit2 : Bool;\n      limit3 : Int;\n",
    )
    own_template(
        tmp_path,
        "blocks/TOS_Gateway.scl.jinja",
        "BEGIN\n",
        "BEGIN\n   #drives.line.limit{{ gateway.name[2:] }} := 5;\n",
    )
    (found,) = refused(plant_text(*ALIKE), tmp_path)
    assert str(found.span).startswith("TOS_Gateway_gw2.scl")
    assert twins_of(plant_text(ALIKE[0], ALIKE[2]), tmp_path) == {"TOS_ConsistentIo_gw3"}


def test_a_value_that_stands_in_a_name_of_one_gateway_only_is_found_where_it_belongs(
    tmp_path: Path,
) -> None:
    """The retries are 2: no digit of `fan11`, but one of `fan21`."""
    own_template(
        tmp_path,
        "parts/unit.jinja",
        "timeout := #params.line.timeout, params",
        "timeout := #params.line.timeout + T#{{ unit.retries }}ms, params",
    )
    assert "TOS_Gateway_gw2" in twins_of(plant_text(*ALIKE), tmp_path)


def test_a_word_is_exchanged_everywhere_or_the_texts_are_not_alike() -> None:
    assert exchange({("a1", "a2"), ("x", "x")}) == {"a1": "a2"}
    assert exchange({("a1", "a2"), ("a1", "a1")}) is None
    assert exchange({("a1", "a2"), ("a1", "a3")}) is None


@pytest.mark.parametrize(
    ("before", "after"),
    [("a1", "b1"), ("a1", "a10"), ("1", "2"), ("16#A1", "16#A2"), ("60ms", "70ms"), (";", ",")],
)
def test_only_digits_of_names_are_exchanged(before: str, after: str) -> None:
    assert exchange({(before, after)}) is None


@pytest.mark.parametrize(
    ("words", "in_text"),
    [
        ({"a1": "a2"}, {"a1", "a2"}),
        ({"a1": "a2", "A1": "A3"}, {"a1"}),
        ({"a1": "a3", "a2": "A3"}, {"a1", "a2"}),
        ({"ob1": "ob2"}, {"ob1"}),
        ({"%IB10": "%IB12"}, {"ib10", "ib12"}),
    ],
)
def test_no_two_words_become_one_and_none_means_something_anyway(
    words: Mapping[str, str], in_text: set[str]
) -> None:
    assert not is_one_to_one(words, in_text)
    assert is_one_to_one({"c1": "c2"}, {*in_text, "c1"})
