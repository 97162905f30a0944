"""`fbgen decode`: what the bits of a word mean, and what a frame says."""

from typing import TYPE_CHECKING, Annotated

import typer

from fbgen.cli.examples import examples
from fbgen.cli.frames.frame_kinds import RequestOption, SeriesOption, frame_kind
from fbgen.cli.layers import CatalogOption, JsonOption
from fbgen.cli.output import result, result_json

if TYPE_CHECKING:
    from fbgen.catalog import Catalog
    from fbgen.cli.frames.frame_reading import Reading


def register(program: typer.Typer) -> None:
    """Add the command to the program."""
    program.command(
        epilog=examples(
            "fbgen decode tospbdp001.status 9F00",
            "fbgen decode vf-s11.command 2#1100_0100_0000_0000",
            "fbgen decode vf-s11.FA00 16#C400 --json",
            'fbgen decode tospbdp001.output "E0 00 01 0B 50 FA 00 C4 00"',
            'fbgen decode dev003z.71 "F4 04 08 07"',
            'fbgen decode toshiba.frame "2F 0B 50 FA 00 C4 00 48" --series vf-s11',
            'fbgen decode modbus "01 03 02 17 70 B6 50" --request "01 03 FD 00 00 01 B5 A6"',
        )
    )(decode)


def decode(
    word: Annotated[
        str,
        typer.Argument(
            metavar="WORD",
            help="Device and word or ComNo: tospbdp001.status, vf-s11.FA00. Or a kind of frame: "
            "toshiba.frame, toshiba.request, toshiba.reply, modbus.frame. Or the cyclic data of "
            "a gateway: tospbdp001.output, tospbdp001.input; or an assembly: dev003z.151.",
        ),
    ],
    value: Annotated[
        str,
        typer.Argument(
            metavar="VALUE",
            help="9F00, 16#9F00, 0x9F00, 9F00h, 2#1001_1111_0000_0000 or 10#40704. Of a frame or "
            'of cyclic data the bytes, "2F 0B 50 FA 00 C4 00 48"; an ASCII frame, "(PFA008400)".',
        ),
    ],
    series: SeriesOption = None,
    request: RequestOption = None,
    catalog: CatalogOption = None,
    as_json: JsonOption = False,
) -> None:
    """Show what the bits of a word mean, and where that is written; or what a frame says."""
    from fbgen.catalog import load_catalog, parse_word
    from fbgen.cli.entries.word_tables import decoded_json, decoded_text

    kind = frame_kind(word)
    if kind is not None:
        from fbgen.cli.frames.cell_texts import cell_texts
        from fbgen.cli.frames.whole_frames import frame_reading

        _show(frame_reading(*kind, value, cell_texts(series, catalog), request), as_json)
        return
    known = load_catalog(catalog or ())
    if "." in word and (reading := _cyclic_data(known, word, value, series)) is not None:
        _show(reading, as_json)
        return
    bits = known.word(word)
    number = parse_word(value)
    if as_json:
        result_json(decoded_json(word, bits, number))
    else:
        result(decoded_text(word, bits, number))


def _cyclic_data(known: "Catalog", word: str, value: str, series: str | None) -> "Reading | None":
    """The cyclic data of a gateway, or of a DeviceNet assembly; None for a word."""
    from fbgen.cli.frames.assembly_reading import assembly_kind, assembly_reading
    from fbgen.cli.frames.telegram_reading import cells_of, telegram_kind, telegram_reading
    from fbgen.cli.frames.whole_frames import bytes_of

    if (telegram := telegram_kind(known, word)) is not None:
        return telegram_reading(telegram, bytes_of(value), cells_of(telegram, series, known))
    if (assembly := assembly_kind(known, word)) is not None:
        return assembly_reading(assembly, bytes_of(value))
    return None


def _show(reading: "Reading", as_json: bool) -> None:
    from fbgen.cli.frames.frame_reading import reading_json, reading_text

    if as_json:
        result_json(reading_json(reading))
    else:
        result(reading_text(reading))
