"""`fbgen init`: a commented plant file to start from."""

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
    """Write a plant file in which every key is explained."""
    from fbgen.cli.files import write_file
    from fbgen.plant import write_commented_plant

    path = folder / PLANT_FILE
    write_file(path, write_commented_plant(), overwrite=force)
    result(str(path))
    say(f"edit it, then: fbgen generate {path} -o out")
