"""Command sequences: what a PLC sends to one inverter, step by step.

A step is a mapping with one of the keys `write`, `read` or `delay`. ComNos and bits are named as
in the drive series for which the sequence is made; `catalog/references.py` checks the names.
"""

import re
from collections.abc import Iterable
from typing import Annotated, Any, Literal

from pydantic import Discriminator, Field, Tag

from fbgen.catalog.located import Located
from fbgen.catalog.named import no_duplicates
from fbgen.catalog.scalars import Count, EntryId, HexWord, SnakeName, Text
from fbgen.catalog.sourced import Sourced
from fbgen.diagnostics import Diagnostic
from fbgen.nearest import nearest

ValueType = Literal["BOOL", "INT", "WORD", "REAL", "TIME"]
_DEFAULTS: dict[ValueType, str] = {
    "BOOL": r"true|false",
    "INT": r"-?[0-9]{1,5}",
    "WORD": r"16#[0-9A-F]{4}",
    "REAL": r"-?[0-9]{1,9}\.[0-9]{1,9}",
    "TIME": r"T#[0-9]{1,9}(ms|s)",
}
_DEFAULT_EXAMPLES: dict[ValueType, str] = {
    "BOOL": "false",
    "INT": "0",
    "WORD": "16#0000",
    "REAL": "0.0",
    "TIME": "T#500ms",
}
DriveTime = Literal["reply_max", "boot", "reset_silence"]


class Parameter(Located):
    """An input of a sequence. `scaled_by` names the ComNo whose unit and resolution apply.

    `default` is a text in the spelling of the type: `false`, `0`, `16#0000`, `0.0`, `T#500ms`.
    """

    name: SnakeName
    type: ValueType
    title: Text
    unit: str = ""
    scaled_by: SnakeName | None = None
    default: Text | None = None

    def problems(self) -> Iterable[Diagnostic]:
        """FB1107: a scale without a number to scale, a default that is none of the type."""
        yield from _scale(self, self.name, self.type, self.scaled_by)
        if self.default is not None and not re.fullmatch(_DEFAULTS[self.type], self.default):
            yield Diagnostic(
                "FB1107",
                f"'{self.default}' is no {self.type}",
                self.span_of("default"),
                f"write it as {_DEFAULT_EXAMPLES[self.type]}",
            )


class Result(Located):
    """An output of a sequence. `scaled_by` names the ComNo whose unit and resolution apply."""

    name: SnakeName
    type: ValueType
    title: Text
    unit: str = ""
    scaled_by: SnakeName | None = None

    def problems(self) -> Iterable[Diagnostic]:
        """FB1107: a scale without a number to scale."""
        return _scale(self, self.name, self.type, self.scaled_by)


class WriteStep(Located):
    """Write a ComNo. The value comes from exactly one of

    * `bits`: names of bits that are 1, with `bits_from`: bits that follow BOOL parameters;
    * `parameter`: the value of a parameter;
    * `literal`: a word as it is, with a `note` why it is not built from bits.

    `reply: none` says that the inverter does not answer this telegram. `memory` chooses between
    the RAM (command P) and RAM with EEPROM (command W).
    """

    write: Text
    title: Text | None = None
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


class ReadStep(Located):
    """Read a ComNo `into` a result."""

    read: Text
    title: Text | None = None
    into: SnakeName
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


class DelayStep(Located):
    """Wait."""

    delay: Delay
    title: Text | None = None


def _kind(step: Any) -> str | None:
    for key in ("write", "read", "delay"):
        if (isinstance(step, dict) and key in step) or hasattr(step, key):
            return f"{key}_step"
    return None


Step = Annotated[
    Annotated[WriteStep, Tag("write_step")]
    | Annotated[ReadStep, Tag("read_step")]
    | Annotated[DelayStep, Tag("delay_step")],
    Discriminator(_kind),
]


class Telegram(Sourced):
    """A telegram as a document prints it, cyclic data in both directions; `xx` means any byte."""

    step: Annotated[Count, Field(ge=1)]
    output: Text
    input: Text
    comment: Text | None = None

    @property
    def output_bytes(self) -> tuple[int | None, ...]:
        """The bytes from the PLC, None where any byte will do."""
        return _bytes(self.output)

    @property
    def input_bytes(self) -> tuple[int | None, ...]:
        """The bytes to the PLC, None where any byte will do."""
        return _bytes(self.input)

    def problems(self) -> Iterable[Diagnostic]:
        """FB1103 no source; FB1107 bytes that cannot be read."""
        yield from super().problems()
        for name in ("output", "input"):
            try:
                _bytes(getattr(self, name))
            except ValueError:
                yield Diagnostic(
                    "FB1107",
                    f"'{getattr(self, name)}' is no row of bytes",
                    self.span_of(name),
                    "write two hexadecimal digits a byte, or xx for any byte",
                )


