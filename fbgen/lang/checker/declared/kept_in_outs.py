"""In-outs that have a value of their own in the instance, as those of elementary types on S7.

A call copies the variable of the caller in and, behind the block, out again. A call may leave such
an in-out out: then the block works with what the instance has, and it can be read and written from
outside. What is no elementary type there (texts, DATE_AND_TIME, arrays, structures) is a reference.
Sources: S7-SCL V5.3 manual, "Supplying parameters in function block calls"; TIA Portal help,
"Calling function blocks"; S7-1200 System Manual, "Block optimization and passing parameters".
"""

from fbgen.lang.ast import BlockKind
from fbgen.lang.checked import VariableKind
from fbgen.lang.types import DATE_AND_TIME, Elementary, Type

_S7 = ("tia", "step7")


def in_out_kind(dialect: str, block: BlockKind | None, kind: Type) -> VariableKind:
    """Whether an in-out of a type refers to the caller's variable, or the instance keeps a copy."""
    kept = (
        dialect in _S7
        and block is BlockKind.FUNCTION_BLOCK
        and isinstance(kind, Elementary)
        and kind != DATE_AND_TIME
    )
    return VariableKind.KEPT if kept else VariableKind.IN_OUT
