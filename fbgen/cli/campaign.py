"""`fbgen campaign`: many seeds of random faults on plants and scenarios."""

import sys
from pathlib import Path
from time import monotonic
from typing import TYPE_CHECKING, Annotated

import typer

from fbgen.cli import FINDINGS, INTERRUPTED
from fbgen.cli.examples import examples
from fbgen.cli.layers import JsonOption
from fbgen.cli.output import counted, on_error_terminal, result, result_json, say

if TYPE_CHECKING:
    from harness.verify.campaign import CampaignReport, Failure, Progressed

NS_PER_S = 1_000_000_000
_SHOWN_EVERY_S = 1.0


def register(program: typer.Typer) -> None:
    """Add the command to the program."""
    program.command(
        "campaign",
        epilog=examples(
            "fbgen campaign plant.yaml --seeds 1000",
            "fbgen campaign plant.yaml --seeds 100000 --workers 8 -o campaign",
            "fbgen campaign scenarios --seeds 500 --resume campaign/log.jsonl",
            "fbgen campaign plant.yaml --faults line_noise --faults drive_unpowered",
            "fbgen campaign plant.yaml --seeds 100000 --cluster tcp://10.0.0.5:8786",
        ),
    )(run_campaign)


def run_campaign(
    paths: Annotated[
        list[Path] | None,
        typer.Argument(
            metavar="PATHS",
            help="Plant files, scenario files, folders of scenarios; else the example plant.",
        ),
    ] = None,
    seeds: Annotated[
        int, typer.Option("--seeds", metavar="N", min=1, help="How many, from 0 on.")
    ] = 1000,
    workers: Annotated[
        int, typer.Option("--workers", metavar="N", min=1, help="Processes of this machine.")
    ] = 1,
    cluster: Annotated[
        str | None,
        typer.Option("--cluster", metavar="ADDRESS", help="Scheduler of dask.distributed."),
    ] = None,
    faults: Annotated[
        list[str] | None,
        typer.Option("--faults", metavar="NAME", help="Only these faults, for plant files."),
    ] = None,
    resume: Annotated[
        Path | None,
        typer.Option("--resume", metavar="LOG", help="Go on with this log; else a new one."),
    ] = None,
    out: Annotated[
        Path,
        typer.Option("-o", "--out", metavar="DIR", help="For the log and the scenario files."),
    ] = Path("campaign"),
    as_json: JsonOption = False,
) -> None:
    """Try many seeds of random faults; make each failure a short scenario.

    The same seed gives the same run everywhere, with however many workers. Exit status 1 if
    something fails, 130 after Ctrl-C: go on with --resume.
    """
    from harness.verify.campaign import Campaign
    from harness.verify.campaign.files import campaign_settings
    from harness.verify.campaign.reproduction import reproduce

    settings = campaign_settings(paths or [], faults or [])
    log = resume or out / "log.jsonl"
    if resume is None and log.exists():
        log.unlink()
    display = _Display()
    done = Campaign(settings, seeds, workers, cluster).run(log, display.progressed)
    display.end()
    files: dict[str, Path] = {}
    for kind, failures in done.kinds().items():
        if not done.interrupted:
            display.making_short(kind)
            files[kind] = reproduce(settings, failures[0], out)
            display.end()
        if not as_json:
            result(_told(kind, failures, files.get(kind)))
    if as_json:
        result_json(_plain(done, files))
    say(display.summary(done))
    if done.interrupted:
        say(f"go on with: --resume {log.as_posix()}")
        raise typer.Exit(INTERRUPTED)
    if done.failures:
        raise typer.Exit(FINDINGS)


def _told(kind: str, failures: "list[Failure]", file: Path | None) -> str:
    first = failures[0]
    seeds = counted(len(failures), "seed")
    text = f"{kind}: {seeds}, first {first.seed}: {first.message}\n  {first.configuration}"
    return text if file is None else f"{text}\n  run it again: fbgen test {file.as_posix()}"


def _plain(done: "CampaignReport", files: dict[str, Path]) -> dict[str, object]:
    return {
        "seeds": done.seeds,
        "virtual_ns": done.virtual_ns,
        "configurations": list(done.configurations),
        "failures": [
            {
                "kind": kind,
                "seeds": [failure.seed for failure in failures],
                "message": failures[0].message,
                "configuration": failures[0].configuration,
                "file": files[kind].as_posix() if kind in files else None,
            }
            for kind, failures in done.kinds().items()
        ],
    }


class _Display:
    """Rate and remaining time on a terminal, and the summary."""

    def __init__(self) -> None:
        self._begin = self._shown = monotonic()
        self._first: int | None = None
        self._is_shown = on_error_terminal()

    def progressed(self, how: "Progressed") -> None:
        now = monotonic()
        if self._first is None:
            self._first = how.done
            self._begin = now
        if not self._is_shown or now - self._shown < _SHOWN_EVERY_S:
            return
        self._shown = now
        rate = (how.done - self._first) / (now - self._begin) if now > self._begin else 0.0
        left = f", {(how.seeds - how.done) / rate:.0f} s left" if rate else ""
        sys.stderr.write(
            f"\r\x1b[K{how.done} of {how.seeds} seeds in {how.configurations} configurations, "
            f"{rate:.1f} a second{left}, {how.failures} failed"
        )
        sys.stderr.flush()

    def making_short(self, kind: str) -> None:
        if self._is_shown:
            sys.stderr.write(f"\r\x1b[K{kind}: making it short")
            sys.stderr.flush()

    def end(self) -> None:
        if self._is_shown:
            sys.stderr.write("\r\x1b[K")
            sys.stderr.flush()

    def summary(self, done: "CampaignReport") -> str:
        kinds = len(done.kinds())
        return (
            f"{done.seeds} seeds in {len(done.configurations)} configurations, "
            f"{done.virtual_ns / NS_PER_S:.0f} s of plants' time, "
            f"{len(done.failures)} failed in {kinds} {'way' if kinds == 1 else 'ways'}"
        )
