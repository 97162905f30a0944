"""From a line of the tables to the parameters that it describes."""

from enum import Enum

from fbgen.dataclass import dataclass
from fbgen.lang.types import ALIASES, ELEMENTARY, VOID, StringType, Type


class Direction(Enum):
    """Which way the value of a parameter goes."""

    INPUT = "input"
    OUTPUT = "output"
    IN_OUT = "in-out"
    STATIC = "static"


@dataclass(frozen=True, slots=True)
class Parameter:
    """One parameter. `words` are the types that it can have, or one of the words of the tables."""

    name: str
    direction: Direction
    words: tuple[str, ...]
    optional: bool = False

    @property
    def types(self) -> tuple[Type, ...]:
        """The types among the words."""
        return tuple(kind for word in self.words if (kind := type_named(word)) is not None)

    @property
    def is_input(self) -> bool:
        """True if the caller gives a value."""
        return self.direction in (Direction.INPUT, Direction.IN_OUT)

    @property
    def is_output(self) -> bool:
        """True if the caller gets a value."""
        return self.direction in (Direction.OUTPUT, Direction.IN_OUT)


@dataclass(frozen=True, slots=True)
class Routine:
    """An instruction. `open_ended`: it takes parameters of any name beside these."""

    name: str
    parameters: tuple[Parameter, ...]
    result: Type
    modelled: bool
    open_ended: bool = False


SAME = "SAME"
"""All parameters with this word have one type, that of the first input among them."""
WHOLE = "ANY_INT"
"""Any integer type; an output takes the low bits."""
ANYTHING = "ANY"
"""Any type at all."""
NUMBER = "ANY_NUM"
"""Any integer, REAL or LREAL."""
AREA = "AREA"
"""A variable of any type but BOOL, for its bytes."""

_NUMBERED = 32
_DIRECTIONS = {"=>": Direction.OUTPUT, "<>": Direction.IN_OUT, ".": Direction.STATIC}


def type_named(word: str) -> Type | None:
    """The type that a word names; None for the words of the tables."""
    if word in ("STRING", "WSTRING"):
        return StringType(wide=word == "WSTRING")
    return ELEMENTARY.get(ALIASES.get(word, word))


def read_signature(name: str, text: str, *, modelled: bool) -> Routine:
    """The instruction that a line of a table describes."""
    result_word, _, rest = text.partition("(")
    parameters: list[Parameter] = []
    open_ended = False
    for piece in filter(None, (one.strip() for one in rest.removesuffix(")").split(","))):
        if piece == "...":
            open_ended = True
        else:
            parameters += _parameters(piece)
    result = type_named(result_word) or VOID
    return Routine(name, tuple(parameters), result, modelled, open_ended)


def _parameters(piece: str) -> list[Parameter]:
    head, *middle, words = piece.split()
    direction = _DIRECTIONS.get(middle[0] if middle else "", Direction.INPUT)
    optional = words.endswith("?")
    kinds = tuple(words.removesuffix("?").split("|"))
    if not head.endswith("#"):
        return [Parameter(head, direction, kinds, optional)]
    return [
        Parameter(f"{head.removesuffix('#')}{number}", direction, kinds, optional=True)
        for number in range(_NUMBERED)
    ]
