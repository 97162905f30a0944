"""`fbgen docs`: the reference of the catalogue or of a plant, as pages."""

import sys
from collections.abc import Sequence
from dataclasses import replace
from enum import Enum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from fbgen.cli.examples import examples
from fbgen.cli.layers import CatalogOption
from fbgen.cli.output import result, say
from fbgen.cli.progress import Progress

if TYPE_CHECKING:
    from fbgen.docs.site import Site
    from fbgen.docs.subject import Subject


class Language(Enum):
    """What names of things are written in, as far as they are translated."""

    EN = "en"
    DE = "de"


class Format(Enum):
    """What pages are written as."""

    HTML = "html"
    MARKDOWN = "markdown"
    PDF = "pdf"


def register(program: typer.Typer) -> None:
    """Add the command to the program."""
    program.command(
        epilog=examples(
            "fbgen docs -o site",
            "fbgen docs plant.yaml -o site",
            "fbgen docs plant.yaml -o site --sources our_blocks",
            "fbgen docs plant.yaml -o site --language de",
            "fbgen docs plant.yaml -o wiki --format markdown",
            "fbgen docs plant.yaml -o handbook --format pdf",
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
    sources: Annotated[
        list[Path] | None,
        typer.Option(
            "--sources",
            metavar="PATH",
            help="PLC text of your own, files or folders: what it uses is shown, too.",
        ),
    ] = None,
    kind: Annotated[
        Format, typer.Option("--format", help="html, markdown for a wiki, or pdf, a handbook.")
    ] = Format.HTML,
    language: Annotated[
        Language | None,
        typer.Option(
            "--language",
            help="Of titles, trips and comments of blocks; that of the plant file, else en. The "
            "sentences of the pages themselves are English.",
        ),
    ] = None,
    catalog: CatalogOption = None,
    templates: Annotated[
        list[Path] | None,
        typer.Option("--templates", metavar="DIR", help="Templates of your own, see generate."),
    ] = None,
    force: Annotated[
        bool, typer.Option("--force", help="Overwrite pages that a person has changed.")
    ] = False,
) -> None:
    """Write how every bit, ComNo, telegram, trip and block is used, as a site opened from disk.

    Every word has a decoder: type a value and see its bits, click bits and see the value and the
    telegram. The blocks are those of the plant, without one those of the example plants; which of
    them uses which bit is taken from their text. The site needs no server and no network; open
    index.html. --format markdown has the same for a wiki, --format pdf as a handbook with contents
    and page numbers; both without what works on the screen only. A page that was changed by hand is
    never overwritten without --force, and never removed.
    """
    from fbgen import __version__
    from fbgen.docs.folder import write_site
    from fbgen.docs.site import build_site

    if sources and plant is None:
        raise typer.BadParameter("it needs a PLANT, whose blocks they call", param_hint="--sources")
    if kind is Format.PDF:
        _need_reportlab()
    progress = Progress(4, shown=sys.stderr.isatty())
    progress.step("catalogue and blocks")
    subject = _subject(plant, language, catalog or (), templates or (), sources or ())
    progress.step("pages")
    site = build_site(subject, __version__)
    progress.step("files")
    files = _files(site, kind)
    progress.step(str(folder))
    found = write_site(files, folder, kind.value, force=force)
    progress.end()
    for name in found.kept:
        say(f"kept: {folder / name} is not a page any more, but was changed by hand")
    say(
        f"{len(found.written)} written, {len(found.unchanged)} unchanged, "
        f"{len(found.removed)} removed in {folder}"
    )
    result(str(folder / _FIRST[kind]))


_FIRST = {
    Format.HTML: "index.html",
    Format.MARKDOWN: "index.md",
    Format.PDF: "handbook.pdf",
}
"""The file to begin with."""


def _need_reportlab() -> None:
    """Raises DiagnosticError FB9060 if the library is not there."""
    from importlib.util import find_spec

    from fbgen.diagnostics import error

    if find_spec("reportlab") is None:
        raise error(
            "FB9060",
            "a handbook needs the package reportlab, which is not there",
            help="pip install 'fbgen[pdf]'",
        )


def _files(site: "Site", kind: Format) -> dict[str, bytes]:
    """The pages in a format."""
    if kind is Format.HTML:
        from fbgen.docs.html import html_site

        return html_site(site)
    if kind is Format.MARKDOWN:
        from fbgen.docs.markdown import markdown_site

        return markdown_site(site)
    from fbgen.docs.pdf import handbook

    return {_FIRST[kind]: handbook(site)}


def _subject(
    plant: Path | None,
    language: Language | None,
    catalog: Sequence[Path],
    templates: Sequence[Path],
    sources: Sequence[Path],
) -> "Subject":
    """What the site is about, with the blocks that were generated for it."""
    from fbgen.blocks.texts import texts_in
    from fbgen.catalog import load_catalog, with_own_sequences
    from fbgen.cli.handshakes import handshakes
    from fbgen.cli.sources.plc_files import expand
    from fbgen.docs.examples import example_programs
    from fbgen.docs.limits import NotModelled
    from fbgen.docs.program import read_program
    from fbgen.docs.subject import of_plant, whole_catalogue
    from fbgen.emit.generator import generate
    from fbgen.plant import changed, load_plant
    from harness.not_modelled import NOT_MODELLED

    known = load_catalog(catalog)
    spoken = Language.EN if language is None else language
    if plant is None:
        entries = texts_in(spoken.value, templates).in_catalog(known)
        programs = tuple(example_programs(known, templates, spoken.value))
        shown = iter(programs)
        subject = whole_catalogue(entries, programs)
    else:
        known = with_own_sequences(known, plant.parent)
        wanted = load_plant(plant, known)
        if language is not None:
            wanted = changed(wanted, known, language=language.value)
        program = read_program(wanted, generate(wanted, known, templates), expand(sources))
        entries = texts_in(wanted.language, templates).in_catalog(known)
        subject = of_plant(wanted, entries, program)
        shown = example_programs(known, templates)
    return replace(
        subject,
        handshakes=tuple(handshakes(shown, list(subject.gateways))),
        not_modelled=tuple(NotModelled(*one) for one in NOT_MODELLED),
    )
