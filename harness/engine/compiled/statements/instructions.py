"""Which arguments of an instruction of the controller are areas of memory."""

from typing import TypeGuard

from fbgen.lang.checked import (
    Expression,
    Place,
    SystemCall,
)
from fbgen.lang.checker.supplied.system_instructions import instruction_named
from fbgen.lang.types import VARIANT_VALUE, AnyType


def areas(node: SystemCall) -> dict[str, Place]:
    """The places that the instruction gets as areas, by the name of the parameter."""
    instruction = instruction_named(node.name)
    named = {
        parameter.name
        for parameter in (instruction.parameters if instruction else ())
        if parameter.type != VARIANT_VALUE
        and (parameter.is_output or isinstance(parameter.type, AnyType))
    }
    return {
        name: argument for name, argument in node.arguments if name in named and is_place(argument)
    }


def is_place(node: Expression) -> TypeGuard[Place]:
    """True for an expression that can be written."""
    return isinstance(node, Place)
