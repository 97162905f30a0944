"""Calls of every standard function with every combination of types that the checker accepts.

Made from the checker's own tables, so that a new function has its cases at once.
"""

from collections.abc import Iterator
from dataclasses import dataclass

from hypothesis import strategies as st

from fbgen.lang.checker.supplied.function_signatures import (
    COMMON,
    EXPECTED,
    FAMILIES,
    FLOATING,
    WHOLE_NUMBER,
    WITH_TEXT,
    Common,
    Function,
    Slot,
)
from fbgen.lang.checker.supplied.standard_functions import (
    CHAINED_COMPARISONS,
    DATE_FUNCTIONS,
    ROUNDED_TO_REAL,
    ROUNDED_UP_OR_DOWN,
    STANDARD_FUNCTIONS,
    TEXT_CONVERSIONS,
    UNSIGNED_BCD,
)
from fbgen.lang.dates import counted_in, exists_in
from fbgen.lang.types import (
    BOOL,
    ELEMENTARY,
    LREAL,
    LTIME_OF_DAY,
    REAL,
    S5TIME,
    TIME_OF_DAY,
    VOID,
    Elementary,
    Family,
    Scalar,
    StringType,
)
from harness.engine.interface import Value

Kind = Elementary | StringType
_TEXTS = (StringType(12), StringType(12, wide=True))
_WHOLE = tuple(ELEMENTARY[name] for name in ("INT", "USINT", "DINT"))


@dataclass(frozen=True)
class Case:
    """One call: what is called, with arguments of which types, for a result of which type."""

    name: str
    arguments: tuple[Kind, ...]
    result: Kind
    names: tuple[str, ...] = ()

    @property
    def block(self) -> str:
        """The name of the block that makes the call."""
        kinds = (*self.arguments, self.result)
        return "_".join([self.name, *(kind.name.split("[")[0] for kind in kinds), *self.names])

    def exists_in(self, dialect: str) -> bool:
        """False for types that the dialect does not have."""
        kinds = (*self.arguments, self.result)
        return all(isinstance(kind, StringType) or exists_in(kind, dialect) for kind in kinds)

    def text(self, dialect: str) -> str:
        """A function block with the arguments as inputs and the result as output `y`."""
        mark = "#" if dialect == "tia" else ""
        inputs = "\n".join(
            f"  a{number} : {kind.name};" for number, kind in enumerate(self.arguments)
        )
        given = ", ".join(
            f"{self.names[number]} := {mark}a{number}" if self.names else f"{mark}a{number}"
            for number in range(len(self.arguments))
        )
        return (
            f"FUNCTION_BLOCK {self.block}\nVAR_INPUT\n{inputs}\nEND_VAR\n"
            f"VAR_OUTPUT\n  y : {self.result.name};\nEND_VAR\n"
            f"{mark}y := {self.name}({given});\nEND_FUNCTION_BLOCK\n"
        )


def _common_kinds(function: Function) -> Iterator[Kind | None]:
    if function.common is Common.NONE:
        yield None
        return
    families = FAMILIES[function.common]
    yield from (kind for kind in ELEMENTARY.values() if kind.family in families and kind != S5TIME)
    if function.common in WITH_TEXT:
        yield from _TEXTS


def _results(function: Function, common: Kind | None) -> Iterator[Kind]:
    if function.result is not EXPECTED:
        kind = common if function.result is COMMON else function.result
        assert isinstance(kind, Elementary | StringType)
        yield _TEXTS[kind.wide] if isinstance(kind, StringType) else kind
        return
    for one in function.results:
        kind = common if one is COMMON else one
        if isinstance(kind, Elementary):
            yield kind


def _of_function(name: str, function: Function) -> Iterator[Case]:
    takes_whole = any(kind is WHOLE_NUMBER for _, kind in function.parameters)
    for common in _common_kinds(function):
        for result in _results(function, common):
            for whole in _WHOLE if takes_whole else _WHOLE[:1]:
                slots = {
                    COMMON: common,
                    WHOLE_NUMBER: whole,
                    FLOATING: LREAL if result == LREAL else REAL,
                }
                kinds: list[Kind] = []
                for _, kind in function.parameters:
                    known = slots[kind] if isinstance(kind, Slot) else kind
                    assert known is not None
                    kinds.append(known)
                yield Case(name, tuple(kinds), result)
                if function.repeats:
                    yield Case(name, (*kinds, kinds[-1]), result)
                if name == "MUX":
                    yield Case(name, (*kinds, kinds[-1]), result, ("K", "IN0", "IN1", "INELSE"))


