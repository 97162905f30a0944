"""Temporaries, results and outputs of functions that are read before anything has set them.

On S7 these hold whatever was in the memory before: TIA Portal help, "Temporary local data". IEC
61131-3 gives them their defaults, so only the S7 dialects are looked at. The start
information of an organization block is there before it runs.
"""

from fbgen.lang.analysis.report import Report
from fbgen.lang.ast import BlockKind
from fbgen.lang.checked import Block, Program, Variable, VariableKind
from fbgen.lang.start_information import start_places
from fbgen.lang.types import AnyType, BlockType
from fbgen.source import Span

_WITHOUT_DEFAULTS = ("tia", "step7")


def tracked_variables(block: Block, program: Program) -> dict[Variable, int]:
    """The variables that begin with no value and that only their names reach, a bit for each."""
    if program.dialect not in _WITHOUT_DEFAULTS:
        return {}
    kinds = {VariableKind.TEMP, VariableKind.RESULT}
    if block.kind is BlockKind.FUNCTION:
        kinds.add(VariableKind.OUTPUT)
    handed = {variable for variable, _ in start_places(block)}
    tracked = [
        variable
        for variable in block.variables
        if variable.kind in kinds
        and variable not in handed
        and variable.initial is None
        and variable not in program.byte_memory
        and not isinstance(variable.type, BlockType | AnyType)
    ]
    return {variable: 1 << place for place, variable in enumerate(tracked)}


class UnsetReads:
    """The first read of each variable that not every path to it has set."""

    __slots__ = ("_found", "_loops", "_report")

    def __init__(self, report: Report) -> None:
        self._report = report
        self._found: dict[Variable, tuple[Span, bool]] = {}
        self._loops: list[frozenset[Variable]] = []

    def read(self, variable: Variable, span: Span, on_some_path: bool) -> None:
        """A read of something that not every path has set."""
        self._found.setdefault(variable, (span, on_some_path))

    def enter_loop(self) -> None:
        """What is read from here on may have been set by an earlier pass."""
        self._loops.append(frozenset(self._found))

    def leave_loop(self, written: set[Variable]) -> None:
        """`written` is what the passes of the loop set."""
        before = self._loops.pop()
        for variable in written - before:
            if variable in self._found:
                self._found[variable] = (self._found[variable][0], True)

    def report_all(self) -> None:
        """FB4206 and FB4207."""
        for variable, (span, on_some_path) in self._found.items():
            what = f"{variable.kind.value} '{variable.name}'"
            if on_some_path:
                self._report.warning(
                    "FB4207",
                    f"{what} is read here, but not every way to this place has set it",
                    span,
                    "set it before the condition or loop, or in every branch",
                    about=variable,
                )
            else:
                self._report.warning(
                    "FB4206",
                    f"{what} is read before anything has set it",
                    span,
                    "set it first: it does not keep its value between two calls",
                    about=variable,
                )
