"""The option `--dialect` of several commands."""

from typing import Annotated

import typer


def _known(name: str | None) -> str | None:
    from fbgen.lang.dialects import DIALECTS

    if name is not None and name not in DIALECTS:
        raise typer.BadParameter(f"'{name}' is none of {', '.join(DIALECTS)}")
    return name


DialectOption = Annotated[
    str | None,
    typer.Option("--dialect", metavar="D", callback=_known, help="tia, step7, iec or twincat."),
]
"""A dialect of the PLC language; None if not given. An unknown one is wrong usage."""
