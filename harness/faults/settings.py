"""Settings of a fault from a scenario file to the fault's own model."""

from collections.abc import Mapping
from typing import Any

from pydantic import ValidationError
from pydantic_core import ErrorDetails

from fbgen.diagnostics import Diagnostic, DiagnosticError
from fbgen.nearest import nearest
from fbgen.source import Span
from harness.faults.fault import FaultSettings, FaultType

_LIMITS = {
    "greater_than": "more than {gt}",
    "greater_than_equal": "at least {ge}",
    "less_than": "less than {lt}",
    "less_than_equal": "at most {le}",
}


def fault_settings(
    kind: FaultType[Any],
    values: Mapping[str, bool | int | float | str],
    places: Mapping[str, Span | None],
) -> FaultSettings:
    """The settings of a fault. `places` has the place of each value.

    Raises DiagnosticError FB8004 with everything that is unknown or wrong.
    """
    try:
        return kind.settings.model_validate(dict(values))
    except ValidationError as wrong:
        found = [_explain(kind, details, places) for details in wrong.errors()]
    raise DiagnosticError(found)


def _explain(
    kind: FaultType[Any], details: ErrorDetails, places: Mapping[str, Span | None]
) -> Diagnostic:
    name = str(details["loc"][0])
    if details["type"] == "extra_forbidden":
        known = tuple(kind.settings.model_fields)
        message = f"the fault '{kind.name}' has no setting '{name}'"
        advice = nearest(name, known) if known else "it has none: leave out settings"
        return Diagnostic("FB8004", message, places.get(name), advice)
    return Diagnostic(
        "FB8004",
        f"the setting '{name}' of the fault '{kind.name}' is never {details['input']!r}",
        places.get(name),
        f"it is {_expected(details)}",
    )


def _expected(details: ErrorDetails) -> str:
    context = details.get("ctx", {})
    if (limit := _LIMITS.get(details["type"])) is not None:
        return limit.format(**context)
    if details["type"] == "value_error":
        return "a time that is not 0, with its unit, such as 500 ms or 2 s"
    if details["type"] == "literal_error":
        return str(context["expected"])
    if details["type"] == "string_pattern_mismatch":
        return "a RET_VAL of an error, such as 16#80B0"
    if details["type"].startswith("string"):
        return "a text"
    return "a whole number" if details["type"].startswith("int") else "a number"
