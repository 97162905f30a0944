"""Settings of a fault from a scenario file to the fault's own model."""

from collections.abc import Mapping

from pydantic import ValidationError

from fbgen.diagnostics import Diagnostic, DiagnosticError
from fbgen.nearest import nearest
from fbgen.source import Span
from harness.faults.fault import FaultSettings, FaultType


def fault_settings(
    kind: FaultType, values: Mapping[str, bool | int | float | str], span: Span | None
) -> FaultSettings:
    """The settings of a fault. Raises DiagnosticError FB8004 for unknown or wrong ones."""
    known = tuple(kind.settings.model_fields)
    try:
        return kind.settings.model_validate(dict(values))
    except ValidationError as wrong:
        found = [
            Diagnostic(
                "FB8004",
                f"the setting '{details['loc'][0]}' of the fault '{kind.name}' is wrong: "
                f"{details['msg'].lower()}",
                span,
                nearest(str(details["loc"][0]), known) if known else "it has no settings",
            )
            for details in wrong.errors()
        ]
    raise DiagnosticError(found)
