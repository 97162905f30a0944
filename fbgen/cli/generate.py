"""`fbgen generate`: a plant file to PLC text."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from fbgen.cli.examples import examples
from fbgen.cli.layers import CatalogOption
from fbgen.cli.output import report, result, say

if TYPE_CHECKING:
    from fbgen.plant import PlantDialect


def register(program: typer.Typer) -> None:
    """Add the command to the program."""
    program.command(
        epilog=examples(
            "fbgen generate plant.yaml -o out",
            "fbgen generate plant.yaml -o out --dialect iec",
            "fbgen generate plant.yaml -o out --catalog our_catalog --templates our_templates",
        )
    )(generate)


def generate(
    plant: Annotated[Path, typer.Argument(metavar="PLANT", help="The plant file, see fbgen init.")],
    folder: Annotated[
        Path, typer.Option("-o", "--output", metavar="DIR", help="Where the PLC text goes.")
    ],
    dialect: Annotated[
        str | None,
        typer.Option("--dialect", metavar="D", help="tia or iec; else that of the plant file."),
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
    """
    from fbgen.catalog import load_catalog
    from fbgen.emit.generator import generate as generate_text
    from fbgen.emit.writing import write_set
    from fbgen.plant import load_plant

    wanted = _generated(dialect)
    known = load_catalog(catalog or ())
    generated = generate_text(load_plant(plant, known), known, wanted, templates or ())
    report(generated.warnings)
    written = write_set(generated, folder, force=force)
    for name in written.written:
        result(str(folder / name))
    say(
        f"{len(written.written)} written, {len(written.unchanged)} unchanged, "
        f"{len(written.removed)} removed in {folder} (dialect {generated.dialect})"
    )


def _generated(name: str | None) -> "PlantDialect | None":
    """The dialect, if blocks are generated in it; wrong usage if not."""
    from fbgen.plant import PLANT_DIALECTS

    if name is None:
        return None
    for dialect in PLANT_DIALECTS:
        if dialect == name:
            return dialect
    raise typer.BadParameter(
        f"blocks are generated in {' or '.join(PLANT_DIALECTS)}, not in '{name}'; "
        "fbgen convert brings PLC text into other dialects"
    )
