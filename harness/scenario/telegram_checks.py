"""Compares the telegrams of a gateway with those that a scenario expects."""

from collections.abc import Iterator, Sequence
from dataclasses import replace

from fbgen.dataclass import dataclass
from fbgen.diagnostics import Diagnostic, DiagnosticError
from fbgen.source import Span
from harness.scenario.model import ExpectedTelegram
from harness.scenario.plant_stage import PlantStage
from harness.scenario.telegram_patterns import bytes_match
from harness.trace.telegrams import TelegramRecord


@dataclass(frozen=True, slots=True)
class TelegramCheck:
    """The telegrams that a gateway must have had since the last such check."""

    stage: PlantStage
    place: Span | None
    gateway: str
    telegrams: tuple[ExpectedTelegram, ...]

    def check(self) -> int:
        """How many were compared. Raises DiagnosticError FB8006 with all that differ."""
        records = self.stage.new_telegrams(self.gateway)
        found = [*self._count(records)]
        pairs = zip(records, self.telegrams, strict=False)
        for number, (record, expected) in enumerate(pairs, start=1):
            found += self._differences(number, record, expected)
        if found:
            notes = (*found[-1].notes, *self.stage.cpu_notes())
            raise DiagnosticError([*found[:-1], replace(found[-1], notes=notes)])
        return max(len(self.telegrams), 1)

    def _count(self, records: Sequence[TelegramRecord]) -> Iterator[Diagnostic]:
        if len(records) != len(self.telegrams):
            message = (
                f"{len(records)} telegrams went out on {self.gateway}, "
                f"expected {len(self.telegrams)}"
            )
            notes = tuple(self.stage.telegram(self.gateway, record) for record in records)
            yield Diagnostic("FB8006", message, self.place, notes=notes)

    def _differences(
        self, number: int, record: TelegramRecord, expected: ExpectedTelegram
    ) -> Iterator[Diagnostic]:
        for what, pattern, data in (
            ("output", expected.output, record.output),
            ("input", expected.input, record.input),
        ):
            if pattern is not None and not bytes_match(pattern, data):
                shown = data.hex(" ").upper() if data is not None else "missing: no reply came"
                yield Diagnostic(
                    "FB8006",
                    f"the {what} of telegram {number} is {shown}, expected {pattern}",
                    expected.span_of(what) or self.place,
                    notes=(self.stage.telegram(self.gateway, record),),
                )
