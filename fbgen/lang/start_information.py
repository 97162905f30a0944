"""Where the start information of an organization block goes.

On an S7-300 or S7-400 the operating system puts 20 bytes at the beginning of the temporary data of
an organization block before it runs: which event it was, and what it concerns. The block declares
them as it likes; the bytes are the same.
Source: TIA Portal help, "Organization blocks (S7-300, S7-400)", tables of local data.
"""

from fbgen.lang.ast import BlockKind
from fbgen.lang.checked import Block, Variable, VariableKind
from fbgen.lang.layout import S7_SIZES, holds_blocks, holds_values

START_BYTES = 20


def start_places(block: Block) -> tuple[tuple[Variable, int], ...]:
    """The temporary variables in the first 20 bytes, each with its first bit.

    What lies over another variable (AT) shows the bytes of that one and is left out.
    """
    if block.kind is not BlockKind.ORGANIZATION_BLOCK:
        return ()
    places: list[tuple[Variable, int]] = []
    end = 0
    for variable in block.variables:
        if variable.kind is not VariableKind.TEMP or variable.overlay is not None:
            continue
        if not holds_values(variable.type) or holds_blocks(variable.type):
            break
        bit = S7_SIZES.aligned(end, variable.type)
        end = bit + S7_SIZES.size_bits(variable.type)
        if bit + S7_SIZES.used_bits(variable.type) > 8 * START_BYTES:
            break
        places.append((variable, bit))
    return tuple(places)
