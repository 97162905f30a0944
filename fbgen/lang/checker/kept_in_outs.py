"""In-outs that have a value of their own in the instance, as those of elementary types on S7.

A call may leave them out, and they can be read and written from outside. Source: S7-SCL V5.3,
"Supplying parameters in function block calls"; TIA Portal help, "Calling function blocks".
"""

from fbgen.lang.ast import BlockKind
from fbgen.lang.checked import AnyBlock, Block, Variable, VariableKind
from fbgen.lang.checker.context import Context
from fbgen.lang.types import Elementary


def kept_by_instance(ctx: Context, block: AnyBlock | None, variable: Variable) -> bool:
    """True for an in-out that keeps its value in the instance; the engines have none of them."""
    return (
        ctx.rules.dialect in ("tia", "step7")
        and isinstance(block, Block)
        and block.kind is BlockKind.FUNCTION_BLOCK
        and variable.kind is VariableKind.IN_OUT
        and isinstance(variable.type, Elementary)
    )
