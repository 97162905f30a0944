"""`block.DW10`, where `block` is a parameter with the number of a data block.

Source: S7-SCL V5.3 manual, "Indexed and structured access to data blocks", "BLOCK_DB".
"""

import re

from fbgen.lang import ast
from fbgen.lang.checked import Constant, Expression, MemoryRef
from fbgen.lang.checker.context import Context
from fbgen.lang.types import BLOCK_DB, BYTE, DB_ANY, DINT, DWORD, WORD

_MEMBER = re.compile(r"DB?([BWD])([0-9]{1,5})", re.IGNORECASE)
_SIZES = {"B": BYTE, "W": WORD, "D": DWORD}
_DATA_BLOCK = 0x84


def addressed_member(ctx: Context, node: ast.Member, base: Expression) -> MemoryRef | None:
    """The bytes that the member means; None for other bases and names."""
    match = _MEMBER.fullmatch(node.name)
    if match is None or base.type not in (BLOCK_DB, DB_ANY):
        return None
    ctx.library.memory.address_any()
    area = Constant(node.span, _DATA_BLOCK, BYTE)
    byte = Constant(node.span, int(match[2]), DINT)
    return MemoryRef(node.span, area, base, byte, None, _SIZES[match[1].upper()])
