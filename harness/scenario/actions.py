"""What the steps of a scenario do, with names resolved and values read."""

from collections.abc import Callable
from typing import TypeAlias

from fbgen.dataclass import dataclass
from fbgen.source import Span
from harness.scenario.conditions import Check
from harness.scenario.kinds import Found
from harness.scenario.model import Step
from harness.scenario.paths import Writable
from harness.scenario.telegram_checks import TelegramCheck


@dataclass(frozen=True, slots=True)
class Write:
    """One value to be written."""

    place: Span | None
    target: Writable
    value: Found


@dataclass(frozen=True, slots=True)
class SetAction:
    """Values to be written one after the other."""

    writes: tuple[Write, ...]


@dataclass(frozen=True, slots=True)
class WaitAction:
    """Time to pass, in ns."""

    time_ns: int


@dataclass(frozen=True, slots=True)
class ExpectAction:
    """What must hold, at the latest after `within_ns` and from then on for `stays_for_ns`."""

    checks: tuple[Check, ...]
    within_ns: int
    stays_for_ns: int = 0


@dataclass(frozen=True, slots=True)
class WaitUntilAction:
    """What must hold at the latest after `within_ns`, before the steps go on."""

    checks: tuple[Check, ...]
    within_ns: int


@dataclass(frozen=True, slots=True)
class FaultAction:
    """A fault to begin or to end."""

    place: Span | None
    act: Callable[[], None]


@dataclass(frozen=True, slots=True)
class CompareAction:
    """Telegrams to be compared."""

    telegrams: TelegramCheck


@dataclass(frozen=True, slots=True)
class CallAction:
    """Cycles of the block."""

    cycles: int


Action: TypeAlias = (
    SetAction
    | WaitAction
    | CallAction
    | WaitUntilAction
    | ExpectAction
    | FaultAction
    | CompareAction
)


@dataclass(frozen=True, slots=True)
class PreparedStep:
    """A step of the file with what it does."""

    step: Step
    action: Action
