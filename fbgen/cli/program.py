"""The program `fbgen` with all its commands."""

from typing import Annotated

import typer

from fbgen import __version__
from fbgen.cli import (
    campaign,
    catalog,
    check,
    convert,
    coverage,
    decode,
    demo,
    diff,
    encode,
    explain,
    fmt,
    generate,
    init,
    mutate,
    run,
    schemas,
    sim,
    test,
)
from fbgen.cli.examples import examples

program = typer.Typer(
    add_completion=False,
    context_settings={"help_option_names": ["-h", "--help"]},
    no_args_is_help=True,
    pretty_exceptions_enable=False,
    rich_markup_mode=None,
)


def _version(wanted: bool) -> None:
    if wanted:
        typer.echo(f"fbgen {__version__}")
        raise typer.Exit


@program.callback(
    epilog=examples(
        "fbgen demo                              the whole chain on the manual's example",
        "fbgen init my_plant                     a commented plant file to start from",
        "fbgen generate my_plant/plant.yaml -o out",
        "fbgen decode tospbdp001.status 9F00     what the bits of a word mean",
        "fbgen explain FB2006                    what a message means and how to mend it",
    )
)
def _fbgen(
    version: Annotated[
        bool, typer.Option("--version", callback=_version, is_eager=True, help="Show the version.")
    ] = False,
) -> None:
    """Function blocks for Toshiba VF inverters on PLCs: generated, explained and tested.

    None of the generated blocks is a safety function.
    """


for _module in (
    demo,
    init,
    generate,
    diff,
    check,
    fmt,
    convert,
    run,
    test,
    coverage,
    mutate,
    campaign,
    decode,
    encode,
    explain,
    schemas,
):
    _module.register(program)
catalog.register(program)
sim.register(program)
