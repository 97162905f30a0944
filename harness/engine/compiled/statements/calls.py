"""Calls of functions and of instructions of the controller, and what all calls have in common."""

from collections.abc import Sequence

from fbgen.lang.checked import (
    AddressRef,
    Block,
    Expression,
    FunctionCall,
    IndexRef,
    Place,
    SliceRef,
    SystemCall,
    Variable,
    VariableKind,
    VariableRef,
)
from fbgen.lang.checker.supplied.system_instructions import ELEMENT_MOVES, instruction_named
from fbgen.lang.types import ArrayType, OpenArrayType, Type
from harness.engine.compiled.code import Code, Listing, deepest
from harness.engine.compiled.data.model import is_scalar
from harness.engine.compiled.evaluation import Write, value
from harness.engine.compiled.expressions.places import assign, cell, pinned
from harness.engine.compiled.outside.signatures import Signature, comes_back, signature
from harness.engine.compiled.procedure import Procedure
from harness.engine.compiled.shortening.ranges import limits
from harness.engine.compiled.statements.instructions import areas, is_place
from harness.engine.compiled.watching.write_notes import (
    argument_entry,
    is_plain,
    is_simple,
    note_elements,
    note_record,
    note_write,
    writers_of,
)

RECORD_WRITES = ("DPWR_DAT", "SFC15")
"""Instructions that write an area to a module."""
_Outputs = Sequence[tuple[Variable, Place]]


# --- arguments ----------------------------------------------------------------------------------


def copied(text: str, kind: Type) -> str:
    """A copy of a structure or an array."""
    if not isinstance(kind, ArrayType):
        return f"{text}._copy()"
    if is_scalar(kind.element):
        return f"{text}[:]"
    return f"[{copied('_one', kind.element)} for _one in {text}]"


def _input(procedure: Procedure, variable: Variable, node: Expression, callee: Block) -> Code:
    code = value(procedure, node)
    only_read = procedure.context.facts.only_reads(callee, variable)
    if isinstance(variable.type, OpenArrayType):
        return _open_array(procedure, node, code, only_read)
    if is_scalar(variable.type) or only_read:
        return code
    return code._replace(text=copied(code.text, variable.type), depth=code.depth + 1)


def _open_array(procedure: Procedure, node: Expression, code: Code, by_reference: bool) -> Code:
    """An argument for ARRAY[*]: the elements, or a copy of them, together with their bounds."""
    kind = node.type
    if isinstance(kind, OpenArrayType):
        if by_reference:
            return code
        bounds = f"{code.text}.bounds"
        content = f"{code.text}.elements"
    else:
        assert isinstance(kind, ArrayType)
        bounds = procedure.context.table("bounds", kind.bounds)
        content = code.text
    if not by_reference:
        content = copied(content, ArrayType(((0, 0),), kind.element))
    return code._replace(text=f"_OpenArray({content}, {bounds})", depth=code.depth + 2)


def _is_outside_python(node: Place) -> bool:
    """True for places that no cell can refer to: slices and addresses."""
    if isinstance(node, VariableRef):
        return node.variable.address is not None
    if isinstance(node, AddressRef):
        return node.address.area != "DB"
    return isinstance(node, SliceRef)


class InOut:
    """One in-out of a call that is being written."""

    __slots__ = ("node", "text", "variable", "write_back")

    def __init__(self, variable: Variable, node: Place, text: str, write_back: str) -> None:
        self.variable = variable
        self.node = node
        self.text = text
        self.write_back = write_back