def _named(name: str) -> Kind:
    if name in ("STRING", "WSTRING"):
        return StringType(40, wide=name == "WSTRING")
    return ELEMENTARY[name]


def cases() -> dict[str, list[Case]]:
    """All cases, by what is called; conversions by their source."""
    tables = (STANDARD_FUNCTIONS, ROUNDED_UP_OR_DOWN, CHAINED_COMPARISONS)
    found = {
        name: list(_of_function(name, function))
        for table in tables
        for name, function in table.items()
    }
    groups = {"dates": DATE_FUNCTIONS, "to REAL": ROUNDED_TO_REAL, "unsigned BCD": UNSIGNED_BCD}
    for group, table in groups.items():
        found[group] = [case for one in table.items() for case in _of_function(*one)]
    for key, (source, target) in TEXT_CONVERSIONS.items():
        group = f"{source if 'STRING' in target else target} and text"
        found.setdefault(group, []).append(Case(key, (_named(source),), _named(target)))
    plain = [kind for kind in ELEMENTARY.values() if kind != VOID]
    for one in (*plain, *_TEXTS):
        source = one.name.split("[")[0]
        found[f"{source}_TO_..."] = [
            Case(f"{source}_TO_{two.name.split('[')[0]}", (one,), two) for two in (*plain, *_TEXTS)
        ]
    found["ROUND and TRUNC"] = [
        Case(f"{how}_{kind}", (real,), ELEMENTARY[kind])
        for kind in ("INT", "UDINT", "LINT")
        for how in ("ROUND", "TRUNC", "CEIL", "FLOOR", "LREAL_TRUNC")
        for real in (REAL, LREAL)
    ]
    return found


# --- values -----------------------------------------------------------------------------------

_LAST_STAMP = (1 << 64) - 1


def _decimal(bits: int) -> st.SearchStrategy[int]:
    """Words that are mostly decimal coded."""
    digits = st.lists(st.integers(0, 9), min_size=bits // 4, max_size=bits // 4)
    coded = digits.map(lambda all_digits: int("".join(map(str, all_digits)), 16))
    return st.one_of(coded, st.integers(0, (1 << bits) - 1))


def values(kind: Kind) -> st.SearchStrategy[Value]:
    """Values of a type, with those at its ends."""
    strategy: st.SearchStrategy[Scalar]
    if isinstance(kind, StringType):
        letters = st.text("ab1+-. E\u00e9", max_size=kind.length)
        numbers = st.one_of(
            st.integers(-(1 << 33), 1 << 33).map(str),
            st.floats(-1e30, 1e30).map(lambda number: f"{number:.4g}"),
            st.sampled_from(["TRUE", "false", "1", " 12", "1e99"]),
        ).filter(lambda text: len(text) <= kind.length)
        return st.one_of(letters, numbers)
    family = kind.family
    if kind == BOOL:
        strategy = st.booleans()
    elif kind == REAL:
        strategy = st.one_of(st.floats(width=32), st.floats(-70000, 70000, width=32))
    elif kind == LREAL:
        strategy = st.one_of(st.floats(), st.floats(-1e10, 1e10))
    elif family is Family.CHAR:
        strategy = st.characters(max_codepoint=255 if kind.bits == 8 else 0xFFFF)
    elif kind == S5TIME or family is Family.BITS:
        strategy = _decimal(kind.bits)
    elif kind == TIME_OF_DAY:
        strategy = st.integers(0, 86_399_999)
    elif kind == LTIME_OF_DAY:
        strategy = st.integers(0, 86_399_999_999_999)
    elif counted_in(kind):
        strategy = st.integers(0, kind.maximum)
    else:
        small = st.integers(max(kind.minimum, -300), min(kind.maximum, 3000))
        ends = st.sampled_from([kind.minimum, kind.maximum, 0, 1])
        strategy = st.one_of(small, st.integers(kind.minimum, kind.maximum), ends)
    return strategy
