"""Scenario files: a plant, what is done to it, and what must come of it. Format version 1.

    version: 1
    title: Forward at 50 Hz
    plant: plant.yaml
    steps:
      - set: {plc.TOS_Plant.gw1.pump.start_forward.execute: true}
      - expect: {drive.pump.frequency: 50.0}
        within: 12 s

Steps run one after the other. Names in `set` and `expect` are paths, see `references`.
"""

import re
from collections.abc import Iterable
from typing import Annotated, Any, Literal

from pydantic import BeforeValidator, Discriminator, Field, Tag
from pydantic.json_schema import WithJsonSchema

from fbgen.catalog import Located
from fbgen.catalog.scalars import Count, SnakeName, Text
from fbgen.diagnostics import Diagnostic
from harness.drives import Load, LoadShape
from harness.kernel import NS_PER_MS, NS_PER_S, NS_PER_US
from harness.plant import DriveConditions

_UNITS = {
    "us": NS_PER_US,
    "ms": NS_PER_MS,
    "s": NS_PER_S,
    "min": 60 * NS_PER_S,
    "h": 3600 * NS_PER_S,
}
_DURATION = re.compile(r"([0-9]+(?:\.[0-9]+)?) ?(us|ms|s|min|h)")


def _duration(value: object) -> object:
    match = _DURATION.fullmatch(value) if isinstance(value, str) else None
    if match is None:
        raise ValueError(
            f"'{value}' is no time: write a number with its unit, such as 500 ms or 2 s"
        )
    return round(float(match[1]) * _UNITS[match[2]])


DurationNs = Annotated[
    int,
    BeforeValidator(_duration),
    WithJsonSchema({"type": "string", "pattern": f"^{_DURATION.pattern}$"}),
]
"""A time such as `500 ms`, as integer nanoseconds."""

ScalarValue = bool | int | float | str


class Range(Located):
    """What a value must be. `tolerance` goes with `equals`; limits are included."""

    equals: ScalarValue | None = None
    tolerance: float = 0.0
    min: float | None = None
    max: float | None = None
    differs_from: ScalarValue | None = None
    bits: dict[SnakeName, int] | None = None
    word: Text | None = None

    def problems(self) -> Iterable[Diagnostic]:
        """FB8002: nothing is demanded, or bits of an unnamed word."""
        demands = (self.equals, self.min, self.max, self.differs_from, self.bits)
        if all(item is None for item in demands):
            yield Diagnostic(
                "FB8002",
                "nothing is demanded of the value",
                self.span,
                "give equals, min, max, differs_from or bits",
            )
        if (self.bits is None) != (self.word is None):
            yield Diagnostic(
                "FB8002",
                "bits are named after a word of the catalogue, and bits and word go together",
                self.span,
                "write word: tospbdp001.status and bits: {status_changed: 1}",
            )


Expectation = ScalarValue | Range


class SetStep(Located):
    """Write variables of the PLC, parameters or properties of the devices."""

    set: dict[str, ScalarValue] = Field(min_length=1)


class WaitStep(Located):
    """Let time pass."""

    wait: DurationNs


class ExpectStep(Located):
    """Check now; with `within` as soon as it holds, at the latest after that time; with `stays_for`
    it must hold from then on for that time."""

    expect: dict[str, Expectation] = Field(min_length=1)
    within: DurationNs | None = None
    stays_for: DurationNs | None = None


class InjectStep(Located):
    """Start a fault, on a device where it needs one. `clear` names it again."""

    inject: SnakeName
    on: Text | None = None
    settings: dict[SnakeName, ScalarValue] = Field(default_factory=dict)


class ClearStep(Located):
    """End a fault."""

    clear: SnakeName
    on: Text | None = None


class ExpectedTelegram(Located):
    """A telegram as it must have been: bytes in hexadecimal, `xx` for any."""

    output: Text
    input: Text | None = None


class TelegramsStep(Located):
    """The telegrams of a gateway since the start or the last such step, in order, no more, no less.

    `of_sequence` takes them from a sequence of the catalogue, such as `manual_example`.
    """

    telegrams: tuple[ExpectedTelegram, ...] | None = None
    of_sequence: SnakeName | None = None
    gateway: Text

    def problems(self) -> Iterable[Diagnostic]:
        """FB8002: no telegrams or two sets of them."""
        if (self.telegrams is None) == (self.of_sequence is None):
            yield Diagnostic(
                "FB8002", "give either telegrams or of_sequence", self.span, "not both, not neither"
            )


_KEYS = {
    "set": "set_step",
    "wait": "wait_step",
    "expect": "expect_step",
    "inject": "inject_step",
    "clear": "clear_step",
    "telegrams": "telegrams_step",
    "of_sequence": "telegrams_step",
}


def _kind(step: Any) -> str | None:
    for key, kind in _KEYS.items():
        if isinstance(step, dict) and key in step:
            return kind
    return None


Step = Annotated[
    Annotated[SetStep, Tag("set_step")]
    | Annotated[WaitStep, Tag("wait_step")]
    | Annotated[ExpectStep, Tag("expect_step")]
    | Annotated[InjectStep, Tag("inject_step")]
    | Annotated[ClearStep, Tag("clear_step")]
    | Annotated[TelegramsStep, Tag("telegrams_step")],
    Discriminator(_kind),
]


class LoadSetup(Located):
    """The driven machine: torque in percent of the rated torque, see `harness.drives.load`."""

    torque: float = 0.0
    shape: Literal["constant", "linear", "quadratic"] = "constant"
    at_hz: float = 50.0
    inertia: float = 0.0

    def load(self) -> Load:
        """The same as the drive takes it."""
        return Load(self.torque, LoadShape(self.shape), self.at_hz, self.inertia)


class DriveSetup(Located):
    """How a drive is set before the start: its load, its parameters by name or ComNo."""

    load: LoadSetup | None = None
    parameters: dict[str, float] = Field(default_factory=dict)
    reply_time: DurationNs | None = None

    def conditions(self) -> DriveConditions:
        """The same as the plant takes it."""
        return DriveConditions(
            load=self.load.load() if self.load is not None else None,
            parameters=self.parameters,
            reply_time_ns=self.reply_time,
        )


class Variation(Located):
    """Changes to the plant file for this scenario: another dialect, layout, access way."""

    dialect: Literal["tia", "iec"] | None = None
    plc: Literal["s7-1200", "s7-1500", "s7-300", "s7-400", "iec"] | None = None
    layout: Text | None = None
    access: Literal["per_identifier", "dpxx_dat", "process_image"] | None = None
    options: dict[SnakeName, ScalarValue] = Field(default_factory=dict)


class Scenario(Located):
    """One scenario file."""

    version: Literal[1]
    title: Text
    plant: Text
    seed: Count = 0
    engine: Literal["compiled", "reference"] = "compiled"
    variations: tuple[Variation, ...] = ()
    drives: dict[SnakeName, DriveSetup] = Field(default_factory=dict)
    tags: tuple[SnakeName, ...] = ()
    facts: tuple[Text, ...] = ()
    steps: tuple[Step, ...] = Field(min_length=1)
