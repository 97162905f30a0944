"""`fbgen init`: a commented plant file to start from, and a sequence of one's own."""

from pathlib import Path
from typing import Annotated

import typer

from fbgen.cli.examples import examples
from fbgen.cli.output import result, say

PLANT_FILE = "plant.yaml"


def register(program: typer.Typer) -> None:
    """Add the command to the program."""
    program.command(
        epilog=examples("fbgen init", "fbgen init lines/hall_2", "fbgen init lines/hall_2 --force")
    )(init)


def init(
    folder: Annotated[
        Path, typer.Argument(metavar="DIR", help="The folder; made if it is not there.")
    ] = Path(),
    force: Annotated[
        bool, typer.Option("--force", help="Overwrite a plant file that is already there.")
    ] = False,
) -> None:
    """Write a plant file in which every key is explained, and beside it a sequence.

    Sequences in the folder `sequences` beside a plant file are those of that plant.
    """
    from fbgen.catalog import OWN_SEQUENCES
    from fbgen.cli.files import write_file
    from fbgen.plant import OWN_SEQUENCE_FILE, write_commented_plant, write_own_sequence

    path, sequence = folder / PLANT_FILE, folder / OWN_SEQUENCES / OWN_SEQUENCE_FILE
    write_file(path, write_commented_plant(), overwrite=force)
    write_file(sequence, write_own_sequence(), overwrite=force)
    result(str(path))
    result(str(sequence))
    say(f"edit it, then: fbgen generate {path} -o out")
