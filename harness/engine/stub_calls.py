"""A call that a stub carries out: what it gets, and what it may give."""

from collections.abc import Mapping

from fbgen.lang.checked import WORKS, Program, RoutineCall
from fbgen.lang.checker.types.literals import default_value
from fbgen.lang.types import INT, VOID, WORD, ArrayType, Elementary, StringType, StructType, Type
from harness.engine.faults import not_modelled, too_many_bytes, unknown_output, wrong_result
from harness.engine.interface import Value
from harness.engine.layout import S7
from harness.engine.model_calls import call_model
from harness.engine.stubbed_instructions import octets
from harness.engine.stubs import Stubs, StubState
from harness.engine.values import accept

RESULT = "RET_VAL"
_ERROR = 0x8000


def call_stub(
    program: Program,
    stubs: Stubs,
    node: RoutineCall,
    inputs: Mapping[str, Value],
    state: StubState | None,
) -> dict[str, Value]:
    """What the stub gives, by casefolded name and with values of the types asked for.

    Without a stub the controller's own model carries it out. Raises FB6070 where there is neither,
    FB6071 and FB6021 for what a stub gives.
    """
    stub = stubs.find(node.name)
    if stub is None and state is not None and (model := stubs.models.get(node.name)):
        return call_model(node, state.model_of(model), inputs)
    if stub is None:
        raise not_modelled(node)
    action = stub if state is None else state.action_of(stub)
    given = action(**inputs)
    key = RESULT.casefold()
    if isinstance(given, Mapping) and (node.instance is not None or not _is_result(node, given)):
        results = _by_name(program, node, given, inputs)
    elif given is None:
        results = {}
    elif node.type == VOID:
        raise wrong_result(node, given)
    else:
        results = {key: accept(program, node.name, node.type, given)}
    if isinstance(node.type, Elementary | StringType) and node.type != VOID:
        results.setdefault(key, default_value(node.type))
    elif node.type != VOID and key not in results:
        raise wrong_result(node, given)
    return results


def with_eno(node: RoutineCall, results: Mapping[str, Value]) -> Mapping[str, Value]:
    """What a call gives together with ENO, if that is asked for.

    Who carries the call out may have said it; else it works unless RET_VAL is an error.
    """
    key = WORKS.casefold()
    if key in results or all(name != WORKS for name, _ in node.outputs):
        return results
    status = results.get(RESULT.casefold(), 0)
    is_bad = node.type in (INT, WORD) and isinstance(status, int) and status & _ERROR != 0
    return {**results, key: not is_bad}


def _is_result(node: RoutineCall, given: Mapping[object, object]) -> bool:
    """True for a mapping that is a structure, the result of the call itself."""
    names = {str(name).casefold() for name in given}
    outputs = {name.casefold() for name, _ in node.outputs} | {RESULT.casefold()}
    return isinstance(node.type, StructType) and not names & outputs


def _by_name(
    program: Program,
    node: RoutineCall,
    given: Mapping[object, object],
    inputs: Mapping[str, Value],
) -> dict[str, Value]:
    kinds = _kinds(program, node)
    kept = {name.casefold(): value for name, value in inputs.items()}
    accepted: dict[str, Value] = {}
    for name, value in given.items():
        key = str(name).casefold()
        kind = kinds.get(key)
        if isinstance(kind, ArrayType | StructType) and isinstance(value, str | bytes):
            accepted[key] = _area(node, kind, value, kept.get(key))
        elif kind is not None:
            accepted[key] = accept(program, f"{node.name}.{name}", kind, value)
        elif str(name).upper() != RESULT:
            known = [one for one, _ in node.outputs]
            raise unknown_output(node, str(name), known)
    return accepted


def _area(node: RoutineCall, kind: Type, given: str | bytes, before: Value | None) -> Value:
    """An area of the program with the bytes of the stub; behind them it stays as it was."""
    data, size = octets(node.name, given, node.span), S7.size_bytes(kind)
    if len(data) > size:
        raise too_many_bytes(node, len(data), size)
    rest = bytes(size) if before is None else S7.encode(kind, before)
    return S7.decode(kind, data + rest[len(data) :])


def _kinds(program: Program, node: RoutineCall) -> dict[str, Type]:
    """The types of what the stub may give. A call need not take every output of a block."""
    kinds: dict[str, Type] = {}
    if node.instance is not None:
        block = program.block_of(node.instance.type.name)
        kinds = {variable.name.casefold(): variable.type for variable in block.variables}
    if node.type != VOID:
        kinds[RESULT.casefold()] = node.type
    kinds |= {name.casefold(): place.type for name, place in node.outputs}
    return kinds