def in_out_arguments(
    procedure: Procedure, pairs: Sequence[tuple[Variable, Place]], callee: Block
) -> list[InOut]:
    """The in-outs of a call; `write_back` is what to read afterwards, "" if nothing."""
    result = []
    facts = procedure.context.facts
    for variable, node in pairs:
        if isinstance(variable.type, OpenArrayType):
            code = _open_array(procedure, node, value(procedure, node), by_reference=True)
            result.append(InOut(variable, node, code.text, ""))
        elif not is_scalar(variable.type):
            result.append(InOut(variable, node, value(procedure, node).text, ""))
        elif variable in facts.cells:
            if _is_outside_python(node):
                node = pinned(procedure, node)
                name = procedure.temporary()
                procedure.line(f"{name} = _ValueCell({value(procedure, node).text})")
                result.append(InOut(variable, node, name, f"{name}.value"))
            else:
                result.append(InOut(variable, node, cell(procedure, node).text, ""))
        else:
            kept = variable.kind is VariableKind.KEPT
            back = (
                not facts.only_reads(callee, variable)
                if kept
                else comes_back(variable, callee, facts)
            )
            if back:
                node = pinned(procedure, node)
            text = value(procedure, node).text
            result.append(InOut(variable, node, text, "yes" if back else ""))
    return result


# --- functions ----------------------------------------------------------------------------------


def _result_code(procedure: Procedure, text: str, node: FunctionCall, codes: list[Code]) -> Code:
    low, high = limits(node.type)
    return Code(text, low=low, high=high, depth=deepest(codes) + 1, safe=False, pure=False)


def _callee(procedure: Procedure, node: FunctionCall) -> str:
    """The function that is called; of several methods the class of the instance says which."""
    model = procedure.context.model
    if not node.overrides:
        return model.name_of(node.function)
    context = procedure.context
    shape = signature(node.function, context.facts)
    name = context.new_name("method")
    names = [f"_{number}" for number in range(len(shape.inputs) + len(shape.in_outs))]
    arguments = ", ".join(names)
    listing = Listing()
    listing.span = node.span
    listing.add(f"def {name}({arguments}):")
    methods = ", ".join(
        f"{model.record_named(one).class_name}: {model.name_of(method)}"
        for one, method in node.overrides
    )
    # The instance is the first in-out.
    listing.add(f"    return {{{methods}}}[_type({names[len(shape.inputs)]})]({arguments})")
    context.parts.append(listing)
    return name


def _function(procedure: Procedure, node: FunctionCall) -> Code:
    """A call inside of an expression."""
    facts = procedure.context.facts
    shape = signature(node.function, facts)
    writes_back = any(
        comes_back(variable, node.function, facts)
        or (variable in facts.cells and _is_outside_python(where))
        for variable, where in node.in_outs
    )
    if node.outputs or writes_back:
        part = procedure.start_part("call")
        code = function_statement(part, node)
        assert code is not None
        part.line(f"return {code.text}")
        return _result_code(procedure, procedure.finish_part(part), node, [])
    codes = [_input(procedure, variable, one, node.function) for variable, one in node.inputs]
    texts = [code.text for code in codes]
    texts += [in_out.text for in_out in in_out_arguments(procedure, node.in_outs, node.function)]
    text = f"{_callee(procedure, node)}({', '.join(texts)})"
    if facts.counts_depth(node.function):
        procedure.site(text, node)
    if len(shape.returned) > 1:
        text += "[-1]"
    return _result_code(procedure, text, node, codes)


def function_statement(procedure: Procedure, node: FunctionCall) -> Code | None:
    """Write a call with everything that it writes; gives its result, None without one."""
    facts = procedure.context.facts
    shape = signature(node.function, facts)
    texts = [_input(procedure, variable, one, node.function).text for variable, one in node.inputs]
    in_outs = in_out_arguments(procedure, node.in_outs, node.function)
    texts += [in_out.text for in_out in in_outs]
    text = f"{_callee(procedure, node)}({', '.join(texts)})"
    if facts.counts_depth(node.function):
        procedure.site(text, node)
    if not shape.returned:
        procedure.line(text)
    names = _unpack(procedure, node, shape, text) if shape.returned else {}
    for in_out in in_outs:
        if in_out.write_back:
            back = names.get(in_out.variable, in_out.write_back)
            assign(procedure, in_out.node, Code(back, simple=True), in_out.variable.type)
    write_outputs(procedure, node.outputs, names)
    if node.function.result is None:
        return None
    low, high = limits(node.type)
    return Code(names[node.function.result], low=low, high=high, simple=True)


