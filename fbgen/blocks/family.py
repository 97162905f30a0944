"""What one family of blocks brings to a plant: those for one kind of gateway, for serial lines."""

from collections.abc import Mapping, Sequence

from fbgen.blocks.gateways import UnitView
from fbgen.blocks.specs import BlockSpec
from fbgen.dataclass import dataclass
from fbgen.diagnostics import Diagnostic


@dataclass(frozen=True, slots=True)
class FamilyPlan:
    """The units of a family, each kind in the order of dependence, and what they are told.

    `exchanged` are data blocks that the blocks name, which therefore come before them.
    """

    units: Sequence[UnitView]
    types: Sequence[BlockSpec]
    blocks: Sequence[BlockSpec]
    data: Sequence[BlockSpec]
    context: Mapping[str, object]
    warnings: Sequence[Diagnostic] = ()
    exchanged: Sequence[BlockSpec] = ()
