"""`fbgen encode`: the word in which the named bits are set."""

from collections.abc import Sequence
from typing import Annotated

import typer

from fbgen.cli.examples import examples
from fbgen.cli.layers import CatalogOption, JsonOption
from fbgen.cli.output import result, result_json


def register(program: typer.Typer) -> None:
    """Add the command to the program."""
    program.command(
        epilog=examples(
            "fbgen encode vf-s11.command run network_command network_frequency",
            "fbgen encode tospbdp001.status status_code=0x1F status_changed",
            "fbgen encode vf-s11.command run --json",
        )
    )(encode)


def encode(
    word: Annotated[
        str,
        typer.Argument(
            metavar="WORD", help="Device and word or ComNo: vf-s11.command, vf-s11.FA00."
        ),
    ],
    bits: Annotated[
        list[str],
        typer.Argument(metavar="BIT", help="Names of bits that are 1, or name=value."),
    ],
    catalog: CatalogOption = None,
    as_json: JsonOption = False,
) -> None:
    """Make a word of named bits; all others are 0."""
    from fbgen.catalog import load_catalog
    from fbgen.cli.word_tables import decoded_json, decoded_text

    table = load_catalog(catalog or ()).word(word)
    number = table.encode(_values(bits))
    if as_json:
        result_json(decoded_json(word, table, number))
    else:
        result(decoded_text(word, table, number))


def _values(bits: Sequence[str]) -> dict[str, int]:
    """Names with their values. Raises DiagnosticError FB9004 with all that cannot be read."""
    from fbgen.diagnostics import Diagnostic, DiagnosticError

    values: dict[str, int] = {}
    found: list[Diagnostic] = []
    for argument in bits:
        name, equals, text = argument.partition("=")
        try:
            value = int(text, 0) if equals else 1
        except ValueError:
            message = f"'{text}' is no number for '{name}'"
            found.append(
                Diagnostic("FB9004", message, help="write name=5, name=0x1F or name=0b101")
            )
            continue
        if name in values:
            found.append(Diagnostic("FB9004", f"'{name}' is given twice", help="give it once"))
        values[name] = value
    if found:
        raise DiagnosticError(found)
    return values
