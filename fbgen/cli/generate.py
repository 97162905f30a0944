"""`fbgen generate`: a plant file to PLC text."""

import re
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from fbgen.cli import FINDINGS
from fbgen.cli.dialects import PlantDialectOption
from fbgen.cli.examples import examples
from fbgen.cli.layers import CatalogOption
from fbgen.cli.output import report, result, say

if TYPE_CHECKING:
    from fbgen.catalog import Catalog
    from fbgen.emit.folder import FolderChanges
    from fbgen.plant import Plant

_NUMBERS = "--block-numbers"


def register(program: typer.Typer) -> None:
    """Add the command to the program."""
    program.command(
        epilog=examples(
            "fbgen generate plant.yaml -o out",
            "fbgen generate plant.yaml -o out --diff",
            "fbgen generate plant.yaml -o out --check",
            "fbgen generate plant.yaml -o out --prefix HALL2_ --files one",
            "fbgen generate plant.yaml -o out --language de",
            "fbgen generate plant.yaml -o out --dialect step7 --block-numbers 500-599",
            "fbgen generate plant.yaml -o out --catalog our_catalog --templates our_templates",
        )
    )(generate)


def _known_layout(name: str | None) -> str | None:
    if name not in (None, "one", "per_block"):
        raise typer.BadParameter(f"'{name}' is none of one, per_block")
    return name


def _known_language(name: str | None) -> str | None:
    if name not in (None, "en", "de"):
        raise typer.BadParameter(f"'{name}' is none of en, de")
    return name


def _known_prefix(prefix: str | None) -> str | None:
    from fbgen.plant.prefix import prefix_problems

    for found in prefix_problems(prefix, None) if prefix is not None else ():
        raise typer.BadParameter(f"{found.message}: {found.help}")
    return prefix


def generate(
    plant: Annotated[Path, typer.Argument(metavar="PLANT", help="The plant file, see fbgen init.")],
    folder: Annotated[
        Path, typer.Option("-o", "--output", metavar="DIR", help="Where the PLC text goes.")
    ],
    dialect: PlantDialectOption = None,
    prefix: Annotated[
        str | None,
        typer.Option(
            "--prefix",
            metavar="P_",
            callback=_known_prefix,
            help="How names of blocks begin instead of TOS_.",
        ),
    ] = None,
    language: Annotated[
        str | None,
        typer.Option(
            "--language",
            metavar="en|de",
            callback=_known_language,
            help="Language of comments, titles and trip texts.",
        ),
    ] = None,
    files: Annotated[
        str | None,
        typer.Option(
            "--files",
            metavar="one|per_block",
            callback=_known_layout,
            help="All blocks in one file, or each in its own, where the dialect leaves it open.",
        ),
    ] = None,
    block_numbers: Annotated[
        str | None,
        typer.Option(
            "--block-numbers",
            metavar="FIRST-LAST",
            help="Numbers of the blocks of dialect step7, such as 200-399.",
        ),
    ] = None,
    catalog: CatalogOption = None,
    templates: Annotated[
        list[Path] | None,
        typer.Option(
            "--templates",
            metavar="DIR",
            help="Templates of your own, before the shipped ones; may be given several times.",
        ),
    ] = None,
    check: Annotated[
        bool,
        typer.Option("--check", help="Write nothing; exit status 1 if anything would change."),
    ] = False,
    diff: Annotated[
        bool, typer.Option("--diff", help="Write nothing; print what would change.")
    ] = False,
    force: Annotated[
        bool, typer.Option("--force", help="Overwrite files that a person has changed.")
    ] = False,
) -> None:
    """Generate the PLC text of a plant.

    Standard output lists the files that were written, with --check those that would be written or
    removed. A file that was changed by hand since it was generated is never overwritten without
    --force, and never removed.
    The dialect is that of the plant file unless --dialect names another one; if the PLC of the
    plant file does not read that, the usual PLC of the dialect takes its place. --prefix,
    --files and --language take the place of what the plant file says.
    """
    from fbgen.artefacts import with_artefacts
    from fbgen.catalog import load_catalog, with_own_sequences
    from fbgen.emit.folder import compare
    from fbgen.emit.generator import generate as generate_text
    from fbgen.emit.owned import misfits
    from fbgen.emit.writing import write_set
    from fbgen.lang.collector import collector_at_rest
    from fbgen.plant import load_plant

    with collector_at_rest():
        known = with_own_sequences(load_catalog(catalog or ()), plant.parent)
        wanted = _in_dialect(load_plant(plant, known), dialect, known)
    wanted = _changed(wanted, known, prefix=prefix, files=files, language=language)
    if block_numbers is not None:
        wanted = _with_numbers(wanted, block_numbers)
    own = templates or ()
    generated = with_artefacts(generate_text(wanted, known, own), wanted, known, own)
    report([*generated.warnings, *misfits(generated, folder)])
    dry = check or diff
    found = compare(generated, folder) if dry else write_set(generated, folder, force=force)
    if dry and not force:
        report(found.refusals(folder))
    if diff:
        _print_differences(found, folder)
    else:
        for item in found.changes if check else [one for one in found.changes if one.after]:
            result(str(folder / item.name))
    _say_what_became_of_blocks(found, folder)
    would = "would be " if dry else ""
    say(
        f"{len(found.written)} {would}written, {len(found.unchanged)} unchanged, "
        f"{len(found.removed)} {would}removed in {folder} (dialect {generated.dialect})"
    )
    if check and found.changes:
        raise typer.Exit(FINDINGS)


