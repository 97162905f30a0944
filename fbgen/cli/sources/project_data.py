"""What a project has besides its sources, given to several commands: constants, tags, numbers.

--constant MAX_PUMPS=8 --tags "PLC tags.xml" --db-number Exchange=100
"""

from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Annotated, TypeVar

import typer

if TYPE_CHECKING:
    from fbgen.diagnostics import DiagnosticError

_Value = TypeVar("_Value")

ConstantsOption = Annotated[
    list[str] | None,
    typer.Option(
        "--constant",
        metavar="NAME=VALUE",
        help="A user constant of the project, which no source contains; the value as in PLC text.",
    ),
]

TagsOption = Annotated[
    list[str] | None,
    typer.Option(
        "--tags",
        metavar="FILE",
        help="A tag table: XML of TIA Portal, or .sdf of STEP 7. May be given several times.",
    ),
]

NumbersOption = Annotated[
    list[str] | None,
    typer.Option(
        "--db-number",
        metavar="NAME=N",
        help="The number of a data block, for absolute addresses; DB100 tells it by its name.",
    ),
]


def read_constants(given: Iterable[str] | None) -> dict[str, str]:
    """The constants by their names. Raises DiagnosticError FB9014 with all that are none."""
    return _pairs("--constant", given or (), str)


def read_numbers(given: Iterable[str] | None) -> dict[str, int]:
    """The numbers by the names of data blocks. Raises DiagnosticError FB9014, as above."""
    return _pairs("--db-number", given or (), _number)


def _number(text: str) -> int | None:
    digits = text.upper().removeprefix("DB")
    return int(digits) if digits.isdecimal() and 0 < int(digits) < 1 << 16 else None


def _pairs(
    option: str, given: Iterable[str], read: Callable[[str], _Value | None]
) -> dict[str, _Value]:
    from fbgen.diagnostics import DiagnosticError

    found: dict[str, _Value] = {}
    wrong: list[DiagnosticError] = []
    for text in given:
        name, _, written = text.partition("=")
        name, written = name.strip().strip('"'), written.strip()
        value = read(written) if name and written else None
        if value is None:
            wrong.append(_unread(option, text))
        elif name.casefold() in {one.casefold() for one in found}:
            wrong.append(_twice(option, name))
        else:
            found[name] = value
    if wrong:
        raise DiagnosticError(one for failure in wrong for one in failure.diagnostics)
    return found


def _unread(option: str, text: str) -> "DiagnosticError":
    from fbgen.diagnostics import error

    if option == "--constant":
        message, example = f"'{text}' gives no constant a value", "MAX_PUMPS=8"
    else:
        message, example = f"'{text}' gives no data block a number (1 to 65535)", "Exchange=100"
    return error("FB9014", message, help=f"write it like this: {option} {example}")


def _twice(option: str, name: str) -> "DiagnosticError":
    from fbgen.diagnostics import error

    return error("FB9014", f"'{name}' is given twice", help=f"keep one {option} for each name")
