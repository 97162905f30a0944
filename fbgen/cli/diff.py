"""`fbgen diff`: what a changed catalogue or plant file changes in the generated blocks."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from fbgen.cli import FINDINGS
from fbgen.cli.dialects import PlantDialectOption
from fbgen.cli.examples import examples
from fbgen.cli.layers import CatalogOption, JsonOption
from fbgen.cli.output import counted, result, result_json, say

if TYPE_CHECKING:
    from collections.abc import Iterable

    from fbgen.catalog import Catalog
    from fbgen.catalog.differences import Difference
    from fbgen.emit.affected import ChangedLine, Comparison
    from fbgen.emit.block_list import BlockChanges
    from fbgen.emit.generated import GeneratedSet
    from fbgen.plant import Plant

_SHIPPED = "shipped"


def register(program: typer.Typer) -> None:
    """Add the command to the program."""
    program.command(
        epilog=examples(
            "fbgen diff plant_2025.yaml plant.yaml",
            "fbgen diff old_catalog new_catalog --plant plant.yaml",
            "fbgen diff shipped our_catalog --plant plant.yaml --json",
            "fbgen diff old_catalog new_catalog --plant plant.yaml --dialect step7",
        )
    )(diff)


def diff(
    old: Annotated[
        str,
        typer.Argument(metavar="OLD", help="A plant file, a catalogue folder, or shipped."),
    ],
    new: Annotated[str, typer.Argument(metavar="NEW", help="The same kind of thing.")],
    plant: Annotated[
        Path | None,
        typer.Option("--plant", metavar="PLANT", help="The plant file, to compare catalogues."),
    ] = None,
    dialect: PlantDialectOption = None,
    catalog: CatalogOption = None,
    as_json: JsonOption = False,
) -> None:
    """Show what a changed catalogue or plant file changes in the generated blocks.

    Each entry that differs is listed with the lines of the generated text that it has changed, then
    changed lines that follow from none of them alone, and blocks that are new, renamed or gone.
    `shipped` stands for the catalogue that comes with fbgen. Nothing is written. The exit status is
    0 where nothing differs, 1 where something does.
    """
    from fbgen.catalog import load_catalog
    from fbgen.catalog.differences import catalogue_differences, differences
    from fbgen.emit.affected import compared
    from fbgen.emit.block_list import block_changes
    from fbgen.emit.generator import generate
    from fbgen.plant import load_plant

    if all(_is_catalogue(one) for one in (old, new)):
        if plant is None:
            raise typer.BadParameter("say which plant, to see its blocks", param_hint="--plant")
        layers = catalog or []
        catalogs = [
            load_catalog(layers if one == _SHIPPED else [*layers, Path(one)]) for one in (old, new)
        ]
        plants = [_in_dialect(load_plant(plant, one), dialect, one) for one in catalogs]
        found = list(catalogue_differences(*catalogs))
    elif any(_is_catalogue(one) for one in (old, new)):
        raise typer.BadParameter(f"{old} and {new} are not the same kind of thing")
    elif plant is not None:
        raise typer.BadParameter("it is for catalogues", param_hint="--plant")
    else:
        catalogs = [load_catalog(catalog or ())] * 2
        read = [load_plant(Path(one), catalogs[0]) for one in (old, new)]
        found = list(differences(*read))
        plants = [_in_dialect(one, dialect, catalogs[0]) for one in read]
    sets = [generate(one, known) for one, known in zip(plants, catalogs, strict=True)]
    comparison = compared(found, *sets)
    blocks = block_changes(sets[0].blocks, sets[1].blocks)
    if as_json:
        result_json(_as_json(comparison, blocks, sets))
    else:
        _print(comparison, blocks, sets)
    lines = [line for item in comparison.affected for line in item.lines] + [*comparison.other]
    files = len({line.file for line in lines})
    differ = "1 entry differs" if len(found) == 1 else f"{len(found)} entries differ"
    say(f"{differ}, {counted(len(set(lines)), 'line')} in {counted(files, 'file')}")
    if found or lines:
        raise typer.Exit(FINDINGS)


def _is_catalogue(name: str) -> bool:
    return name == _SHIPPED or Path(name).is_dir()


def _in_dialect(plant: "Plant", dialect: str | None, catalog: "Catalog") -> "Plant":
    from fbgen.plant import in_dialect

    return plant if dialect is None else in_dialect(plant, dialect, catalog)


def _print(comparison: "Comparison", blocks: "BlockChanges", sets: "list[GeneratedSet]") -> None:
    last: tuple[ChangedLine, ...] = ()
    for item in comparison.affected:
        result(_told(item.difference))
        if item.lines and item.lines == last:
            result("   the same lines")
        elif item.lines:
            _print_lines(item.lines)
        else:
            result("   changes no line of the generated text by itself")
        last = item.lines
    if comparison.other:
        result("what follows from several of them, or from the order:")
        _print_lines(comparison.other)
    for old, new in blocks.renamed:
        result(f"renamed block: {old} is now {new}")
    for name in blocks.removed:
        result(f"removed block: {name}")
    for name in _added(sets, blocks):
        result(f"new block: {name}")


def _told(difference: "Difference") -> str:
    place = difference.place
    where = f"{place.source.name}:{place.line}: " if place is not None else ""
    if difference.kind == "changed":
        return f"{where}{difference.path}: {difference.before} -> {difference.after}"
    return f"{where}{difference.path}: {difference.kind}: {difference.before or difference.after}"


def _print_lines(lines: "Iterable[ChangedLine]") -> None:
    file = ""
    for line in lines:
        if line.file != file:
            file = line.file
            result(f"   {file}")
        result(f"      {line.sign}{line.number:<5} {line.text.strip()}")


def _added(sets: "list[GeneratedSet]", blocks: "BlockChanges") -> list[str]:
    known = {block.name for block in sets[0].blocks} | {new for _, new in blocks.renamed}
    return [block.name for block in sets[1].blocks if block.name not in known]


def _as_json(
    comparison: "Comparison", blocks: "BlockChanges", sets: "list[GeneratedSet]"
) -> dict[str, object]:
    return {
        "entries": [
            item.difference.as_json() | {"lines": [line.as_json() for line in item.lines]}
            for item in comparison.affected
        ],
        "other_lines": [line.as_json() for line in comparison.other],
        "renamed_blocks": dict(blocks.renamed),
        "removed_blocks": list(blocks.removed),
        "new_blocks": _added(sets, blocks),
    }
