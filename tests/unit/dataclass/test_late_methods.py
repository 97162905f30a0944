"""The late `dataclass` does what that of the standard library does."""

import copy
import dataclasses
import inspect
import pickle
import subprocess
import sys
from collections.abc import Callable
from dataclasses import FrozenInstanceError, field, fields, replace
from typing import Any

import pytest

import fbgen.dataclass as late

_DECORATORS = [dataclasses.dataclass, late.dataclass]
_OPTIONS = [
    {"frozen": frozen, "slots": slots, "eq": eq}
    for frozen in (False, True)
    for slots in (False, True)
    for eq in (False, True)
]
_IDS = [" ".join(name for name, on in one.items() if on) or "plain" for one in _OPTIONS]


def _twins(**options: bool) -> list[Any]:
    """The same class from the standard library and from fbgen."""

    def made(decorator: Callable[..., Any]) -> Any:
        @decorator(**options)
        class Frame:
            """A frame."""

            number: int
            text: str = "x"
            words: list[int] = field(default_factory=list)
            note: str = field(default="", compare=False, repr=False)

        return Frame

    return [made(decorator) for decorator in _DECORATORS]


@late.dataclass(frozen=True, slots=True)
class Telegram:
    """At the top of a module, so that pickle finds it."""

    command: int
    reply: "Telegram | None" = None


@pytest.mark.parametrize("options", _OPTIONS, ids=_IDS)
def test_both_show_compare_and_hash_alike(options: dict[str, bool]) -> None:
    for one in (seen := [_behaviour(kind) for kind in _twins(**options)]):
        assert one == seen[0]


def _behaviour(kind: Any) -> list[object]:
    first, same, other = kind(1, "a", [2]), kind(1, "a", [2], note="n"), kind(1, words=[2])
    return [
        repr(first),
        [item.name for item in fields(kind)],
        kind.__match_args__,
        str(inspect.signature(kind)).replace("<locals>", ""),
        first == same,
        first == other,
        first == 1,
        kind(1).words is kind(1).words,
        repr(replace(first, text="z")),
        repr(copy.deepcopy(first)),
        hasattr(first, "__dict__"),
        kind.__hash__ is None,
        _problem(lambda: hash(first)) if _hashes(kind) else "hash by identity",
        _problem(lambda: setattr(first, "number", 5)),
        _problem(lambda: delattr(first, "text")),
        _problem(kind),
        _problem(lambda: kind(1, wrong=2)),
    ]


def _hashes(kind: Any) -> bool:
    """Whether the class hashes its fields, or nothing."""
    return kind.__hash__ is not object.__hash__


def _problem(action: Callable[[], object]) -> object:
    try:
        return "fine", action()
    except (AttributeError, TypeError) as problem:
        return type(problem), str(problem)


def test_hashable_fields_hash_as_their_tuple() -> None:
    assert hash(Telegram(1)) == hash((1, None)) == hash(Telegram(1))
    assert len({Telegram(1), Telegram(1), Telegram(2)}) == 2


def test_an_instance_that_holds_itself_is_shown() -> None:
    @late.dataclass
    class Loop:
        """Holds something."""

        inner: object

    loop = Loop(None)
    loop.inner = loop
    assert repr(loop).endswith("Loop(inner=...)")


def test_frozen_instances_go_to_other_processes() -> None:
    telegram = Telegram(1, Telegram(2))
    assert pickle.loads(pickle.dumps(telegram)) == telegram
    assert copy.copy(telegram) == telegram


def test_a_class_that_inherits_fields_adds_its_own() -> None:
    @late.dataclass(frozen=True, slots=True)
    class Base:
        """With one field."""

        name: str

    @late.dataclass(frozen=True, slots=True)
    class Derived(Base):
        """With one more."""

        number: int = 3

    assert repr(Derived("a")).endswith("Derived(name='a', number=3)")
    assert Derived("a") != Base("a")
    with pytest.raises(FrozenInstanceError):
        Derived("a").name = "b"


def test_methods_of_the_class_itself_stay() -> None:
    @late.dataclass(frozen=True)
    class Own:
        """Says how it is shown, and looks at its fields."""

        number: int
        half: int = field(init=False, default=0)

        def __post_init__(self) -> None:
            object.__setattr__(self, "half", self.number // 2)

        def __repr__(self) -> str:
            return "own"

    own = Own(8)
    assert (repr(own), own.half) == ("own", 4)
    assert hash(own) == hash((8, 4))


def test_a_plain_class_that_inherits_may_have_more_attributes() -> None:
    class Plain(Telegram):
        """No dataclass: only the fields are frozen."""

    plain = Plain(1)
    plain.note = "x"
    with pytest.raises(FrozenInstanceError, match="'command'"):
        plain.command = 2


def test_importing_a_class_writes_no_method() -> None:
    program = (
        "import builtins, sys\n"
        "import fbgen.dataclass as late\n"
        "real, seen = builtins.compile, []\n"
        "builtins.compile = lambda text, file, kind: seen.append(file) or real(text, file, kind)\n"
        "class Frame:\n"
        "    'x'\n"
        "    number: int\n"
        "Frame = late.dataclass(frozen=True, slots=True)(Frame)\n"
        "before = list(seen)\n"
        "Frame(1), Frame(2)\n"
        "print(before, seen)\n"
    )
    command = [sys.executable, "-c", program]
    shown = subprocess.run(command, check=True, capture_output=True, text=True)
    assert shown.stdout == "[] ['<__init__ of the dataclass Frame>']\n"