def _say_what_became_of_blocks(found: "FolderChanges", folder: Path) -> None:
    for old, new in found.blocks.renamed:
        say(f"renamed block: {old} is now {new}")
    for name in found.blocks.removed:
        say(f"removed block: {name} is not generated any more")
    for name in found.kept:
        say(f"kept: {folder / name} is not generated any more, but was changed by hand")


def _print_differences(found: "FolderChanges", folder: Path) -> None:
    """A unified diff of all files; /dev/null stands for no file."""
    from difflib import unified_diff

    for item in found.changes:
        name = str(folder / item.name)
        before, after = (_lines(data) for data in (item.before, item.after))
        if before is None or after is None:
            result(f"Binary files {name} differ")
            continue
        old = "/dev/null" if item.before is None else name
        new = "/dev/null" if item.after is None else name
        for line in unified_diff(before, after, old, new, lineterm=""):
            result(line)


def _lines(data: bytes | None) -> list[str] | None:
    """The lines of a file, none for no file; None for one that is no text."""
    if data is None:
        return []
    try:
        return data.decode("utf-8").splitlines()
    except UnicodeDecodeError:
        return None


def _changed(plant: "Plant", catalog: "Catalog", **given: str | None) -> "Plant":
    """The plant with what the command line says instead of the plant file."""
    from fbgen.plant import changed

    values = {name: value for name, value in given.items() if value is not None}
    return changed(plant, catalog, **values) if values else plant


def _in_dialect(plant: "Plant", dialect: str | None, catalog: "Catalog") -> "Plant":
    from fbgen.plant import in_dialect

    return plant if dialect is None else in_dialect(plant, dialect, catalog)


def _with_numbers(plant: "Plant", given: str) -> "Plant":
    """The plant with other numbers for its blocks. Raises a usage error for what is no range."""
    from fbgen.plant import HIGHEST_BLOCK, BlockNumbers

    if plant.dialect != "step7":
        raise typer.BadParameter(f"dialect {plant.dialect} numbers no blocks", param_hint=_NUMBERS)
    found = re.fullmatch(r"(\d{1,4})-(\d{1,4})", given)
    first, last = (int(found[1]), int(found[2])) if found else (0, 0)
    if not 1 <= first <= last <= HIGHEST_BLOCK:
        message = f"'{given}' is no range of numbers between 1 and {HIGHEST_BLOCK}, such as 200-399"
        raise typer.BadParameter(message, param_hint=_NUMBERS)
    return plant.model_copy(update={"block_numbers": BlockNumbers(first=first, last=last)})
