"""Calls of function block instances; edges and on-delays are written out, they are so frequent."""

from fbgen.lang.checked import Block, InstanceCall, VariableRef
from harness.engine.compiled.code import Code
from harness.engine.compiled.data.model import is_scalar, run_method
from harness.engine.compiled.evaluation import condition, stored, value
from harness.engine.compiled.expressions.places import assign, copy_into, place
from harness.engine.compiled.procedure import Procedure
from harness.engine.compiled.statements.calls import copied, in_out_arguments, write_outputs
from harness.engine.compiled.walk import every_node, root_of
from harness.engine.compiled.watching.write_notes import argument_entry, note_write, passed_entry

_EDGES = ("R_TRIG", "F_TRIG")


def instance_call(procedure: Procedure, node: InstanceCall) -> None:
    """Write a call of an instance: store the inputs, run it, fetch the outputs."""
    instance = place(procedure, node.instance).text
    is_edge = node.block.name in _EDGES and len(node.inputs) == 1
    uses = len(node.inputs) + len(node.in_outs) + len(node.outputs) + 1
    if "[" in instance or ("." in instance and (uses > 2 or is_edge)):
        name = procedure.temporary()
        procedure.line(f"{name} = {instance}")
        instance = name
    if is_edge:
        _edge(procedure, instance, node)
    elif isinstance(node.block, Block):
        _user_block(procedure, instance, node, node.block)
    elif not (node.block.name == "TON" and _on_delay(procedure, instance, node)):
        _store_inputs(procedure, instance, node)
        method = run_method(node.block)
        if node.instance.type.name.casefold() in procedure.context.facts.turned:
            procedure.line(f"if {instance}._called != {method!r}:")
            procedure.line(f"    _turn({instance}, {method!r})")
        procedure.line(f"{instance}.{method}()")
    if not isinstance(node.block, Block):
        note_write(procedure, instance, node.instance.type)
    record = procedure.context.model.block_record(node.block)
    names = {
        variable: f"{instance}.{record.by_key[variable.name.casefold()].slot}"
        for variable, _ in node.outputs
    }
    write_outputs(procedure, node.outputs, names)


def _user_block(procedure: Procedure, instance: str, node: InstanceCall, block: Block) -> None:
    record = procedure.context.model.block_record(block)
    _store_inputs(procedure, instance, node)
    in_outs = in_out_arguments(procedure, node.in_outs, block)
    slots = {one: record.by_key[one.variable.name.casefold()].slot for one in in_outs}
    for in_out, slot in slots.items():
        procedure.line(f"{instance}.{slot} = {in_out.text}")
    if node.instance.type.name.casefold() == block.name.casefold():
        procedure.line(f"{instance}._run()")
    else:
        procedure.line(f"{record.class_name}._run({instance})")
    for in_out, slot in slots.items():
        if in_out.variable in procedure.context.facts.cells:
            # From outside, the in-out shows what the call left, whatever the caller does now.
            procedure.line(f"{instance}.{slot} = _ValueCell({instance}.{slot}.value)")
        if in_out.write_back:
            back = f"{instance}.{slot}" if in_out.write_back == "yes" else in_out.write_back
            passed = passed_entry(procedure, f"{instance}.{slot}")
            assign(procedure, in_out.node, Code(back), in_out.variable.type, passed)


def _can_store_at_once(procedure: Procedure, node: InstanceCall, codes: list[Code]) -> bool:
    """True if nobody can tell that an input is stored before the next one is evaluated."""
    root = root_of(node.instance)
    later = [one for _, one in node.inputs[1:]]
    return all(code.safe for code in codes[1:]) and not any(
        isinstance(inner, VariableRef) and inner.variable is root for inner in every_node(later)
    )


def _store_inputs(procedure: Procedure, instance: str, node: InstanceCall) -> None:
    record = procedure.context.model.block_record(node.block)
    codes = [value(procedure, one) for _, one in node.inputs]
    if not _can_store_at_once(procedure, node, codes):
        for number, ((variable, _), code) in enumerate(zip(node.inputs, codes, strict=True)):
            name = procedure.temporary()
            text = code.text if is_scalar(variable.type) else copied(code.text, variable.type)
            procedure.line(f"{name} = {text}")
            codes[number] = code._replace(text=name)
    for (variable, given), code in zip(node.inputs, codes, strict=True):
        target = f"{instance}.{record.by_key[variable.name.casefold()].slot}"
        if is_scalar(variable.type):
            procedure.line(f"{target} = {stored(code).text}")
        else:
            copy_into(procedure, target, variable.type, code.text)
        note_write(procedure, target, variable.type, argument_entry(procedure, given))


def _edge(procedure: Procedure, instance: str, node: InstanceCall) -> None:
    """R_TRIG and F_TRIG are shorter than their call."""
    code = value(procedure, node.inputs[0][1])
    now = code.text
    if code.simple:
        procedure.line(f"{instance}.CLK = {now}")
    else:
        now = procedure.temporary()
        procedure.line(f"{instance}.CLK = {now} = {stored(code).text}")
    if node.block.name == "R_TRIG":
        procedure.line(f"{instance}.Q = {now} and not {instance}._before")
    else:
        procedure.line(f"{instance}.Q = not {now} and {instance}._before")
    procedure.line(f"{instance}._before = {now}")


def _on_delay(procedure: Procedure, instance: str, node: InstanceCall) -> bool:
    """TON is called only while its input is TRUE; else there is nothing to do but to reset it.

    False, and nothing written, if the inputs do not allow that.
    """
    names = [variable.name for variable, _ in node.inputs]
    if names not in (["IN"], ["IN", "PT"]) or node.instance.type.name != "TON":
        return False
    if "ton" in procedure.context.facts.turned:
        return False
    codes = [value(procedure, one) for _, one in node.inputs]
    if not all(code.safe for code in codes) or not _can_store_at_once(procedure, node, codes):
        return False
    for code in codes[1:]:
        procedure.line(f"{instance}.PT = {code.text}")
    procedure.line(f"if {condition(procedure, node.inputs[0][1])}:")
    procedure.line(f"    {instance}.IN = True")
    procedure.line(f"    {instance}._ton()")
    procedure.line("else:")
    procedure.line(f"    {instance}.IN = {instance}.Q = False")
    procedure.line(f"    {instance}.ET = 0")
    procedure.line(f"    {instance}._start = None")
    return True
