"""Single values of scenario files: true, false, a number or a text."""

from math import isfinite
from typing import Annotated, TypeAlias

from pydantic import BeforeValidator

from fbgen.catalog.located import describe

Scalar: TypeAlias = bool | int | float | str


def _scalar(value: object) -> object:
    """One finding for a wrong value, where a union would give one for each of its members."""
    if not isinstance(value, bool | int | float | str):
        raise ValueError(f"found {describe(value)}, expected true, false, a number or a text")
    if isinstance(value, float) and not isfinite(value):
        raise ValueError(f"found {describe(value)}, which is no finite number")
    return value


ScalarValue = Annotated[Scalar, BeforeValidator(_scalar)]
"""A value as it stands in the file. What it means follows from the path that it goes with."""
