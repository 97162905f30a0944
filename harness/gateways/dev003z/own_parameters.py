"""The option's own parameters, c001 to c203: set at the panel of the inverter, or as cells."""

from collections.abc import Mapping

from fbgen.catalog.devicenet_gateways import AdapterParameter
from fbgen.diagnostics import Diagnostic, DiagnosticError
from fbgen.nearest import nearest
from fbgen.wire.toshiba import ErrorCode


class OwnParameters:
    """Counts by name and by number. They outlive a restart."""

    __slots__ = ("_names", "_parameters", "_values")

    def __init__(
        self, parameters: tuple[AdapterParameter, ...], delivered: Mapping[str, int]
    ) -> None:
        """Raises DiagnosticError FB7101 for what it does not take."""
        self._parameters = {item.name: item for item in parameters}
        self._names = {item.number: item.name for item in parameters}
        self._values = {item.name: item.default for item in parameters}
        found = []
        for name, value in delivered.items():
            known = self._parameters.get(name)
            if known is None:
                help_ = nearest(name, self._parameters)
                found.append(
                    Diagnostic("FB7101", f"the option has no parameter '{name}'", None, help_)
                )
            elif not known.minimum <= value <= known.maximum:
                message = f"the option does not take {value} for {known.display} ({name})"
                help_ = f"the range is {known.minimum} to {known.maximum}"
                found.append(Diagnostic("FB7101", message, None, help_))
            else:
                self._values[name] = value
        if found:
            raise DiagnosticError(found)

    def __getitem__(self, name: str) -> int:
        return self._values[name]

    def set(self, name: str, value: int) -> None:
        """Set at the panel of the inverter; `value` is one that it takes."""
        self._values[name] = value

    def reset(self) -> None:
        """As delivered from the factory."""
        self._values = {name: item.default for name, item in self._parameters.items()}

    def read(self, number: int) -> int | None:
        """The count of a number, None if it is none of these."""
        name = self._names.get(number)
        return None if name is None else self._values[name]

    def write(self, number: int, word: int) -> ErrorCode | None:
        """Take a count by its number, which must be one; why it is refused, or None."""
        known = self._parameters[self._names[number]]
        if not known.minimum <= word <= known.maximum:
            return ErrorCode.DATA
        self._values[known.name] = word
        return None
