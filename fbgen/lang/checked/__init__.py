"""The checked program: what the text means. Every name is resolved, every type is known.

The checker makes it from syntax trees; the engines run it. Conversions that the language leaves
out are written out (`Convert`), constants are folded into `Constant`, named constants are gone,
overloaded functions are settled, so an engine never has to guess. Nodes are as in `ast`: never
changed, compared by identity, each with the span of what was written. Long chains of operands are
left-deep trees: walk them with a loop down the left side, not by recursion.

Evaluation: operands from left to right, both sides of AND and OR always (an engine may leave the
right side out where that cannot be noticed), of AND_THEN and OR_ELSE only as needed; the arguments
of a call before the call. `Binary` and `Unary` wrap around in the width of their type; REAL results
are rounded to 32 bit.
"""

from fbgen.lang.checked.expressions import (
    AddressRef,
    Attempt,
    Binary,
    BoundOf,
    Constant,
    Convert,
    Dereference,
    ElementCount,
    Expression,
    FieldRef,
    FunctionCall,
    IndexRef,
    MemoryRef,
    Place,
    ReferenceTo,
    RoutineCall,
    SameReference,
    SameTypes,
    SliceRef,
    StandardCall,
    SystemCall,
    TypeTest,
    Unary,
    VariableRef,
)
from fbgen.lang.checked.program import (
    BlockMembers,
    Program,
    Task,
)
from fbgen.lang.checked.statements import (
    Assignment,
    Branch,
    Case,
    CaseArm,
    Continue,
    Evaluate,
    Exit,
    For,
    Goto,
    If,
    InstanceCall,
    Label,
    Repeat,
    Return,
    Statement,
    While,
)
from fbgen.lang.checked.variables import (
    Address,
    AnyBlock,
    Block,
    StandardBlock,
    Variable,
    VariableKind,
)

__all__ = [
    "Address",
    "AddressRef",
    "AnyBlock",
    "Assignment",
    "Attempt",
    "Binary",
    "BlockMembers",
    "Block",
    "BoundOf",
    "Branch",
    "Case",
    "CaseArm",
    "Constant",
    "Continue",
    "Convert",
    "Dereference",
    "ElementCount",
    "Evaluate",
    "Exit",
    "Expression",
    "FieldRef",
    "For",
    "FunctionCall",
    "Goto",
    "If",
    "IndexRef",
    "InstanceCall",
    "Label",
    "MemoryRef",
    "Place",
    "Program",
    "ReferenceTo",
    "Repeat",
    "Return",
    "RoutineCall",
    "SameReference",
    "SameTypes",
    "SliceRef",
    "StandardBlock",
    "StandardCall",
    "Statement",
    "SystemCall",
    "Task",
    "TypeTest",
    "Unary",
    "Variable",
    "VariableKind",
    "VariableRef",
    "While",
]
