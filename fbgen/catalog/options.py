"""Choices that the documents leave open: what can be chosen, and the documented default."""

from collections.abc import Iterable
from typing import Annotated, Literal

from pydantic import BeforeValidator, Field, StrictBool, StrictInt

from fbgen.catalog.scalars import SnakeName, Text, Whole
from fbgen.catalog.sourced import Sourced
from fbgen.diagnostics import Diagnostic, DiagnosticError
from fbgen.nearest import nearest


def _single(value: object) -> object:
    if isinstance(value, (bool, int, str)):
        return value
    raise ValueError("the value of an option is true, false, a whole number or a text")


OptionValue = Annotated[StrictBool | StrictInt | str, BeforeValidator(_single)]
OptionType = Literal["flag", "integer", "choice", "text"]


class Option(Sourced):
    """One choice of a gateway or a drive.

    `applies_to` says who takes notice: the generated blocks (`plc`), the simulated device
    (`device`), or both. An integer lies between `minimum` and `maximum` (in `unit`),
    in steps of `step` from the minimum on.
    """

    id: SnakeName
    title: Text
    type: OptionType
    default: OptionValue
    applies_to: Literal["plc", "device", "both"]
    choices: dict[str, Text] = Field(default_factory=dict)
    unit: str = ""
    minimum: Whole | None = None
    maximum: Whole | None = None
    step: Whole = 1
    remark: Text | None = None

    def check(self, value: OptionValue) -> OptionValue:
        """The value if it may be chosen. Raises DiagnosticError FB1109 if not."""
        if found := tuple(self._wrong(value)):
            raise DiagnosticError(found)
        return value

    def problems(self) -> Iterable[Diagnostic]:
        """FB1103 no source; FB1109 a default that may not be chosen."""
        yield from super().problems()
        for found in self._wrong(self.default):
            yield Diagnostic(found.code, found.message, self.span_of("default"), found.help)

    def _wrong(self, value: OptionValue) -> Iterable[Diagnostic]:
        shown = str(value).lower() if isinstance(value, bool) else f"'{value}'"
        if self.type == "flag" and not isinstance(value, bool):
            message = f"{shown} is no value of the option '{self.id}'"
            yield Diagnostic("FB1109", message, help="write true or false")
        elif self.type == "text" and not isinstance(value, str):
            message = f"{shown} is no value of the option '{self.id}'"
            yield Diagnostic("FB1109", message, help="write a text, in quotes")
        elif self.type == "choice" and value not in self.choices:
            message = f"{shown} is no choice of the option '{self.id}'"
            yield Diagnostic("FB1109", message, help=nearest(str(value), self.choices))
        elif self.type == "integer":
            low = self.minimum if self.minimum is not None else 0
            high = self.maximum if self.maximum is not None else 0xFFFF
            whole = isinstance(value, int) and not isinstance(value, bool)
            if not whole or value not in range(low, high + 1, max(1, self.step)):
                message = f"{shown} is no value of the option '{self.id}'"
                unit = f" {self.unit}" if self.unit else ""
                steps = f" in steps of {self.step}" if self.step > 1 else ""
                yield Diagnostic("FB1109", message, help=f"write {low} to {high}{unit}{steps}")