def _unpack(
    procedure: Procedure, node: FunctionCall, shape: Signature, call: str
) -> dict[Variable, str]:
    wanted = {variable for variable, _ in node.outputs}
    names: dict[Variable, str] = {}
    targets = []
    for variable in shape.returned:
        if variable.kind is VariableKind.OUTPUT and variable not in wanted:
            targets.append("_")
        else:
            names[variable] = procedure.temporary()
            targets.append(names[variable])
    procedure.line(f"{', '.join(targets)} = {call}")
    return names


def write_outputs(procedure: Procedure, outputs: _Outputs, names: dict[Variable, str]) -> None:
    for variable, target in outputs:
        low, high = limits(variable.type)
        code = Code(names[variable], low=low, high=high, simple="." not in names[variable])
        assign(procedure, target, code, variable.type, argument_entry(procedure, target))


# --- instructions -------------------------------------------------------------------------------


def _instruction(procedure: Procedure, node: SystemCall) -> Code:
    """A call inside of an expression."""
    if any(_is_outside_python(one) for one in areas(node).values()):
        part = procedure.start_part("call")
        code = instruction_statement(part, node)
        part.line(f"return {code.text}")
        return code._replace(text=procedure.finish_part(part))
    return _instruction_code(procedure, node, {})


def _instruction_code(procedure: Procedure, node: SystemCall, cells: dict[str, str]) -> Code:
    table = procedure.context.table("instruction", node)
    texts = [table]
    areas_by_name = areas(node)
    for name, argument in node.arguments:
        area = areas_by_name.get(name)
        if area is not None and node.name in ELEMENT_MOVES:
            texts.append(cell(procedure, area).text)
        elif area is None or not is_scalar(area.type):
            texts.append(value(procedure, argument).text)
        else:
            texts.append(cells.get(name) or cell(procedure, area).text)
    low, high = limits(node.type)
    text = f"_instruction({', '.join(texts)})"
    return Code(text, low=low, high=high, depth=4, safe=False, pure=False)


def instruction_statement(procedure: Procedure, node: SystemCall) -> Code:
    """Write a call with everything that it writes; gives its result."""
    cells: dict[str, str] = {}
    back: list[tuple[Place, str]] = []
    for name, area in areas(node).items():
        if is_scalar(area.type) and _is_outside_python(area):
            # A single value that no cell can refer to is copied in and out.
            target = pinned(procedure, area)
            cells[name] = procedure.temporary()
            procedure.line(f"{cells[name]} = _ValueCell({value(procedure, target).text})")
            back.append((target, f"{cells[name]}.value"))
    code = _instruction_code(procedure, node, cells)
    result = procedure.temporary()
    procedure.line(f"{result} = {code.text}")
    _note_areas(procedure, node, cells)
    for target, text in back:
        assign(procedure, target, Code(text), target.type)
    return code._replace(text=result, depth=1, simple=True)


def _note_areas(procedure: Procedure, node: SystemCall, cells: dict[str, str]) -> None:
    """Who writes the areas that the instruction writes, and the outputs of a module."""
    instruction = instruction_named(node.name)
    if writers_of(procedure) is None or instruction is None:
        return
    written = {one.name for one in instruction.parameters if one.is_output or one.either_way}
    arguments = dict(node.arguments)
    for name, area in node.arguments:
        if name in cells or not is_place(area) or not is_plain(area):
            continue  # the copies in cells are copied back by assignments
        if name not in written:
            if node.name in RECORD_WRITES and is_simple(arguments["LADDR"]):
                note_record(procedure, value(procedure, arguments["LADDR"]).text, area)
        elif node.name not in ELEMENT_MOVES:
            note_write(procedure, value(procedure, area).text, area.type)
        elif isinstance(area, IndexRef) and is_simple(arguments["COUNT"]):
            place = value(procedure, area).text
            note_elements(procedure, place, value(procedure, arguments["COUNT"]).text, area.type)


def evaluate(procedure: Procedure, node: FunctionCall | SystemCall) -> None:
    """Write a call whose result is dropped."""
    if isinstance(node, FunctionCall):
        function_statement(procedure, node)
    else:
        instruction_statement(procedure, node)


EXPRESSIONS: dict[type, Write] = {FunctionCall: _function, SystemCall: _instruction}
"""Which function of this module writes which node."""
