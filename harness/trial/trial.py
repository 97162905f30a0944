"""Cycle after cycle: set what is due, call, note what is watched, let the cycle time pass."""

from collections.abc import Iterator, Sequence

from fbgen.dataclass import dataclass
from fbgen.diagnostics import DiagnosticError, error
from fbgen.lang.types import Scalar, Type
from harness.engine.interface import Value
from harness.engine.loading import LoadedProgram
from harness.engine.spelling import WrongSpellingError, read_value, spell
from harness.trial.settings import Setting
from harness.trial.subject import Subject, subject_named


@dataclass(frozen=True, slots=True)
class Row:
    """What was found behind one cycle: its number from 1, its instant, the watched values."""

    cycle: int
    now_ns: int
    values: tuple[Value, ...]


class Trial:
    """A block with the settings for it and the variables to watch.

    `watch` are paths; without any, the outputs are watched. Raises DiagnosticError with everything
    that is wrong in the settings and paths: FB9013 for values, FB6020 and FB6024 for names.
    """

    def __init__(
        self,
        program: LoadedProgram,
        block: str = "",
        settings: Sequence[Setting] = (),
        watch: Sequence[str] = (),
    ) -> None:
        self._program = program
        self._subject: Subject = subject_named(program.engine, block)
        self.watched = tuple(watch) or self._subject.outputs
        problems: list[DiagnosticError] = []
        self._types = [self._type_of(path, problems) for path in self.watched]
        self._settings = [
            (setting, value)
            for setting in settings
            if (value := self._value_of(setting, problems)) is not None
        ]
        if problems:
            raise DiagnosticError([found for each in problems for found in each.diagnostics])

    def _type_of(self, path: str, problems: list[DiagnosticError]) -> Type | None:
        try:
            return self._subject.type_of(path)
        except DiagnosticError as problem:
            problems.append(problem)
            return None

    def _value_of(self, setting: Setting, problems: list[DiagnosticError]) -> Scalar | None:
        kind = self._type_of(setting.path, problems)
        if kind is None:
            return None
        try:
            return read_value(kind, setting.text)
        except WrongSpellingError as wrong:
            message = f"'{setting.text}' is no value for {setting.path}, which is of type {kind}"
            problems.append(error("FB9013", message, help=wrong.help))
        except DiagnosticError as refused:
            problems.append(refused)
        return None

    def rows(self, cycles: int, every_ns: int) -> Iterator[Row]:
        """Run so many cycles, one each `every_ns`. Raises the faults of the program."""
        clock = self._program.clock
        waiting = list(self._settings)
        for cycle in range(1, cycles + 1):
            due = [item for item in waiting if item[0].is_due(cycle, clock.now_ns)]
            waiting = [item for item in waiting if item not in due]
            for setting, value in due:
                self._subject.set(setting.path, value)
            self._subject.call()
            values = tuple(self._subject.value(path) for path in self.watched)
            yield Row(cycle, clock.now_ns, values)
            clock.advance(ns=every_ns)

    def texts(self, row: Row) -> list[str]:
        """The values of a row as PLC text writes them."""
        return [
            spell(kind, value)
            for kind, value in zip(self._types, row.values, strict=True)
            if kind is not None
        ]
