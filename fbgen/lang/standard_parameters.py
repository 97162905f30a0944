"""Calls of standard functions with and without the names of their parameters.

S7 wants them: TIA Portal help, "Calling functions" and the lists of instructions: a function with
more than one parameter is called with names. To TwinCAT and CODESYS SHL, MAX, SEL and the like are
operators, whose operands have no names: Beckhoff Information System, "Bit-shift operators".
"""

from fbgen.lang.ast import Argument, ArgumentKind, Call, Name

STANDARD = {
    **dict.fromkeys(("SHL", "SHR", "ROL", "ROR"), ("IN", "N")),
    **dict.fromkeys(("LEFT", "RIGHT"), ("IN", "L")),
    **dict.fromkeys(("CONCAT", "FIND"), ("IN1", "IN2")),
    **{name: tuple(f"IN{number}" for number in range(1, 33)) for name in ("MAX", "MIN")},
    "LIMIT": ("MN", "IN", "MX"),
    "SEL": ("G", "IN0", "IN1"),
    "MUX": ("K", *(f"IN{number}" for number in range(32))),
    "MID": ("IN", "L", "P"),
    "INSERT": ("IN1", "IN2", "P"),
    "DELETE": ("IN", "L", "P"),
    "REPLACE": ("IN1", "IN2", "L", "P"),
}
"""The controller's functions of several parameters, by their upper-case names."""


def with_names(call: Call, names: tuple[str, ...]) -> Call:
    """The call with names in front of its arguments; itself if it has names already."""
    arguments = call.arguments
    if len(arguments) > len(names) or any(
        item.kind is not ArgumentKind.POSITIONAL for item in arguments
    ):
        return call
    named = tuple(
        Argument(item.span, ArgumentKind.INPUT, name, item.value, item.leading, item.trailing)
        for name, item in zip(names, arguments, strict=False)
    )
    return Call(call.span, call.callee, named)


def standard_with_names(call: Call) -> Call:
    """The same for a call of one of the controller's functions; any other call comes back."""
    callee = call.callee
    names = STANDARD.get(callee.name.upper()) if isinstance(callee, Name) else None
    return call if names is None else with_names(call, names)


def standard_without_names(call: Call) -> Call:
    """A call of one of the functions with its arguments by position; any other call comes back."""
    callee = call.callee
    names = STANDARD.get(callee.name.upper()) if isinstance(callee, Name) else None
    given = {one.name.upper(): one for one in call.arguments}
    wanted = names[: len(call.arguments)] if names else ()
    if not wanted or set(given) != set(wanted):
        return call
    arguments = tuple(
        Argument(one.span, ArgumentKind.POSITIONAL, "", one.value, one.leading, one.trailing)
        for one in (given[name] for name in wanted)
    )
    return Call(call.span, call.callee, arguments)
