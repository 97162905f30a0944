"""Makes the fault that a scenario names, and tells everything that is wrong with it."""

from collections.abc import Mapping
from typing import Protocol

from fbgen.diagnostics import Diagnostic, DiagnosticError
from fbgen.nearest import nearest
from fbgen.source import Span
from harness.faults import FAULTS, Fault, FaultType, Target
from harness.faults.settings import fault_settings
from harness.installation import Installation
from harness.scenario.places import at
from harness.scenario.scalars import Scalar


class FaultEntry(Protocol):
    """What names a fault in a file: a step, or an entry of `faults`."""

    @property
    def inject(self) -> str:
        """Its name."""
        ...

    @property
    def on(self) -> str | None:
        """The gateway or drive."""
        ...

    @property
    def settings(self) -> Mapping[str, Scalar]:
        """Its settings."""
        ...

    def span_of(self, name: str) -> Span | None:
        """Where a key stands."""
        ...

    def item_span_of(self, name: str, key: str) -> Span | None:
        """Where the value of a key of a mapping stands."""
        ...


class FaultMaking:
    """Makes faults for one plant. What is wrong goes into `found`."""

    def __init__(self, plant: Installation, found: list[Diagnostic]) -> None:
        self._plant = plant
        self._found = found

    def fault(self, entry: FaultEntry) -> Fault | None:
        """The fault, not yet injected; None if something is wrong with it, FB8004 or its own."""
        kind = self.kind(entry.inject, entry.span_of("inject"))
        if kind is None:
            return None
        is_there = self._is_there(kind, entry)
        places = {name: entry.item_span_of("settings", name) for name in entry.settings}
        try:
            settings = fault_settings(kind, entry.settings, places)
        except DiagnosticError as wrong:
            self._found += wrong.diagnostics
            return None
        if not is_there:
            return None
        try:
            return kind.make(self._plant, entry.on or "", settings)
        except DiagnosticError as wrong:
            self._found += at(entry.span_of("settings"), wrong.diagnostics)
            return None

    def kind(self, name: str, place: Span | None) -> FaultType[Installation] | None:
        """The kind of fault with a name."""
        if name not in FAULTS:
            self._report(f"there is no fault '{name}'", place, nearest(name, FAULTS))
        return FAULTS.get(name)

    def _is_there(self, kind: FaultType[Installation], entry: FaultEntry) -> bool:
        places = kind.target.places(self._plant)
        what = kind.target.value
        if kind.target is Target.WHOLE:
            if entry.on is not None:
                message = f"the fault '{kind.name}' happens to the whole plant"
                self._report(message, entry.span_of("on"), "leave out on:")
            return entry.on is None
        if entry.on is None:
            message = f"the fault '{kind.name}' happens to one {what}"
            advice = f"say to which one, such as on: {next(iter(places), 'its name')}"
            self._report(message, entry.span_of("inject"), advice)
        elif entry.on not in places:
            message = f"the fault '{kind.name}' needs a {what}, and there is no {what} '{entry.on}'"
            self._report(message, entry.span_of("on"), nearest(entry.on, places))
        return entry.on in places

    def _report(self, message: str, place: Span | None, advice: str) -> None:
        self._found.append(Diagnostic("FB8004", message, place, advice))
