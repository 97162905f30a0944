"""What the paths through one block tell about it, for the rules that look at whole programs."""

from dataclasses import field

from fbgen.dataclass import dataclass
from fbgen.lang.analysis.effects import PlaceKey
from fbgen.lang.checked import AddressRef, Block, FieldRef, FunctionCall, InstanceCall, Variable
from fbgen.source import Span


@dataclass(frozen=True, slots=True)
class CalledInstance:
    """One call of an instance. `depth` is how many conditions and loops are around it."""

    call: InstanceCall
    key: PlaceKey | None
    depth: int


@dataclass(slots=True)
class BlockFacts:
    """Variables by what the block does to them, and its calls, in the order of the text.

    `kept` are the calls of functions whose result a variable gets, `always_true` counts how often
    the block sets its own result to TRUE.
    """

    block: Block
    read: set[Variable] = field(default_factory=set)
    written: dict[Variable, Span] = field(default_factory=dict)
    touched: set[Variable] = field(default_factory=set)
    members_read: list[FieldRef] = field(default_factory=list)
    members_written: list[FieldRef] = field(default_factory=list)
    addresses_written: list[AddressRef] = field(default_factory=list)
    instances: list[CalledInstance] = field(default_factory=list)
    dropped: list[FunctionCall] = field(default_factory=list)
    kept: list[tuple[Variable, FunctionCall]] = field(default_factory=list)
    always_true: int = 0
    uses_outside: bool = False
