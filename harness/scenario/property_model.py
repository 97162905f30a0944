"""Properties of scenario files: what must hold during the whole run, whatever the steps do.

properties:
  - never: {drive.pump.running: true, drive.pump.powered: false}
  - after: {plc.TOS_Plant.gw1.pump.stop.execute: true}
    within: 2 s
    then: {drive.pump.running: false}
"""

from collections.abc import Iterator, Mapping
from typing import Annotated

from pydantic import Discriminator, Field, Tag

from fbgen.catalog import Located
from fbgen.catalog.scalars import Text
from harness.durations import PositiveDurationNs
from harness.scenario.expectations import Conditions
from harness.scenario.kind_tags import tag_by_key


class AnyProperty(Located):
    """What all kinds of properties may have."""

    name: Text | None = Field(default=None, description="What it is for, shown when it is violated")
    during: Conditions | None = Field(
        default=None, description="The property counts only while all of this holds"
    )

    def paths(self) -> Iterator[str]:
        """What it names, key by key."""
        for name in type(self).model_fields:
            conditions = getattr(self, name)
            if isinstance(conditions, Mapping):
                yield from conditions


class NeverProperty(AnyProperty):
    """All of it must not hold at the same instant, ever."""

    never: Conditions = Field(description="Path: value, or path: {min: ..., max: ...}")


class AlwaysProperty(AnyProperty):
    """All of it must hold at every instant."""

    always: Conditions = Field(description="Path: value, or path: {min: ..., max: ...}")


class AfterProperty(AnyProperty):
    """Each time that `after` becomes true, `then` must hold at some instant `within` the time."""

    after: Conditions = Field(description="What begins the time")
    within: PositiveDurationNs = Field(description="How long it may take, such as 500 ms")
    then: Conditions = Field(description="What must come of it")


class AtMostProperty(AnyProperty):
    """Something may happen only so often within a time."""

    at_most: Annotated[int, Field(ge=0, strict=True)] = Field(
        description="How often `of` may become true"
    )
    per: PositiveDurationNs = Field(description="In any stretch of this length, such as 1 s")
    of: Conditions = Field(description="What is counted each time that it becomes true")


class MutuallyExclusiveProperty(AnyProperty):
    """Of these at most one may hold at the same instant."""

    mutually_exclusive: Annotated[Conditions, Field(min_length=2)] = Field(
        description="Two paths or more, each with the value that excludes the others"
    )


class EventuallyProperty(AnyProperty):
    """All of it must hold at some instant of the run."""

    eventually: Conditions = Field(description="Path: value, or path: {min: ..., max: ...}")


_KINDS: dict[str, type[AnyProperty]] = {
    "never": NeverProperty,
    "always": AlwaysProperty,
    "after": AfterProperty,
    "at_most": AtMostProperty,
    "mutually_exclusive": MutuallyExclusiveProperty,
    "eventually": EventuallyProperty,
}

Property = Annotated[
    Annotated[NeverProperty, Tag("never property")]
    | Annotated[AlwaysProperty, Tag("always property")]
    | Annotated[AfterProperty, Tag("after property")]
    | Annotated[AtMostProperty, Tag("at_most property")]
    | Annotated[MutuallyExclusiveProperty, Tag("mutually_exclusive property")]
    | Annotated[EventuallyProperty, Tag("eventually property")],
    Discriminator(
        tag_by_key(_KINDS, "property"),
        custom_error_type="property",
        custom_error_message="a property has exactly one of the keys " + ", ".join(_KINDS),
    ),
]
"""One property; its key says which kind."""
