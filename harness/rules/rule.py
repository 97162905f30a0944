"""What a rule of a plant is: what holds in every scan, whatever goes wrong around it."""

from collections.abc import Callable, Iterator

from fbgen.dataclass import dataclass
from harness.installation import Installation

Watch = Callable[[], Iterator[str]]
"""Called behind each scan; gives what breaks the rule then, in words."""


@dataclass(frozen=True, slots=True)
class Rule:
    """`watch` looks at a plant from now on and gives what is to be asked behind each scan."""

    name: str
    title: str
    watch: Callable[[Installation], Watch]
