"""What an instruction with several outputs works with: input values and the types around them."""

from collections.abc import Mapping

from fbgen.dataclass import dataclass
from fbgen.lang.types import Type
from fbgen.source import Span
from harness.engine.interface import Value


@dataclass(frozen=True, slots=True)
class Operands:
    """The inputs by name, and the types of inputs and outputs, of the places for outputs."""

    values: Mapping[str, Value]
    kinds: Mapping[str, Type]
    span: Span

    def whole(self, name: str, default: int = 0) -> int:
        """An input that is a whole number."""
        value = self.values.get(name, default)
        assert isinstance(value, int)
        return value

    def real(self, name: str) -> float:
        """An input that is a number."""
        value = self.values[name]
        assert isinstance(value, int | float)
        return float(value)

    def flag(self, name: str) -> bool:
        """An input of type BOOL; FALSE if it is left out."""
        return self.values.get(name, False) is True

    def text(self, name: str) -> str:
        """An input that is a text."""
        value = self.values[name]
        assert isinstance(value, str)
        return value
