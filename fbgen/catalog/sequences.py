"""Command sequences: what a PLC sends to one inverter, step by step.

ComNos and bits are named as in the drive series for which the sequence is made;
`catalog/references.py` checks the names, `catalog/steps.py` has the steps.
"""

import re
from collections.abc import Iterable
from typing import Annotated, Literal

from pydantic import Field

from fbgen.catalog.located import Located
from fbgen.catalog.named import no_duplicates
from fbgen.catalog.scalars import Count, EntryId, SnakeName, Text
from fbgen.catalog.sourced import Sourced
from fbgen.catalog.steps import END, BranchStep, DelayStep, ReadStep, RepeatStep, Step, WriteStep
from fbgen.diagnostics import Diagnostic
from fbgen.nearest import nearest

ValueType = Literal["BOOL", "INT", "WORD", "REAL", "TIME"]
_NUMBERS: tuple[ValueType, ...] = ("INT", "WORD", "REAL")
"""What the word of a telegram can be."""
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
            elif isinstance(step, BranchStep):
                used.add(step.branch)
                yield from self._branch(step)
        yield from self._labels()
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

    def _branch(self, step: BranchStep) -> Iterable[Diagnostic]:
        items: tuple[Parameter | Result, ...] = (*self.parameters, *self.results)
        interface = {item.name: item.type for item in items}
        if step.branch not in interface:
            message = f"there is no parameter or result '{step.branch}'"
            advice = nearest(step.branch, interface)
            yield Diagnostic("FB1107", message, step.span_of("branch"), advice)
        elif interface[step.branch] == "TIME":
            message = f"'{step.branch}' is a TIME, which a branch does not compare"
            yield Diagnostic("FB1107", message, step.span_of("branch"))
        elif step.when.bits:
            message = "a branch compares numbers, not bits"
            advice = "wait for the bits of a ComNo, or read the word and compare it as a number"
            yield Diagnostic("FB1107", message, step.when.span_of("bits"), advice)

    def _labels(self) -> Iterable[Diagnostic]:
        """FB1102 a label twice; FB1107 no such label, or one that a repetition has not passed."""
        labels = {step.label: at for at, step in enumerate(self.steps) if step.label is not None}
        labelled = tuple(step for step in self.steps if step.label is not None)
        yield from no_duplicates(labelled, "label", lambda item: item.label or "", "label")
        for at, step in enumerate(self.steps):
            if step.label == END:
                message = f"'{END}' is behind the last step, no step can be labelled so"
                yield Diagnostic("FB1107", message, step.span_of("label"))
            if isinstance(step, BranchStep) and step.to not in (END, *labels):
                message = f"there is no label '{step.to}'"
                advice = nearest(step.to, [END, *labels])
                yield Diagnostic("FB1107", message, step.span_of("to"), advice)
            if isinstance(step, RepeatStep) and labels.get(step.repeat, at) >= at:
                message = f"there is no label '{step.repeat}' in front of this step"
                behind = "a repetition goes back: put it behind the step with the label"
                before = [label for label, place in labels.items() if place < at]
                advice = behind if step.repeat in labels else nearest(step.repeat, before)
                yield Diagnostic("FB1107", message, step.span_of("repeat"), advice)

    def position(self, label: str) -> int:
        """The number of the step with a label, from 1; `end` is one behind the last."""
        if label == END:
            return len(self.steps) + 1
        return next(at for at, step in enumerate(self.steps, start=1) if step.label == label)

    def _result(self, step: ReadStep) -> Iterable[Diagnostic]:
        types = {result.name: result.type for result in self.results}
        if step.into not in types:
            yield Diagnostic(
                "FB1107",
                f"there is no result '{step.into}'",
                step.span_of("into"),
                nearest(step.into, types),
            )
        elif types[step.into] not in _NUMBERS:
            yield Diagnostic(
                "FB1107",
                f"the result '{step.into}' is of type {types[step.into]}, "
                f"a read gives {' or '.join(_NUMBERS)}",
                step.span_of("into"),
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
            yield step.parameter, _NUMBERS, "parameter"
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
