"""The methods that CODESYS and TwinCAT call by themselves, with parameters that they prescribe.

Source: CODESYS help, "Methods FB_Init, FB_Reinit and FB_Exit".
"""

from fbgen.lang.checked import Block, VariableKind

LIFE_CYCLE = ("fb_init", "fb_reinit", "fb_exit")
"""By their casefolded names."""


def is_life_cycle(block: Block) -> bool:
    """True for FB_init and the like, whose parameters are prescribed."""
    return block.name.rpartition(".")[2].casefold() in LIFE_CYCLE


def is_method(block: Block) -> bool:
    """True for the code of a method or accessor: its first variable is the instance."""
    first = block.variables[0] if block.variables else None
    return first is not None and first.kind is VariableKind.IN_OUT and first.name == "THIS"
