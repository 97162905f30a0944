"""Random PLC programs of what every dialect can say, for comparing dialects after a conversion.

They leave out ENO, jumps, CONTINUE, references, enumerations, objects, slices as places of outputs
and AND_THEN.
"""

from collections.abc import Callable, Sequence

from hypothesis import strategies as st
from plc_declarations import ARRAY_TYPES, SPELLED, TYPES
from plc_programs import Writer

CLASSIC_TYPES = ("BOOL", "INT", "DINT", "BYTE", "WORD", "DWORD", "REAL", "TIME", "STRING")
"""What S7-300/400 have."""


class PortableWriter(Writer):
    """Draws one program; `types` are those that both dialects have."""

    def _logic(self, kind: str, depth: int) -> str:
        operator = self.one_of(("AND", "OR", "XOR", "NOT"))
        left = self.expression(kind, depth)
        if operator == "NOT":
            return f"(NOT {left})"
        return f"({left} {operator} {self.expression(kind, depth)})"

    def statement(self, depth: int, indent: str) -> str:
        """Some statement; compound ones only while `depth` lasts."""
        kinds = [self._assignment] * 5 + [self._call, self._jump]
        if self.mark:
            kinds.append(self._chain)
        if depth > 0:
            kinds += [self._if, self._if, self._case, self._for, self._while, self._repeat]
        return kinds[self.number(0, len(kinds) - 1)](depth - 1, indent)

    def _jump(self, depth: int, indent: str) -> str:
        condition = self.expression("BOOL", 1)
        jump = self.one_of(("EXIT", "RETURN")) if self.loops else "RETURN"
        return f"{indent}IF {condition} THEN\n{indent}    {jump};\n{indent}END_IF;\n"

    def _call(self, depth: int, indent: str) -> str:
        mark, quote = self.mark, '"' if self.mark else ""
        signal, value = self.expression("BOOL", 1), self.expression("INT", 2)
        target = self.one_of(self.writable["INT"])
        match self.number(0, 4):
            case 0:
                preset = self.expression("TIME", 1)
                name = self.one_of(("instOn", "instOff", "instPulse"))
                place = self.one_of([one for one in self.writable["BOOL"] if "%" not in one])
                return f"{indent}{mark}{name}(IN := {signal}, PT := {preset}, Q => {place});\n"
            case 1 if self.types is TYPES:
                name = self.one_of(("instRise", "instFall"))
                return f"{indent}{mark}{name}(CLK := {signal});\n"
            case 2:
                reset, preset = self.expression("BOOL", 1), self.expression("INT", 0)
                return (
                    f"{indent}{mark}instCount(CU := {signal}, R := {reset}, PV := {preset}, "
                    f"CV => {target});\n"
                )
            case 3:
                place = self.one_of(self.writable["DINT"])
                return (
                    f"{indent}{target} := {quote}Twice{quote}"
                    f"(value := {value}, total := {place});\n"
                )
            case _:
                place = self.one_of(self.writable["INT"])
                return (
                    f"{indent}{mark}instInner(value := {value}, place := {place}, "
                    f"sum => {target});\n"
                )

    def program(self) -> str:
        """The text of the program; the block to run is `Outer`."""
        self.name_variables()
        body = self.statements(3, "    ")
        return _declarations(self.mark, self.types) + body + "END_FUNCTION_BLOCK\n"


def _declarations(mark: str, types: Sequence[str]) -> str:
    """All text up to the statements of `Outer`."""
    quote, begin = ('"', "BEGIN\n") if mark else ("", "")
    names = {kind: kind[0].upper() + kind[1:].lower() for kind in types}

    def section(prefix: str) -> str:
        return "".join(
            f"    {prefix}{name} : {SPELLED.get(kind, kind)};\n" for kind, name in names.items()
        )

    edges = "    instRise : R_TRIG;\n    instFall : F_TRIG;\n"
    rise, narrow = (edges, "USINT") if "USINT" in types else ("", "INT")
    lists = "".join(f"    list{names[kind]} : ARRAY[1..3] OF {kind};\n" for kind in ARRAY_TYPES)
    frame = f"{quote}typeFrame{quote}"
    structure = "STRUCT\n    intPart : INT := 3;\n    realPart : REAL;\nEND_STRUCT;\nEND_TYPE\n"
    return (
        (f"TYPE {frame}\n" if mark else f"TYPE {frame} :\n") + structure
        + f"FUNCTION {quote}Twice{quote} : INT\n"
        "VAR_INPUT value : INT; END_VAR\nVAR_IN_OUT total : DINT; END_VAR\n" + begin
        + f"    {mark}total := {mark}total + {mark}value;\n    {mark}Twice := {mark}value * 2;\n"
        "END_FUNCTION\n"
        f"FUNCTION_BLOCK {quote}Inner{quote}\n"
        "VAR_INPUT value : INT; END_VAR\nVAR_OUTPUT sum : INT; END_VAR\n"
        "VAR_IN_OUT place : INT; END_VAR\nVAR calls : INT; END_VAR\n" + begin
        + f"    {mark}calls := {mark}calls + 1;\n    {mark}place := {mark}place + {mark}value;\n"
        f"    {mark}sum := {mark}sum + {mark}place;\n"
        "END_FUNCTION_BLOCK\n"
        f"FUNCTION_BLOCK {quote}Outer{quote}\n"
        f"VAR_INPUT\n{section('in')}END_VAR\nVAR_OUTPUT\n{section('out')}END_VAR\n"
        f"VAR\n{section('stat')}{lists}    frame : {frame};\n"
        f"    frames : ARRAY[1..2] OF {frame};\n"
        f"    i : INT;\n    j : DINT;\n    k : {narrow};\n    guard : INT;\n"
        f"    instOn : TON;\n    instOff : TOF;\n    instPulse : TP;\n{rise}"
        f"    instCount : CTU;\n    instInner : {quote}Inner{quote};\n"
        "END_VAR\n" + begin + f"    {mark}guard := 0;\n"
    )  # fmt: skip


@st.composite
def portable_texts(draw: Callable[..., object], dialect: str, *, classic: bool) -> str:
    """A program in `tia`, `iec` or `twincat`; `classic` with the types of S7-300/400 only."""
    types = CLASSIC_TYPES if classic else TYPES
    return PortableWriter(draw, "#" if dialect == "tia" else "", types=types).program()
