"""The steps of a command sequence: write, read, check, check_settings, delay, wait, branch, repeat.

A step is a mapping with one of these keys, and may have a `label` to which others go. ComNos and
bits are named as in the drive series for which the sequence is made.
"""

from collections.abc import Iterable, Mapping
from math import inf
from typing import Annotated, Any, Literal

from pydantic import Discriminator, Field, Tag

from fbgen.catalog.located import Located
from fbgen.catalog.scalars import Count, HexWord, Real, SnakeName, Text
from fbgen.diagnostics import Diagnostic

DriveTime = Literal["reply_max", "boot", "reset_silence"]
END = "end"
"""Where a branch goes to be done."""


class LabelledStep(Located):
    """What every step may have: a title, and a label for steps that go to it."""

    title: Text | None = None
    label: SnakeName | None = None


class WriteStep(LabelledStep):
    """Write a ComNo. The value comes from exactly one of

    * `bits`: names of bits that are 1, with `bits_from`: bits that follow BOOL parameters;
    * `parameter`: the value of a parameter;
    * `literal`: a word as it is, with a `note` why it is not built from bits.

    `reply: none` says that the inverter does not answer this telegram. `memory` chooses between
    the RAM (command P) and RAM with EEPROM (command W).
    """

    write: Text
    bits: tuple[SnakeName, ...] | None = None
    bits_from: dict[SnakeName, SnakeName] = Field(default_factory=dict)
    parameter: SnakeName | None = None
    literal: HexWord | None = None
    note: Text | None = None
    memory: Literal["ram", "eeprom"] = "ram"
    reply: Literal["expected", "none"] = "expected"
    timeout_ms: Annotated[Count, Field(ge=1, le=60_000)] | None = None

    def problems(self) -> Iterable[Diagnostic]:
        """FB1107: no value, several values, or a literal without a note."""
        given = [
            name for name in ("bits", "parameter", "literal") if getattr(self, name) is not None
        ]
        if len(given) != 1:
            yield Diagnostic(
                "FB1107",
                "a write step has " + (" and ".join(given) or "no value"),
                self.span_of(given[1]) if given else self.span_of("write"),
                "give exactly one of bits, parameter and literal",
            )
        if self.bits_from and self.bits is None:
            yield Diagnostic(
                "FB1107",
                "bits_from adds to bits, which is missing",
                self.span_of("bits_from"),
                "add bits: [] or the names of the bits that are always 1",
            )
        if self.literal is not None and self.note is None:
            yield Diagnostic(
                "FB1107",
                f"the literal word {self.literal:04X} has no note",
                self.span_of("literal"),
                "say in note: why the word is not built from named bits",
            )


class ReadStep(LabelledStep):
    """Read a ComNo `into` a result."""

    read: Text
    into: SnakeName
    timeout_ms: Annotated[Count, Field(ge=1, le=60_000)] | None = None


class CheckStep(LabelledStep):
    """Read a ComNo and note it if it is not as it is to be; the sequence goes on.

    It is to be `equals`, in its unit, or without that what the parameter sheet of the drive says.
    """

    check: Text
    equals: Real | None = None
    timeout_ms: Annotated[Count, Field(ge=1, le=60_000)] | None = None


class SettingsStep(LabelledStep):
    """Check parameters one after the other, as many as there are on the sheets of the drives.

    `check_settings`: everything that the parameter sheets of the plant's drives give a value for.
    Behind a gateway those are the `settings` of the series; on a serial line rate, parity, protocol
    and time-out are those of the line. What the sheets do not have in common is left out.
    """

    check_settings: Literal["all"]
    timeout_ms: Annotated[Count, Field(ge=1, le=60_000)] | None = None


class Delay(Located):
    """A time: fixed in milliseconds, one that the drive's entry knows, or a TIME parameter."""

    ms: Annotated[Count, Field(ge=1, le=3_600_000)] | None = None
    drive_time: DriveTime | None = None
    parameter: SnakeName | None = None

    def problems(self) -> Iterable[Diagnostic]:
        """FB1107: no time or several."""
        fields = ("ms", "drive_time", "parameter")
        given = [name for name in fields if getattr(self, name) is not None]
        if len(given) != 1:
            yield Diagnostic(
                "FB1107",
                "a delay has " + (" and ".join(given) or "no time"),
                self.span_of(given[1]) if given else self.span,
                "give exactly one of ms, drive_time and parameter",
            )


class DelayStep(LabelledStep):
    """Wait."""

    delay: Delay


class Condition(Located):
    """What a value must be: a number, at least or at most one, or bits of a word at their values.

    Numbers are in the unit of the ComNo or of the result; BOOL counts as 0 and 1.
    """

    equals: Real | None = None
    at_least: Real | None = None
    at_most: Real | None = None
    bits: dict[SnakeName, Annotated[Count, Field(le=1)]] = Field(default_factory=dict)

    @property
    def numbers(self) -> Mapping[str, float]:
        """What is compared with numbers: `equals`, `at_least`, `at_most`."""
        given = {name: getattr(self, name) for name in ("equals", "at_least", "at_most")}
        return {name: value for name, value in given.items() if value is not None}

    def problems(self) -> Iterable[Diagnostic]:
        """FB1107: nothing to compare, numbers and bits together, numbers that nothing meets."""
        if bool(self.numbers) == bool(self.bits):
            yield Diagnostic(
                "FB1107",
                "a condition has numbers and bits" if self.bits else "a condition asks for nothing",
                self.span,
                "give equals, at_least, at_most or both of these, or bits: {running: 1}",
            )
        least, most = (
            max([-inf, *(v for v in (self.equals, self.at_least) if v is not None)]),
            min([inf, *(v for v in (self.equals, self.at_most) if v is not None)]),
        )
        if least > most:
            yield Diagnostic(
                "FB1107",
                f"nothing is at least {least:g} and at most {most:g}",
                self.span,
                "exchange the two numbers, or take one of them out",
            )


class WaitStep(LabelledStep):
    """Read a ComNo every `every_ms` until the condition holds; after `limit_ms` it is an error."""

    wait: Text
    until: Condition
    every_ms: Annotated[Count, Field(ge=1, le=3_600_000)] = 100
    limit_ms: Annotated[Count, Field(ge=1, le=3_600_000)]
    timeout_ms: Annotated[Count, Field(ge=1, le=60_000)] | None = None


class BranchStep(LabelledStep):
    """Go on at the label `to` if a result or parameter is as `when` says; `end` is done."""

    branch: SnakeName
    when: Condition
    to: SnakeName


class RepeatStep(LabelledStep):
    """Go back to a label until what lies between has run `times` times."""

    repeat: SnakeName
    times: Annotated[Count, Field(ge=2, le=1000)]


_KINDS = ("write", "read", "check", "check_settings", "delay", "wait", "branch", "repeat")


def _kind(step: Any) -> str | None:
    for key in _KINDS:
        if (isinstance(step, dict) and key in step) or hasattr(step, key):
            return f"{key}_step"
    return None


Step = Annotated[
    Annotated[WriteStep, Tag("write_step")]
    | Annotated[ReadStep, Tag("read_step")]
    | Annotated[CheckStep, Tag("check_step")]
    | Annotated[SettingsStep, Tag("check_settings_step")]
    | Annotated[DelayStep, Tag("delay_step")]
    | Annotated[WaitStep, Tag("wait_step")]
    | Annotated[BranchStep, Tag("branch_step")]
    | Annotated[RepeatStep, Tag("repeat_step")],
    Discriminator(_kind),
]
