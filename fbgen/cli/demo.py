"""`fbgen demo`: the whole chain on the manual's own example."""

import typer

from fbgen.cli import FINDINGS
from fbgen.cli.examples import examples
from fbgen.cli.layers import JsonOption
from fbgen.cli.output import result, result_json


def register(program: typer.Typer) -> None:
    """Add the command to the program."""
    program.command(epilog=examples("fbgen demo", "fbgen demo --json"))(demo)


def demo(as_json: JsonOption = False) -> None:
    """Run the whole chain on the manual's own example.

    The example plant is generated and the manual's example runs on the generated text: drive 11
    forward at 50 Hz, read the current, stop (TOSPBDP001 manual, section 8 G). Each telegram is
    shown with its frames on the line, its times and whether it equals the manual's. Exit status 1
    if one does not.
    """
    from harness.demo import run_demo

    report = run_demo()
    if as_json:
        result_json(report.as_json())
    else:
        result(report.render())
    if not report.matches:
        raise typer.Exit(FINDINGS)
