"""How a FUNCTION looks in Python: which parameters it takes and what it gives back."""

from fbgen.dataclass import dataclass
from fbgen.lang.checked import Block, Variable, VariableKind
from harness.engine.compiled.data.model import is_scalar
from harness.engine.compiled.shortening.facts import Facts


@dataclass(frozen=True, slots=True)
class Signature:
    """`returned`: what comes back, in this order: in-outs passed by value, outputs, the result."""

    inputs: tuple[Variable, ...]
    in_outs: tuple[Variable, ...]
    returned: tuple[Variable, ...]


def signature(block: Block, facts: Facts) -> Signature:
    """The signature of a FUNCTION or an organization block."""
    by_kind = {kind: [v for v in block.variables if v.kind is kind] for kind in VariableKind}
    returned = [v for v in by_kind[VariableKind.IN_OUT] if comes_back(v, block, facts)]
    returned += by_kind[VariableKind.OUTPUT]
    if block.result is not None:
        returned.append(block.result)
    return Signature(
        tuple(by_kind[VariableKind.INPUT]), tuple(by_kind[VariableKind.IN_OUT]), tuple(returned)
    )


def comes_back(in_out: Variable, block: Block, facts: Facts) -> bool:
    """True if an in-out is passed by value and its value may have changed."""
    if not is_scalar(in_out.type) or in_out in facts.cells:
        return False
    return in_out in facts.written(block)
