"""FB_init of an instance that is made from outside: which calls it takes, with which arguments."""

from collections.abc import Iterator, Mapping

from fbgen.lang.checked import Block, Program, VariableKind
from harness.engine.faults import unknown_name
from harness.engine.interface import Value

_RETAINS, _COPIES = "bInitRetains", "bInCopyCode"


def own_starts(
    program: Program, name: str, arguments: Mapping[str, Value]
) -> Iterator[tuple[Block, dict[str, Value]]]:
    """The FB_init of a block and its bases with what each gets. Raises FB6020."""
    members = program.members.get(name.casefold())
    methods = () if members is None else members.starts
    known = {
        variable.name.casefold(): variable.name
        for method in methods
        for variable in method.variables
        if variable.kind is VariableKind.INPUT
    }
    for given in arguments:
        if given.casefold() not in known:
            raise unknown_name(f"argument of {name}.FB_init", given, list(known.values()))
    by_key = {given.casefold(): value for given, value in arguments.items()}
    by_key |= {_RETAINS.casefold(): True, _COPIES.casefold(): False}
    for method in methods:
        yield (
            method,
            {
                variable.name: by_key[variable.name.casefold()]
                for variable in method.variables
                if variable.kind is VariableKind.INPUT and variable.name.casefold() in by_key
            },
        )
