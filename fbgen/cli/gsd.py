"""`fbgen gsd`: what a GSD file says about a PROFIBUS DP slave, and how a PLC reaches its data."""

from pathlib import Path
from typing import Annotated

import typer

from fbgen.cli.examples import examples
from fbgen.cli.layers import CatalogOption, JsonOption
from fbgen.cli.output import report, result, result_json

_LAST_ADDRESS = 65535


def register(program: typer.Typer) -> None:
    """Add the command to the program."""
    program.command(
        epilog=examples(
            "fbgen gsd ESCO1803.GSD",
            "fbgen gsd ESCO1803.GSD --address 256",
            'fbgen gsd station.gsd --module "4 AI" --module "2 AO"',
            "fbgen gsd ESCO1803.GSD --json",
        )
    )(gsd)


def gsd(
    file: Annotated[
        Path, typer.Argument(metavar="FILE", help="The GSD file: .gsd, or .gse, .gsg, ...")
    ],
    modules: Annotated[
        list[str] | None,
        typer.Option(
            "--module",
            metavar="NAME",
            help="A module to plug; several in the order of their places. Without it the only one.",
        ),
    ] = None,
    address: Annotated[
        int,
        typer.Option(
            "--address",
            min=0,
            max=_LAST_ADDRESS,
            metavar="N",
            help="First byte of inputs and outputs in the PLC.",
        ),
    ] = 0,
    catalog: CatalogOption = None,
    as_json: JsonOption = False,
) -> None:
    """Show modules, identifiers, lengths and addresses of a GSD file, and how a PLC reaches them.

    For each family of PLCs it says which access way of a plant file can be used and why another one
    cannot: what DPRD_DAT and DPWR_DAT (SFC14, SFC15) reach, what single accesses and the process
    image keep together. The last lines are for the plant file.
    """
    from fbgen.catalog import load_catalog
    from fbgen.cli.reports.gsd_report import GsdReport, gsd_json, gsd_text
    from fbgen.diagnostics import DiagnosticError
    from fbgen.plant import read_gsd_file
    from fbgen.wire.gsd import choose

    station = read_gsd_file(file, file.name)
    report(station.warnings)
    try:
        chosen = choose(station, modules or ())
    except DiagnosticError:
        if modules:
            raise
        chosen = None
    found = GsdReport(file, station, chosen, address, load_catalog(catalog or ()))
    if as_json:
        result_json(gsd_json(found))
    else:
        result(gsd_text(found))
