"""What one family of blocks brings to a plant: the blocks for one kind of gateway."""

from collections.abc import Mapping, Sequence

from fbgen.blocks.gateways import GatewayView
from fbgen.blocks.specs import BlockSpec
from fbgen.dataclass import dataclass
from fbgen.diagnostics import Diagnostic


@dataclass(frozen=True, slots=True)
class FamilyPlan:
    """The units of a family, each kind in the order of dependence, and what they are told."""

    gateways: Sequence[GatewayView]
    types: Sequence[BlockSpec]
    blocks: Sequence[BlockSpec]
    data: Sequence[BlockSpec]
    context: Mapping[str, object]
    warnings: Sequence[Diagnostic] = ()
