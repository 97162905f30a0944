"""What a scenario file demands of values: a value behind its path, or a range in more words."""

from collections.abc import Iterable
from typing import Annotated, Any

from pydantic import Discriminator, Field, Tag

from fbgen.catalog import Located
from fbgen.catalog.scalars import Real, SnakeName, Text
from fbgen.diagnostics import Diagnostic
from harness.scenario.scalars import ScalarValue


class Range(Located):
    """What a value must be; everything that is given must hold."""

    equals: ScalarValue | None = Field(default=None, description="This value")
    tolerance: Annotated[Real, Field(ge=0)] = Field(
        default=0.0, description="How far off `equals` a number may be"
    )
    min: ScalarValue | None = Field(default=None, description="At least this much")
    max: ScalarValue | None = Field(default=None, description="At most this much")
    differs_from: ScalarValue | None = Field(default=None, description="Any value but this one")
    bits: dict[SnakeName, ScalarValue] | None = Field(
        default=None,
        description="Bits or fields of a word by the catalogue's names, each with its value",
    )
    word: Text | None = Field(
        default=None,
        description="The word that names the bits, such as vf-s11.status; needed only where the "
        "path does not say it",
    )

    def problems(self) -> Iterable[Diagnostic]:
        """FB8002: nothing is demanded, or what is demanded contradicts itself."""
        demands = (self.equals, self.min, self.max, self.differs_from, self.bits or None)
        if all(item is None for item in demands):
            yield Diagnostic(
                "FB8002",
                "nothing is demanded of the value",
                self.span,
                "give equals, min, max, differs_from or bits",
            )
        if self.word is not None and self.bits is None:
            yield Diagnostic(
                "FB8002",
                "a word is named and none of its bits",
                self.span_of("word"),
                "write bits as well, such as bits: {status_changed: 1}",
            )
        if self.tolerance and not _is_number(self.equals):
            yield Diagnostic(
                "FB8002",
                "a tolerance needs a number that the value may be off",
                self.span_of("tolerance"),
                "write equals: with a number, or min and max instead",
            )


def _is_number(value: object) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)


def _kind_of_expectation(value: Any) -> str:
    return "a range" if isinstance(value, dict | Range) else "a value"


Expectation = Annotated[
    Annotated[ScalarValue, Tag("a value")] | Annotated[Range, Tag("a range")],
    Discriminator(_kind_of_expectation),
]
"""A value, or what it must be in more words."""

Conditions = Annotated[dict[str, Expectation], Field(min_length=1)]
"""Paths with what each must be; all of it at the same instant."""
