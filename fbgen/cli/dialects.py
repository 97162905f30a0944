"""The options `--dialect` of several commands: for PLC text, and for what a plant becomes."""

from typing import Annotated

import typer


def _known(name: str | None) -> str | None:
    from fbgen.lang.dialects import DIALECTS

    if name is not None and name not in DIALECTS:
        raise typer.BadParameter(f"'{name}' is none of {', '.join(DIALECTS)}")
    return name


def _known_target(name: str | None) -> str | None:
    from fbgen.plant import LANGUAGES

    if name is not None and name not in LANGUAGES:
        raise typer.BadParameter(f"'{name}' is none of {', '.join(LANGUAGES)}")
    return name


PlantDialectOption = Annotated[
    str | None,
    typer.Option(
        "--dialect",
        metavar="D",
        callback=_known_target,
        help="tia, step7, iec, twincat or plcopen, whatever the plant file says.",
    ),
]
"""A dialect for a plant; None if not given. An unknown one is wrong usage."""

DialectOption = Annotated[
    str | None,
    typer.Option("--dialect", metavar="D", callback=_known, help="tia, step7, iec or twincat."),
]
"""A dialect of the PLC language; None if not given. An unknown one is wrong usage."""
