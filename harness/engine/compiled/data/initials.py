"""Python source that makes fresh values: defaults of types and initial values of declarations."""

from fbgen.lang.checked import VariableKind
from fbgen.lang.types import (
    DATE_AND_TIME,
    ArrayInitial,
    ArrayType,
    BlockType,
    Elementary,
    Family,
    Initial,
    OpenArrayType,
    ReferenceType,
    Scalar,
    StringType,
    StructInitial,
    StructType,
    Type,
)
from harness.engine.compiled.data.model import Model, Part, is_scalar
from harness.engine.compiled.library.dates import START_ON_S7


def default_scalar(kind: Type, dialect: str) -> Scalar:
    """What a variable of an elementary type or a text starts with when nobody says it."""
    s7 = dialect in ("tia", "step7")
    if isinstance(kind, StringType):
        return ""
    if isinstance(kind, Elementary):
        if kind.family is Family.BOOL:
            return False
        if kind.family is Family.REAL:
            return 0.0
        if kind.family is Family.CHAR:
            return " " if s7 else "\0"
        if kind == DATE_AND_TIME:
            return START_ON_S7
    return 0


def scalar_text(value: Scalar, kind: Type) -> str:
    """The Python text of a value; bit strings in hexadecimal."""
    if isinstance(value, float):
        if value - value != 0:
            return "_nan" if value != value else "_inf" if value > 0 else "-_inf"  # noqa: PLR0124
        return repr(value)
    if isinstance(value, str):
        return ascii(value)
    if isinstance(value, bool):
        return repr(value)
    if isinstance(kind, Elementary):
        if kind.family is Family.REAL:
            return repr(float(value))
        if kind.family is Family.BOOL:
            return repr(bool(value))
        if kind.family is Family.BITS and value > 9:
            return hex(value)
    return str(value)


class Initializer:
    """Writes the statements that give variables their first values."""

    __slots__ = ("_dialect", "_model")

    def __init__(self, model: Model) -> None:
        self._model = model
        self._dialect = model.program.dialect

    def fresh(self, kind: Type) -> str:
        """An expression for a new value with the defaults of the type."""
        if isinstance(kind, ArrayType):
            if is_scalar(kind.element):
                return f"[{self.fresh(kind.element)}] * {kind.count}"
            return f"[{self.fresh(kind.element)} for _ in range({kind.count})]"
        if isinstance(kind, ReferenceType):
            return "None"
        if isinstance(kind, OpenArrayType):
            return f"_OpenArray([], ((0, -1),) * {kind.dimensions})"
        if isinstance(kind, StructType | BlockType):
            return f"{self._model.record_of(kind).class_name}()"
        return scalar_text(default_scalar(kind, self._dialect), kind)

    def statements(self, target: str, kind: Type, initial: Initial | None) -> list[str]:
        """Statements that give `target` a new value with its initial values."""
        if initial is None:
            return [f"{target} = {self.fresh(kind)}"]
        if isinstance(initial, StructInitial):
            return [f"{target} = {self.fresh(kind)}", *self.changes(target, kind, initial)]
        if isinstance(initial, ArrayInitial):
            return self._array(target, kind, initial)
        return [f"{target} = {scalar_text(initial, kind)}"]

    def _array(self, target: str, kind: Type, initial: ArrayInitial) -> list[str]:
        assert isinstance(kind, ArrayType)
        if not is_scalar(kind.element):
            lines = [f"{target} = {self.fresh(kind)}"]
            for position, item in enumerate(initial.items):
                if item is not None:
                    element = f"{target}[{position}]"
                    if isinstance(item, StructInitial):
                        lines += self.changes(element, kind.element, item)
                    else:
                        lines += self.statements(element, kind.element, item)
            return lines
        default = self.fresh(kind.element)
        texts = [
            default
            if isinstance(item, ArrayInitial | StructInitial) or item is None
            else scalar_text(item, kind.element)
            for item in initial.items
        ]
        if len(set(texts)) == 1:
            return [f"{target} = [{texts[0]}] * {len(texts)}"]
        return [f"{target} = [{', '.join(texts)}]"]

    def changes(self, target: str, kind: Type, initial: StructInitial) -> list[str]:
        """Statements that give the named parts of a new value their initial values."""
        assert isinstance(kind, StructType | BlockType)
        record = self._model.record_of(kind)
        lines: list[str] = []
        for name, value in initial.fields:
            part = record.part(name)
            assert part is not None
            place = f"{target}.{part.slot}"
            if isinstance(value, StructInitial):
                lines += self.changes(place, part.type, value)
            else:
                lines += self.statements(place, part.type, value)
        return lines

    def part(self, target: str, part: Part) -> list[str]:
        """Statements for one part of a record; in-outs have none, they belong to somebody else."""
        if part.kind is VariableKind.IN_OUT:
            return []
        return self.statements(target, part.type, part.initial)
