"""`fbgen encode`: the word in which the named bits are set, and the frame of some fields."""

from collections.abc import Sequence
from typing import Annotated

import typer

from fbgen.cli.examples import examples
from fbgen.cli.frames.frame_kinds import SeriesOption, frame_kind
from fbgen.cli.layers import CatalogOption, JsonOption
from fbgen.cli.output import result, result_json


def register(program: typer.Typer) -> None:
    """Add the command to the program."""
    program.command(
        epilog=examples(
            "fbgen encode vf-s11.command run network_command network_frequency",
            "fbgen encode tospbdp001.status status_code=0x1F status_changed",
            "fbgen encode vf-s11.command run --json",
            "fbgen encode toshiba command=P inv_no=11 com_no=FA00 data=C400",
            "fbgen encode tospbdp001.output control=E000 trigger=1 inv_no=11 cmd=P comno=FA00 "
            "data=C400",
            "fbgen encode modbus function=06 com_no=frequency_setpoint value=50 --series vf-s11",
        )
    )(encode)


def encode(
    word: Annotated[
        str,
        typer.Argument(
            metavar="WORD",
            help="Device and word or ComNo: vf-s11.command, vf-s11.FA00. Or a kind of frame: "
            "toshiba.request, toshiba.reply, modbus.request, modbus.reply. Or the cyclic data of a "
            "gateway: tospbdp001.output, tospbdp001.input.",
        ),
    ],
    bits: Annotated[
        list[str],
        typer.Argument(
            metavar="BIT", help="Names of bits that are 1, or name=value; fields of a frame."
        ),
    ],
    series: SeriesOption = None,
    catalog: CatalogOption = None,
    as_json: JsonOption = False,
) -> None:
    """Make a word of named bits, all others are 0; or a frame of its fields."""
    from fbgen.catalog import load_catalog
    from fbgen.cli.entries.word_tables import decoded_json, decoded_text
    from fbgen.cli.frames.telegram_reading import cells_of, telegram_kind, written_telegram

    kind = frame_kind(word)
    if kind is not None:
        from fbgen.cli.frames.cell_texts import cell_texts
        from fbgen.cli.frames.frame_reading import reading_json, reading_text
        from fbgen.cli.frames.whole_frames import written_frame

        reading = written_frame(*kind, bits, cell_texts(series, catalog))
        if as_json:
            result_json(reading_json(reading))
        else:
            result(reading_text(reading))
        return
    known = load_catalog(catalog or ())
    if "." in word and (telegram := telegram_kind(known, word)) is not None:
        from fbgen.cli.frames.frame_reading import reading_json, reading_text

        cells = cells_of(telegram, series, known)
        reading = written_telegram(telegram, bits, cells)
        if as_json:
            result_json(reading_json(reading))
        else:
            result(reading_text(reading))
        return
    table = known.word(word)
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
