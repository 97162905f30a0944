"""`fbgen explain`: the page of a diagnostic code."""

from typing import Annotated

import typer

from fbgen.cli.examples import examples
from fbgen.cli.output import result


def register(program: typer.Typer) -> None:
    """Add the command to the program."""
    program.command(epilog=examples("fbgen explain FB2006", "fbgen explain fb3001 | less"))(explain)


def explain(
    code: Annotated[
        str, typer.Argument(metavar="CODE", help="The code in the brackets of a message.")
    ],
) -> None:
    """Explain a message by its code, with an example."""
    from fbgen.diagnostics import error
    from fbgen.nearest import nearest
    from fbgen.pages import pages

    wanted = code.strip().strip("[]").upper()
    page = pages().get(wanted)
    if page is None:
        raise error(
            "FB9003", f"there is no message with the code '{code}'", None, nearest(wanted, pages())
        )
    result(page.read_text(encoding="utf-8").rstrip("\n"))
