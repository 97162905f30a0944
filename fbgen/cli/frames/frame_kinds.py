"""The kinds of frames that `fbgen decode` and `fbgen encode` know, by the word that names them."""

from typing import Annotated

import typer

PROTOCOLS = ("toshiba", "modbus")
DIRECTIONS = ("request", "reply")
EITHER = "frame"
"""`toshiba.frame` is `toshiba`: a request or a reply."""

SeriesOption = Annotated[
    str | None,
    typer.Option("--series", metavar="S", help="Of a frame: the series, to name its ComNos."),
]

RequestOption = Annotated[
    str | None,
    typer.Option(
        "--request", metavar="FRAME", help="Of a MODBUS reply: its request, which has the ComNos."
    ),
]


def frame_kind(word: str) -> tuple[str, str | None] | None:
    """Protocol and direction of `toshiba.request`, `modbus`; None for any other word.

    Raises DiagnosticError FB9044 for another direction.
    """
    from fbgen.diagnostics import error
    from fbgen.nearest import nearest

    protocol, dot, direction = word.lower().partition(".")
    if protocol not in PROTOCOLS:
        return None
    if direction == EITHER:
        return protocol, None
    if dot and direction not in DIRECTIONS:
        kinds = [f"{protocol}.{way}" for way in DIRECTIONS]
        raise error("FB9044", f"there are no frames '{word}'", help=nearest(word, kinds))
    return protocol, direction or None
