"""The program of a block that is tested on its own: what it does not call has no statements.

So little is compiled, and what a run tells of statements it tells of those that could run in it.
"""

from collections import OrderedDict
from dataclasses import replace

from fbgen.lang.checked import Block, FunctionCall, InstanceCall, Program
from harness.engine.compiled.walk import every_node

_KEPT = 32
_programs: OrderedDict[tuple[int, str], tuple[Program, Program]] = OrderedDict()


def program_of(program: Program, name: str) -> Program:
    """A program without methods as one of its blocks needs it; all of it if it has no such block.

    Programs never change, so they are shared: the same one for the same block.
    """
    key = (id(program), name.casefold())
    block = program.blocks.get(key[1])
    if block is None:
        return program
    if key not in _programs:
        needed = _called(program, block)
        bodies = {one: body if one in needed else () for one, body in program.bodies.items()}
        _programs[key] = (program, replace(program, bodies=bodies))
        while len(_programs) > _KEPT:
            _programs.popitem(last=False)
    _programs.move_to_end(key)
    return _programs[key][1]


def _called(program: Program, first: Block) -> set[Block]:
    """The block and all that it calls, and what those call."""
    found: set[Block] = set()
    ahead = [first]
    while ahead:
        block = ahead.pop()
        if block in found:
            continue
        found.add(block)
        for node in every_node(program.bodies.get(block, ())):
            if isinstance(node, FunctionCall):
                ahead.append(node.function)
            elif isinstance(node, InstanceCall) and isinstance(node.block, Block):
                ahead.append(node.block)
    return found
