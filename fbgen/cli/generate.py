"""`fbgen generate`: a plant file to PLC text."""

import re
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from fbgen.cli.dialects import PlantDialectOption
from fbgen.cli.examples import examples
from fbgen.cli.layers import CatalogOption
from fbgen.cli.output import report, result, say

if TYPE_CHECKING:
    from fbgen.catalog import Catalog
    from fbgen.plant import Plant

_NUMBERS = "--block-numbers"


def register(program: typer.Typer) -> None:
    """Add the command to the program."""
    program.command(
        epilog=examples(
            "fbgen generate plant.yaml -o out",
            "fbgen generate plant.yaml -o out --dialect step7 --block-numbers 500-599",
            "fbgen generate plant.yaml -o out --catalog our_catalog --templates our_templates",
        )
    )(generate)


def generate(
    plant: Annotated[Path, typer.Argument(metavar="PLANT", help="The plant file, see fbgen init.")],
    folder: Annotated[
        Path, typer.Option("-o", "--output", metavar="DIR", help="Where the PLC text goes.")
    ],
    dialect: PlantDialectOption = None,
    block_numbers: Annotated[
        str | None,
        typer.Option(
            "--block-numbers",
            metavar="FIRST-LAST",
            help="Numbers of the blocks of dialect step7, such as 200-399.",
        ),
    ] = None,
    catalog: CatalogOption = None,
    templates: Annotated[
        list[Path] | None,
        typer.Option(
            "--templates",
            metavar="DIR",
            help="Templates of your own, before the shipped ones; may be given several times.",
        ),
    ] = None,
    force: Annotated[
        bool, typer.Option("--force", help="Overwrite files that a person has changed.")
    ] = False,
) -> None:
    """Generate the PLC text of a plant.

    Standard output lists the files that were written.
    A file that was changed by hand since it was generated is never overwritten without --force.
    The dialect is that of the plant file unless --dialect names another one; if the PLC of the
    plant file does not read that, the usual PLC of the dialect takes its place.
    """
    from fbgen.catalog import load_catalog
    from fbgen.emit.generator import generate as generate_text
    from fbgen.emit.writing import write_set
    from fbgen.plant import load_plant

    known = load_catalog(catalog or ())
    wanted = _in_dialect(load_plant(plant, known), dialect, known)
    if block_numbers is not None:
        wanted = _with_numbers(wanted, block_numbers)
    generated = generate_text(wanted, known, templates or ())
    report(generated.warnings)
    written = write_set(generated, folder, force=force)
    for name in written.written:
        result(str(folder / name))
    say(
        f"{len(written.written)} written, {len(written.unchanged)} unchanged, "
        f"{len(written.removed)} removed in {folder} (dialect {generated.dialect})"
    )


def _in_dialect(plant: "Plant", dialect: str | None, catalog: "Catalog") -> "Plant":
    from fbgen.plant import in_dialect

    return plant if dialect is None else in_dialect(plant, dialect, catalog)


def _with_numbers(plant: "Plant", given: str) -> "Plant":
    """The plant with other numbers for its blocks. Raises a usage error for what is no range."""
    from fbgen.plant import HIGHEST_BLOCK, BlockNumbers

    if plant.dialect != "step7":
        raise typer.BadParameter(f"dialect {plant.dialect} numbers no blocks", param_hint=_NUMBERS)
    found = re.fullmatch(r"(\d{1,4})-(\d{1,4})", given)
    first, last = (int(found[1]), int(found[2])) if found else (0, 0)
    if not 1 <= first <= last <= HIGHEST_BLOCK:
        message = f"'{given}' is no range of numbers between 1 and {HIGHEST_BLOCK}, such as 200-399"
        raise typer.BadParameter(message, param_hint=_NUMBERS)
    return plant.model_copy(update={"block_numbers": BlockNumbers(first=first, last=last)})
