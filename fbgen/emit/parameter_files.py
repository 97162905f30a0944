"""The parameter block in a file of its own, so that it can belong to the user.

* tia: a data block as any other.
* step7: a source of its own, and behind it one with what uses it: STEP 7 compiles a call only when
  the data block is there. So there are three sources, compiled in their order.
* twincat: a list of global variables of its own. It is not called like the variable in it, for
  `list.x` means a variable of a list.
* iec and plcopen have one text: there the values come from the plant file each time.
"""

from collections.abc import Sequence
from dataclasses import replace

from fbgen.lang import ast
from fbgen.plant import Plant, with_prefix

PARAMETERS = "TOS_Parameters"
PARAMETER_LIST = "TOS_ParameterList"
"""The data block, and the list of TwinCAT that it stands in."""


def split_at_parameters(
    files: Sequence[ast.File], plant: Plant
) -> tuple[list[ast.File], ast.File, list[ast.File]]:
    """What stands in front of the file with the parameter block, that file, what is behind it."""
    name = with_prefix(PARAMETERS, plant.prefix)
    index = next(
        index
        for index, file in enumerate(files)
        if any(isinstance(unit, ast.DataBlock) and unit.name.name == name for unit in file.units)
    )
    return list(files[:index]), files[index], list(files[index + 1 :])


def with_parameter_list(files: Sequence[ast.File], plant: Plant) -> list[ast.File]:
    """The parameter block of TwinCAT in a list of its own, behind the other variables."""
    return [
        replace(file, units=tuple(part for unit in file.units for part in _split(unit, plant)))
        for file in files
    ]


def _split(unit: ast.Unit, plant: Plant) -> tuple[ast.Unit, ...]:
    if not isinstance(unit, ast.Globals):
        return (unit,)
    name = with_prefix(PARAMETERS, plant.prefix)
    declarations = unit.section.declarations
    own = tuple(one for one in declarations if one.names[0].name == name)
    if not own:
        return (unit,)
    others = tuple(one for one in declarations if one not in own)
    mine = replace(unit.section, declarations=own)
    rest = replace(unit, section=replace(unit.section, declarations=others))
    return rest, replace(unit, section=mine, name=with_prefix(PARAMETER_LIST, plant.prefix))