class Sequence(Sourced):
    """A sequence for drives of the named `series`.

    `title`, `description` and `does_not_protect` become the header of the generated block.
    `reply_timeout_ms` is the time limit of each telegram that has none of its own.
    """

    version: Literal[1]
    id: SnakeName
    title: Text
    description: Text
    does_not_protect: Text
    series: tuple[EntryId, ...] = Field(min_length=1)
    parameters: tuple[Parameter, ...] = ()
    results: tuple[Result, ...] = ()
    reply_timeout_ms: Annotated[Count, Field(ge=1, le=60_000)] = 500
    steps: tuple[Step, ...] = Field(min_length=1)
    telegrams: tuple[Telegram, ...] = ()

    def problems(self) -> Iterable[Diagnostic]:
        """FB1102 a name twice; FB1103 no source; FB1107 parameters and results used wrongly."""
        yield from super().problems()
        interface: tuple[Parameter | Result, ...] = (*self.parameters, *self.results)
        yield from no_duplicates(interface, "name", lambda item: item.name, "parameter or result")
        types = {item.name: item.type for item in self.parameters}
        used: set[str] = set()
        filled: set[str] = set()
        for step in self.steps:
            for name, wanted, field in _parameters(step):
                used.add(name)
                yield from _fits(step, field, name, types, wanted)
            if isinstance(step, ReadStep):
                filled.add(step.into)
                yield from self._result(step)
        for parameter in self.parameters:
            if parameter.name not in used:
                yield Diagnostic(
                    "FB1107", f"no step uses the parameter '{parameter.name}'", parameter.span
                )
        for result in self.results:
            if result.name not in filled:
                yield Diagnostic("FB1107", f"no step fills the result '{result.name}'", result.span)
        for telegram in self.telegrams:
            if telegram.step > len(self.steps):
                yield Diagnostic(
                    "FB1107", f"there is no step {telegram.step}", telegram.span_of("step")
                )

    def _result(self, step: ReadStep) -> Iterable[Diagnostic]:
        names = [result.name for result in self.results]
        if step.into not in names:
            yield Diagnostic(
                "FB1107",
                f"there is no result '{step.into}'",
                step.span_of("into"),
                nearest(step.into, names),
            )


def _scale(
    owner: Parameter | Result, name: str, kind: ValueType, scaled_by: str | None
) -> Iterable[Diagnostic]:
    if scaled_by is not None and kind != "REAL":
        yield Diagnostic(
            "FB1107",
            f"'{name}' is scaled by '{scaled_by}' but is of type {kind}",
            owner.span_of("type"),
            "scaled values are REAL; without scaled_by the raw word is passed on",
        )


def _parameters(step: Step) -> Iterable[tuple[str, tuple[ValueType, ...], str]]:
    """Names of the parameters that a step uses, the types that fit, and the field that says so."""
    if isinstance(step, WriteStep):
        if step.parameter is not None:
            yield step.parameter, ("INT", "WORD", "REAL"), "parameter"
        for name in step.bits_from.values():
            yield name, ("BOOL",), "bits_from"
    elif isinstance(step, DelayStep) and step.delay.parameter is not None:
        yield step.delay.parameter, ("TIME",), "delay"


def _fits(
    step: Step, field: str, name: str, types: dict[str, ValueType], wanted: tuple[ValueType, ...]
) -> Iterable[Diagnostic]:
    if name not in types:
        yield Diagnostic(
            "FB1107", f"there is no parameter '{name}'", step.span_of(field), nearest(name, types)
        )
    elif types[name] not in wanted:
        yield Diagnostic(
            "FB1107",
            f"the parameter '{name}' is of type {types[name]}, "
            f"this place takes {' or '.join(wanted)}",
            step.span_of(field),
        )


def _bytes(text: str) -> tuple[int | None, ...]:
    if any(len(part) != 2 for part in text.split()):
        raise ValueError(text)
    return tuple(None if part == "xx" else int(part, 16) for part in text.split())
