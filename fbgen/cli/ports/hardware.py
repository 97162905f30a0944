"""`fbgen test --port`: real inverters in the place of simulated ones, and how time was kept."""

import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import TYPE_CHECKING, Annotated

import typer

from fbgen.cli.output import say

if TYPE_CHECKING:
    from fbgen.diagnostics import Diagnostic
    from harness.scenario import ObserverMaker, ReportWriter, ScenarioReport
    from harness.scenario.real_drives import RealDrivesMaker

HardwarePortOption = Annotated[
    str | None,
    typer.Option(
        "--port",
        metavar="P",
        help="Real inverters at this serial port, in real time: COM3, /dev/ttyUSB0, socket://...",
    ),
]
RealOption = Annotated[
    list[str] | None,
    typer.Option(
        "--real", metavar="NAME", help="A drive of the plant that is there. May be repeated."
    ),
]
YesOption = Annotated[
    bool, typer.Option("--yes", help="Real motors may start: nobody is at the machine.")
]


@contextmanager
def hardware_writer(
    port: str | None, real: Sequence[str] | None, jobs: int, *, yes: bool
) -> "Iterator[ReportWriter | None]":
    """Who puts the inverters in, and tells how time was kept; None without a port.

    Whatever ends the runs, the inverters are told to stop. Raises DiagnosticError FB8080, FB9053
    and those of ports.
    """
    if port is None and not real:
        yield None
        return
    _check(port, real, jobs)
    from harness.line import GATEWAY_FORMAT
    from harness.scenario.real_drives import RealDrivesMaker
    from harness.serial import serial_port

    opened = serial_port(port or "", GATEWAY_FORMAT)
    try:
        _confirm(real or (), yes)
    except BaseException:
        opened.close()
        raise
    maker = RealDrivesMaker(tuple(real or ()), opened)
    try:
        yield _TimeWriter(maker)
    except BaseException:
        maker.stop()
        raise
    finally:
        opened.close()


def _check(port: str | None, real: Sequence[str] | None, jobs: int) -> None:
    from fbgen.diagnostics import error

    if port is None:
        message, help_ = "real drives are at no port", "add --port P"
    elif not real:
        message, help_ = "it is not said which drives are real", "add --real NAME"
    elif jobs > 1:
        message, help_ = "one port serves one scenario at a time", "leave out -j"
    else:
        return
    raise error("FB8080", message, None, help_)


def _confirm(real: Sequence[str], yes: bool) -> None:
    from fbgen.diagnostics import error

    names = ", ".join(real)
    if yes or (
        sys.stdin.isatty()
        and typer.confirm(f"The scenarios may start the motors of {names}. Go on?", err=True)
    ):
        return
    raise error(
        "FB9053",
        f"this may start the motors of {names}; nothing was sent",
        None,
        "see that nobody is at the machine, then add --yes",
    )


class _TimeWriter:
    """Tells how real time was kept: a run that was too far behind has failed."""

    def __init__(self, maker: "RealDrivesMaker") -> None:
        self._maker = maker

    @property
    def observers(self) -> "Sequence[ObserverMaker]":
        """As `ReportWriter.observers`."""
        return (self._maker,)

    def write(self, report: "ScenarioReport") -> "Sequence[Diagnostic]":
        """FB8081 for each run that has not kept real time, FB8082 for drives that may run on."""
        from fbgen.diagnostics import Diagnostic
        from harness.scenario.real_drives import LATE_NS, KeptTime

        found = []
        for result in report.results:
            kept = result.observed(KeptTime)
            if kept is None:
                continue
            time = kept.time
            say(f"{result.name}: at most {time.longest_ns / 1e6:.1f} ms behind real time")
            if time.late_ticks:
                found.append(
                    Diagnostic(
                        "FB8081",
                        f"'{result.name}' was up to {time.longest_ns / 1e6:.0f} ms behind real "
                        f"time, and more than {LATE_NS // 1_000_000} ms at {time.late_ticks} of "
                        f"{time.ticks} looks",
                        None,
                        "end other programs, or give the plant a longer cycle_time_ms",
                    )
                )
            if kept.not_stopped:
                found.append(
                    Diagnostic(
                        "FB8082",
                        f"{', '.join(kept.not_stopped)} did not answer when told to stop",
                        None,
                        "see whether the motor runs, and stop it at its panel; with F803 it trips "
                        "by itself when nobody talks to it",
                    )
                )
        if report.interrupted:
            self._maker.stop()
        return found
