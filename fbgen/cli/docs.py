"""`fbgen docs`: the reference of the catalogue or of a plant, as pages."""

from pathlib import Path
from typing import Annotated

import typer

from fbgen.cli.examples import examples
from fbgen.cli.layers import CatalogOption
from fbgen.cli.output import result, say


def register(program: typer.Typer) -> None:
    """Add the command to the program."""
    program.command(
        epilog=examples(
            "fbgen docs -o site",
            "fbgen docs plant.yaml -o site",
            "fbgen docs -o site --catalog our_catalog",
        )
    )(docs)


def docs(
    folder: Annotated[
        Path, typer.Option("-o", "--output", metavar="DIR", help="Where the pages go.")
    ],
    plant: Annotated[
        Path | None,
        typer.Argument(metavar="[PLANT]", help="A plant file; without it, the whole catalogue."),
    ] = None,
    catalog: CatalogOption = None,
    force: Annotated[
        bool, typer.Option("--force", help="Overwrite pages that a person has changed.")
    ] = False,
) -> None:
    """Write how every bit, ComNo, telegram and trip is used, as a site that opens from disk.

    Every word has a decoder: type a value and see its bits, click bits and see the value and the
    telegram. The site needs no server and no network; open index.html. A page that was changed by
    hand is never overwritten without --force, and never removed.
    """
    from fbgen import __version__
    from fbgen.catalog import load_catalog, with_own_sequences
    from fbgen.docs.folder import write_site
    from fbgen.docs.html import html_site
    from fbgen.docs.site import build_site
    from fbgen.docs.subject import of_plant, whole_catalogue
    from fbgen.plant import load_plant

    known = load_catalog(catalog or ())
    if plant is None:
        subject = whole_catalogue(known)
    else:
        known = with_own_sequences(known, plant.parent)
        subject = of_plant(load_plant(plant, known), known)
    pages = html_site(build_site(subject, __version__))
    found = write_site(pages, folder, "html", force=force)
    for name in found.kept:
        say(f"kept: {folder / name} is not a page any more, but was changed by hand")
    say(
        f"{len(found.written)} written, {len(found.unchanged)} unchanged, "
        f"{len(found.removed)} removed in {folder}"
    )
    result(str(folder / "index.html"))
