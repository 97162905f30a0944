"""`fbgen decode`: what the bits of a word mean."""

from typing import Annotated

import typer

from fbgen.cli.examples import examples
from fbgen.cli.layers import CatalogOption, JsonOption
from fbgen.cli.output import result, result_json


def register(program: typer.Typer) -> None:
    """Add the command to the program."""
    program.command(
        epilog=examples(
            "fbgen decode tospbdp001.status 9F00",
            "fbgen decode vf-s11.command 2#1100_0100_0000_0000",
            "fbgen decode vf-s11.FA00 16#C400 --json",
        )
    )(decode)


def decode(
    word: Annotated[
        str,
        typer.Argument(
            metavar="WORD", help="Device and word or ComNo: tospbdp001.status, vf-s11.FA00."
        ),
    ],
    value: Annotated[
        str,
        typer.Argument(
            metavar="VALUE", help="9F00, 16#9F00, 0x9F00, 9F00h, 2#1001_1111_0000_0000 or 10#40704."
        ),
    ],
    catalog: CatalogOption = None,
    as_json: JsonOption = False,
) -> None:
    """Show what the bits of a word mean, and where that is written."""
    from fbgen.catalog import load_catalog, parse_word
    from fbgen.cli.word_tables import decoded_json, decoded_text

    bits = load_catalog(catalog or ()).word(word)
    number = parse_word(value)
    if as_json:
        result_json(decoded_json(word, bits, number))
    else:
        result(decoded_text(word, bits, number))
