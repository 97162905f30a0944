"""Faults of a scenario that come by the clock and not by a step: at an instant, again and again, or
drawn by the seed. Whatever is written, a list of events comes out of it, each with its instant.
"""

from collections.abc import Iterable, Mapping
from random import Random
from typing import Annotated, Any

from pydantic import ConfigDict, Discriminator, Field, Tag

from fbgen.catalog import Located
from fbgen.catalog.scalars import Count, Text
from fbgen.diagnostics import Diagnostic
from harness.durations import DurationNs, PositiveDurationNs
from harness.faults import FAULTS
from harness.faults.schedule import FaultEvent
from harness.scenario.fault_schema import FaultNameSchema, with_places_and_settings
from harness.scenario.scalars import ScalarValue

FaultName = Annotated[Text, FaultNameSchema()]
"""Which ones there are is checked with everything else in a step; the schema helps editors."""


class ScheduledFault(Located):
    """A fault at an instant behind the start of the plant, once or again and again."""

    model_config = ConfigDict(json_schema_extra=with_places_and_settings)

    at: DurationNs = Field(description="When it begins, behind the start of the plant")
    lasts: PositiveDurationNs | None = Field(
        default=None, description="How long it lasts; to the end if not said"
    )
    every: PositiveDurationNs | None = Field(
        default=None, description="Again after this time, until `until`"
    )
    until: PositiveDurationNs | None = Field(
        default=None, description="The last instant at which it begins again"
    )
    inject: FaultName = Field(description="What goes wrong")
    on: Text | None = Field(default=None, description="The gateway or drive that it happens to")
    settings: dict[str, ScalarValue] = Field(
        default_factory=dict, description="Settings of the fault; each has a default"
    )

    def problems(self) -> Iterable[Diagnostic]:
        """FB7521: a repetition without an end, or one that overlaps itself."""
        if (self.every is None) != (self.until is None):
            missing = "until:" if self.until is None else "every:"
            message = f"a fault that comes again needs every: and until:, here {missing} is missing"
            yield Diagnostic("FB7521", message, self.span, f"write {missing}, or leave out both")
        elif self.every is not None and (self.lasts is None or self.lasts > self.every):
            yield Diagnostic(
                "FB7521",
                "a fault that comes again is over before it does",
                self.span_of("every"),
                "write lasts: with a time that is not longer than every:",
            )
        if self.until is not None and self.until < self.at:
            yield Diagnostic(
                "FB7521",
                "the end of the repetition comes before its beginning",
                self.span_of("until"),
                "until: is an instant behind the start of the plant, as at:",
            )

    def instants(self) -> range:
        """When it begins, in ns behind the start."""
        if self.every is None or self.until is None:
            return range(self.at, self.at + 1)
        return range(self.at, self.until + 1, self.every)

    def events(self) -> list[FaultEvent]:
        """All of them, in their order."""
        return [
            FaultEvent(at_ns, self.lasts, self.inject, self.on or "", tuple(self.settings.items()))
            for at_ns in self.instants()
        ]


class RandomFaults(Located):
    """So many faults, drawn by the seed of the run: what, where, when and how long."""

    random: Annotated[Count, Field(ge=1, le=1000)] = Field(description="How many")
    after: DurationNs = Field(
        default=0,
        description="The first instant at which one begins, behind the start of the plant",
        json_schema_extra={"default": "0 s"},
    )
    before: PositiveDurationNs = Field(description="The instant at which all are over")
    lasts: PositiveDurationNs = Field(description="How long one lasts at most")
    kinds: tuple[FaultName, ...] = Field(
        default=(), description="Which faults are drawn from; all if none is named"
    )

    def problems(self) -> Iterable[Diagnostic]:
        """FB7521: no time is left. FB8004: an unknown fault."""
        if self.after + self.lasts > self.before:
            yield Diagnostic(
                "FB7521",
                "a fault that lasts so long is not over in time",
                self.span_of("lasts"),
                "let lasts: be no longer than the time from after: to before:",
            )

    def events(self, random: Random, places: Mapping[str, tuple[str, ...]]) -> list[FaultEvent]:
        """Draw them. `places` are those where each fault can be: (``""``,) for the whole plant."""
        chosen = sorted(name for name in self.kinds or FAULTS if places.get(name))
        events = []
        for _ in range(self.random if chosen else 0):
            name = random.choice(chosen)
            lasts_ns = random.randrange(self.lasts) + 1
            at_ns = self.after + random.randrange(self.before - self.after - lasts_ns + 1)
            events.append(FaultEvent(at_ns, lasts_ns, name, random.choice(places[name])))
        return sorted(events)


def _kind(value: Any) -> str:
    is_random = "random" in value if isinstance(value, dict) else isinstance(value, RandomFaults)
    return "random faults" if is_random else "a scheduled fault"


ScenarioFault = Annotated[
    Annotated[ScheduledFault, Tag("a scheduled fault")]
    | Annotated[RandomFaults, Tag("random faults")],
    Discriminator(_kind),
]
"""An entry of `faults`."""
