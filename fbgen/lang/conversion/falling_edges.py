"""F_TRIG at the start, which is not the same on S7 and in IEC 61131-3.

Where CLK is FALSE in the first call, F_TRIG fires in IEC and does not on S7. So what goes from one
to the other takes its own F_TRIG along as a block.
Sources: IEC 61131-3 third edition, table 44; TIA Portal help, "F_TRIG".
"""

from collections.abc import Mapping, Sequence
from typing import ClassVar

from fbgen.lang.ast import Block, File, NamedType, TypeDeclaration, Unit
from fbgen.lang.parser import parse
from fbgen.lang.rewriting import Rewriter, Rule
from fbgen.source import Source

_FALLING = "F_TRIG"
_OF_S7 = """\
// F_TRIG as on S7: no edge in the first call.
FUNCTION_BLOCK "{name}"
VAR_INPUT
  CLK : Bool;
END_VAR
VAR_OUTPUT
  Q : Bool;
END_VAR
VAR
  before : Bool;
END_VAR
BEGIN
  #Q := #before AND NOT #CLK;
  #before := #CLK;
END_FUNCTION_BLOCK
"""
_OF_IEC = """\
(* F_TRIG of IEC 61131-3: CLK = FALSE in the first call is an edge. *)
FUNCTION_BLOCK {name}
VAR_INPUT
  CLK : BOOL;
END_VAR
VAR_OUTPUT
  Q : BOOL;
END_VAR
VAR
  wasFalse : BOOL;
END_VAR
Q := NOT CLK AND NOT wasFalse;
wasFalse := NOT CLK;
END_FUNCTION_BLOCK
"""
_BLOCKS = {"tia": ("F_TRIG_S7", _OF_S7), "iec": ("F_TRIG_IEC", _OF_IEC)}


def with_own_falling_edges(files: Sequence[File], target: str) -> list[File]:
    """The files with a block of their own for F_TRIG, where the other dialect has another one."""
    dialect = files[0].dialect
    on_s7 = ("tia", "step7")
    if (dialect in on_s7) == (target in on_s7) or dialect == "step7":
        return list(files)
    wanted, text = _BLOCKS["tia" if dialect == "tia" else "iec"]
    taken = {key for file in files for unit in file.units if (key := _name_of(unit))}
    if dialect != "tia" and _FALLING.casefold() in taken:
        return list(files)  # the block of that name is the user's
    names = (wanted, *(f"{wanted}_{number}" for number in range(2, len(taken) + 3)))
    name = next(one for one in names if one.casefold() not in taken)
    rewriter = _Renaming(name, quoted=dialect == "tia")
    changed = [_rewritten(file, rewriter) for file in files]
    users = [number for number, file in enumerate(changed) if file is not files[number]]
    if users:
        first = changed[users[0]]
        own = parse(Source(name, text.format(name=name)), dialect).units
        changed[users[0]] = File(first.source, dialect, (*own, *first.units), first.closing)
    return changed


def _rewritten(file: File, rewriter: "_Renaming") -> File:
    units = tuple(rewriter.rewrite(unit) for unit in file.units)
    if all(new is old for new, old in zip(units, file.units, strict=True)):
        return file
    return File(file.source, file.dialect, units, file.closing)


def _name_of(unit: Unit) -> str:
    return unit.name.name.casefold() if isinstance(unit, Block | TypeDeclaration) else ""


class _Renaming(Rewriter):
    """F_TRIG under another name."""

    def __init__(self, name: str, quoted: bool) -> None:
        self._name = name
        self._quoted = quoted

    def _type(self, node: NamedType) -> NamedType:
        if node.quoted or node.name.upper() != _FALLING:
            return node
        return NamedType(node.span, self._name, self._quoted)

    rules: ClassVar[Mapping[type, Rule]] = {NamedType: _type}
