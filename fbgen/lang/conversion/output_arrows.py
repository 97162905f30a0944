"""Outputs that STEP 7 gives by `:=` and TIA Portal by `=>`.

Source: S7-SCL V5.3 manual, "Supplying parameters for functions"; TIA Portal help, "Calling
functions".
"""

from collections.abc import Mapping

from fbgen.lang.ast import Argument, ArgumentKind, Block, Call
from fbgen.lang.checker.supplied.routines import Direction, routine_named
from fbgen.lang.checker.supplied.system_instructions import RETURN_VALUE, instruction_named
from fbgen.lang.rewriting import replaced


def with_arrows(call: Call, name: str, blocks: Mapping[str, Block]) -> Call:
    """The call of a block or instruction with an arrow to each of its outputs."""
    outputs = _outputs(name, blocks)
    if not outputs:
        return call
    arguments = tuple(_arrow(one) if _is_given(one, outputs) else one for one in call.arguments)
    return replaced(call, arguments=arguments)


def _is_given(argument: Argument, outputs: frozenset[str]) -> bool:
    return argument.kind is ArgumentKind.INPUT and argument.name.casefold() in outputs


def _arrow(argument: Argument) -> Argument:
    return replaced(argument, kind=ArgumentKind.OUTPUT)


def _outputs(name: str, blocks: Mapping[str, Block]) -> frozenset[str]:
    block = blocks.get(name.casefold())
    if block is not None:
        return frozenset(
            declared.name.casefold()
            for section in block.sections
            if section.keyword == "VAR_OUTPUT"
            for declaration in section.declarations
            for declared in declaration.names
        )
    instruction = instruction_named(name)
    if instruction is not None:
        outputs = [one.name for one in instruction.parameters if one.is_output]
        return frozenset(one.casefold() for one in (*outputs, RETURN_VALUE))
    routine = routine_named(name)
    if routine is None:
        return frozenset()
    parameters = routine.parameters
    return frozenset(one.name.casefold() for one in parameters if one.direction is Direction.OUTPUT)
