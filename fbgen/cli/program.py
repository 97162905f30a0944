"""The program `fbgen` and its commands. Only the one that is asked for is imported."""

from collections.abc import Sequence
from importlib import import_module
from typing import Annotated

import typer

from fbgen import __version__
from fbgen.cli.examples import examples

COMMANDS = (
    *("demo", "init", "generate", "diff", "check", "fmt", "convert", "run", "test", "coverage"),
    *(
        "mutate",
        "campaign",
        "decode",
        "encode",
        "gsd",
        "docs",
        "explain",
        "schemas",
        "talk",
        "record",
        "replay",
        "catalog",
        "sim",
    ),
)
"""In the order of the help; each has the module of its name."""


def program_for(arguments: Sequence[str]) -> typer.Typer:
    """The program with the command that these arguments begin with, or with all commands."""
    program = typer.Typer(
        add_completion=False,
        context_settings={"help_option_names": ["-h", "--help"]},
        no_args_is_help=True,
        pretty_exceptions_enable=False,
        rich_markup_mode=None,
    )
    program.callback(
        epilog=examples(
            "fbgen demo                              the whole chain on the manual's example",
            "fbgen init my_plant                     a commented plant file to start from",
            "fbgen generate my_plant/plant.yaml -o out",
            "fbgen decode tospbdp001.status 9F00     what the bits of a word mean",
            "fbgen explain FB2006                    what a message means and how to mend it",
        )
    )(_fbgen)
    asked = arguments[0] if arguments else ""
    for name in [asked] if asked in COMMANDS else COMMANDS:
        import_module(f"fbgen.cli.{name}").register(program)
    return program


def _version(wanted: bool) -> None:
    if wanted:
        typer.echo(f"fbgen {__version__}")
        raise typer.Exit


def _fbgen(
    version: Annotated[
        bool, typer.Option("--version", callback=_version, is_eager=True, help="Show the version.")
    ] = False,
) -> None:
    """Function blocks for Toshiba VF inverters on PLCs: generated, explained and tested.

    None of the generated blocks is a safety function.
    """
