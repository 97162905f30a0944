"""The main job on the manual's own example, to look at: `fbgen demo`.

Drive 11 forward at 50 Hz, read the current, stop (TOSPBDP001 manual v1.1, section 8 G): from the
plant file through generated text, the engine that reads that text, PROFIBUS, gateway and line to
the simulated inverter and back. What went over the wires is held against the manual's bytes, which
stand in the catalogue's sequence `manual_example` as the manual prints them.
"""

from fbgen.catalog import Telegram, load_catalog
from fbgen.dataclass import dataclass
from fbgen.diagnostics import Diagnostic, DiagnosticError, render
from fbgen.resources import shipped
from harness.kernel import NS_PER_MS
from harness.scenario import prepare, scenario_cases
from harness.scenario.telegram_patterns import bytes_match
from harness.trace.meaning import telegram_meaning
from harness.trace.telegrams import LineFrame, TelegramRecord

EXAMPLE = "manual_example"


@dataclass(frozen=True, slots=True)
class SeenTelegram:
    """One telegram as it went out, and what it means."""

    record: TelegramRecord
    meaning: str

    def as_json(self) -> dict[str, object]:
        """The telegram as plain data; bytes in hexadecimal, times in nanoseconds."""
        record = self.record
        return {
            "sent_ns": record.sent_ns,
            "received_ns": record.received_ns,
            "output": _hex(record.output),
            "line": [
                {
                    "start_ns": frame.start_ns,
                    "end_ns": frame.end_ns,
                    "to_drives": frame.to_drives,
                    "bytes": _hex(frame.data),
                }
                for frame in record.frames
            ],
            "input": _hex(record.input),
            "meaning": self.meaning,
        }

    def render(self, title: str) -> list[str]:
        """The telegram for a person."""
        record = self.record
        lines = [f"{title}  {self.meaning}"]
        lines.append(_row(record.sent_ns, "PLC sends", _hex(record.output)))
        lines += [_line_row(frame) for frame in record.frames]
        lines.append(_row(record.received_ns, "PLC receives", _hex(record.input) or "nothing"))
        return lines


@dataclass(frozen=True, slots=True)
class DemoTelegram:
    """One telegram beside the manual's."""

    seen: SeenTelegram
    printed: Telegram

    @property
    def output_equal(self) -> bool:
        """Whether the PLC sent what the manual prints."""
        return bytes_match(self.printed.output, self.seen.record.output)

    @property
    def input_equal(self) -> bool:
        """Whether the PLC received what the manual prints."""
        return bytes_match(self.printed.input, self.seen.record.input)

    def as_json(self) -> dict[str, object]:
        """The telegram and the manual's as plain data."""
        return self.seen.as_json() | {
            "manual": {"output": self.printed.output, "input": self.printed.input},
            "equal": self.output_equal and self.input_equal,
        }

    def render(self, number: int) -> list[str]:
        """Both for a person."""
        return [
            *self.seen.render(str(number)),
            _verdict("sent", self.printed.output, self.output_equal),
            _verdict("received", self.printed.input, self.input_equal),
        ]


@dataclass(frozen=True, slots=True)
class DemoReport:
    """What the demo has seen. `findings` are what the scenario itself found wrong.

    `first` is the read that goes out before any command, which the manual's example has not.
    """

    plant: str
    dialect: str
    layout: str
    first: SeenTelegram | None
    telegrams: tuple[DemoTelegram, ...]
    sent_count: int
    expected_count: int
    findings: tuple[Diagnostic, ...]
    virtual_ns: int

    @property
    def matches(self) -> bool:
        """Whether every byte is as the manual prints it, and nothing is missing or too many."""
        return (
            self.sent_count == self.expected_count
            and not self.findings
            and all(item.output_equal and item.input_equal for item in self.telegrams)
        )

    def as_json(self) -> dict[str, object]:
        """The report as plain data."""
        return {
            "plant": self.plant,
            "dialect": self.dialect,
            "layout": self.layout,
            "matches": self.matches,
            "virtual_ns": self.virtual_ns,
            "first": self.first.as_json() if self.first else None,
            "telegrams": [item.as_json() for item in self.telegrams],
            "findings": [found.as_json() for found in self.findings],
        }

    def render(self) -> str:
        """The report for a person."""
        lines = [
            f"Plant {self.plant}, layout {self.layout}, generated as {self.dialect} text and run",
            "on the simulated PLC, PROFIBUS, gateway, RS-485 line and inverter.",
            "The example of the TOSPBDP001 manual v1.1, section 8 G:",
        ]
        if self.first is not None:
            note = "   before any command, not part of the example"
            lines += ["", *self.first.render("0"), note]
        for number, telegram in enumerate(self.telegrams, start=1):
            lines += ["", *telegram.render(number)]
        lines += ["", *(render(found) for found in self.findings)]
        if self.sent_count != self.expected_count:
            lines.append(
                f"{self.sent_count} telegrams went out, the manual has {self.expected_count}"
            )
        verdict = (
            "Every byte is as the manual prints it." if self.matches else "NOT as in the manual."
        )
        lines.append(f"{verdict} {self.virtual_ns / 1e9:.2f} s of the plant's time.")
        return "\n".join(lines)


def run_demo() -> DemoReport:
    """Generate the example plant, run the manual's example on the generated text, compare."""
    catalog = load_catalog()
    path = shipped("examples") / EXAMPLE / f"{EXAMPLE}.scenario.yaml"
    run = prepare(scenario_cases(path)[0], catalog)
    findings: tuple[Diagnostic, ...] = ()
    try:
        run.run()
    except DiagnosticError as wrong:
        findings = wrong.diagnostics
    installation = run.installation
    entry = installation.plan.gateways[0]
    drive = catalog.drive(entry.drives[0].series)
    seen = [
        SeenTelegram(record, telegram_meaning(record.output, record.input, drive, catalog))
        for record in run.recorders[entry.name].records
    ]
    printed = catalog.sequence(EXAMPLE).telegrams
    return DemoReport(
        plant=installation.plan.name,
        dialect=installation.plan.dialect,
        layout=entry.layout,
        first=seen[0] if seen else None,
        telegrams=tuple(map(DemoTelegram, seen[1:], printed)),
        sent_count=max(len(seen) - 1, 0),
        expected_count=len(printed),
        findings=findings,
        virtual_ns=installation.kernel.now_ns,
    )


def _hex(data: bytes | None) -> str:
    return data.hex(" ").upper() if data is not None else ""


def _row(time_ns: int | None, what: str, shown: str) -> str:
    time = f"{time_ns / NS_PER_MS:11.3f} ms" if time_ns is not None else " " * 14
    return f"{time}  {what:<22}{shown}"


def _line_row(frame: LineFrame) -> str:
    what = "gateway to drives" if frame.to_drives else "drive to gateway"
    return _row(frame.start_ns, f"  {what}", _hex(frame.data))


def _verdict(what: str, printed: str, equal: bool) -> str:
    return f"{'':14}  {'manual, ' + what:<22}{printed:<28}{'equal' if equal else 'DIFFERENT'}"
