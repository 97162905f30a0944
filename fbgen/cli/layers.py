"""The option `--catalog` of several commands: catalogues of the user's own over the shipped one."""

from pathlib import Path
from typing import Annotated

import typer

CatalogOption = Annotated[
    list[Path] | None,
    typer.Option(
        "--catalog",
        metavar="DIR",
        help="A catalogue of your own, laid over the shipped one; may be given several times.",
    ),
]
"""Folders with the structure of the shipped catalogue, the last one on top."""

JsonOption = Annotated[bool, typer.Option("--json", help="Print the result as JSON.")]
"""The result for another program."""
