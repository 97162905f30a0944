"""`fbgen generate`: a plant file to PLC text."""

from pathlib import Path
from typing import Annotated

import typer

from fbgen.cli.dialects import DialectOption
from fbgen.cli.examples import examples
from fbgen.cli.layers import CatalogOption
from fbgen.cli.output import report, result, say


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
    dialect: DialectOption = None,
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
    The dialect is that of the plant file unless --dialect names another one.
    """
    from fbgen.catalog import load_catalog
    from fbgen.emit.generator import generate as generate_text
    from fbgen.emit.writing import write_set
    from fbgen.plant import load_plant

    known = load_catalog(catalog or ())
    generated = generate_text(load_plant(plant, known), known, dialect, templates or ())
    report(generated.warnings)
    written = write_set(generated, folder, force=force)
    for name in written.written:
        result(str(folder / name))
    say(
        f"{len(written.written)} written, {len(written.unchanged)} unchanged, "
        f"{len(written.removed)} removed in {folder} (dialect {generated.dialect})"
    )
