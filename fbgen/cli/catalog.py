"""`fbgen catalog list`, `fbgen catalog show`, `fbgen catalog eds`: what the catalogue holds."""

from enum import Enum
from typing import TYPE_CHECKING, Annotated

import typer

from fbgen.cli.examples import examples
from fbgen.cli.layers import CatalogOption, JsonOption
from fbgen.cli.output import result, result_json

if TYPE_CHECKING:
    from fbgen.catalog import Catalog


class Kind(Enum):
    """The folders of a catalogue, and the words of all devices."""

    DRIVES = "drives"
    GATEWAYS = "gateways"
    PROTOCOLS = "protocols"
    SEQUENCES = "sequences"
    MANUALS = "manuals"
    WORDS = "words"


commands = typer.Typer(help="Show what the catalogue holds.", no_args_is_help=True)


def register(program: typer.Typer) -> None:
    """Add the commands to the program."""
    program.add_typer(
        commands,
        name="catalog",
        epilog=examples("fbgen catalog list", "fbgen catalog show vf-s11.command"),
    )


@commands.command(
    "list",
    epilog=examples(
        "fbgen catalog list",
        "fbgen catalog list sequences",
        "fbgen catalog list words --json",
    ),
)
def list_entries(
    kind: Annotated[
        Kind | None,
        typer.Argument(metavar="KIND", help="One kind: drives, manuals, words, ..."),
    ] = None,
    catalog: CatalogOption = None,
    as_json: JsonOption = False,
) -> None:
    """List the entries: kind, id and title."""
    from fbgen.catalog import load_catalog
    from fbgen.cli.table import table

    rows = [row for row in _rows(load_catalog(catalog or ())) if kind in (None, Kind(row[0]))]
    if as_json:
        result_json([{"kind": row[0], "id": row[1], "title": row[2]} for row in rows])
    else:
        result(table(["kind", "id", "title"], rows))


@commands.command(
    epilog=examples(
        "fbgen catalog show tospbdp001",
        "fbgen catalog show vf-s11.command      a word with its bits",
        "fbgen catalog show vf-s11.FA01         one ComNo",
        "fbgen catalog show stop --json",
    ),
)
def show(
    entry: Annotated[
        str, typer.Argument(metavar="ID", help="An entry, or device.word or drive.ComNo.")
    ],
    catalog: CatalogOption = None,
    as_json: JsonOption = False,
) -> None:
    """Show one entry with its sources."""
    from fbgen.catalog import load_catalog
    from fbgen.cli.entries.catalog_parts import as_json as plain
    from fbgen.cli.entries.catalog_parts import find_entry, find_part
    from fbgen.cli.entries.catalog_text import entry_text, part_text

    known = load_catalog(catalog or ())
    if "." in entry:
        part = find_part(known, entry)
        if as_json:
            result_json(plain(part))
        else:
            result(part_text(entry, part))
        return
    found = find_entry(known, entry)
    if as_json:
        result_json(plain(found))
    else:
        result(entry_text(found))


@commands.command(
    epilog=examples(
        "fbgen catalog eds dev003z > dev003z.eds",
        "fbgen catalog eds dev003z --series vf-mb1",
    ),
)
def eds(
    entry: Annotated[str, typer.Argument(metavar="ID", help="A DeviceNet adapter: dev003z.")],
    series: Annotated[
        str | None,
        typer.Option("--series", metavar="S", help="The inverter that it is inside of."),
    ] = None,
    catalog: CatalogOption = None,
) -> None:
    """Write an EDS file for a simulated DeviceNet adapter, for configuration tools."""
    from fbgen.artefacts.eds import eds_text
    from fbgen.catalog import load_catalog
    from fbgen.diagnostics import error
    from fbgen.nearest import nearest

    known = load_catalog(catalog or ())
    gateway = known.devicenet_gateway(entry)
    codes = gateway.devicenet.product_codes
    wanted = series or gateway.series[-1]
    if wanted not in codes:
        message = f"a {gateway.id} does not fit into an inverter of the series '{wanted}'"
        raise error("FB7106", message, None, nearest(wanted, codes))
    result(eds_text(gateway, known.drive(wanted)).rstrip("\n"))


def _rows(known: "Catalog") -> list[list[str]]:
    rows = [
        [kind.value, entry.id, entry.title]
        for kind, entries in (
            (Kind.DRIVES, known.drives),
            (Kind.GATEWAYS, known.gateways),
            (Kind.PROTOCOLS, known.protocols),
            (Kind.SEQUENCES, known.sequences),
            (Kind.MANUALS, known.manuals),
        )
        for entry in entries.values()
    ]
    words = dict(known.word_names())
    return rows + [[Kind.WORDS.value, path, word.title] for path, word in words.items()]
