"""Random PLC programs that the checker accepts, as text, for comparing engines.

A program is one function block with variables of all kinds, an inner block and a function of its
own. Expressions are typed on the way down, so that every program checks. A few programs run into a
fault: a division by zero, an index out of range, too many loop passes.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

from hypothesis import strategies as st
from plc_declarations import ARRAY_TYPES, BITS, REALS, SIGNED, TYPES, UNSIGNED, WIDTHS, declarations


@dataclass
class Writer:
    """Draws one program. `mark` is what stands in front of local names."""

    draw: Callable[..., object]
    mark: str
    loops: int = 0
    labels: list[str] = field(default_factory=list)
    types: tuple[str, ...] = TYPES
    label_count: int = 0
    writable: dict[str, list[str]] = field(default_factory=dict)
    readable: dict[str, list[str]] = field(default_factory=dict)

    def one_of(self, options: Sequence[str]) -> str:
        """One of some texts."""
        return str(self.draw(st.sampled_from(list(options))))

    def number(self, first: int, last: int) -> int:
        """A whole number between two bounds, both included."""
        number = self.draw(st.integers(first, last))
        assert isinstance(number, int)
        return number

    # --- expressions --------------------------------------------------------------------------

    def literal(self, kind: str) -> str:
        """A typed constant."""
        if kind == "BOOL":
            return self.one_of(("TRUE", "FALSE"))
        if kind == "TIME":
            return f"T#{self.number(0, 5000)}ms"
        if kind == "STRING":
            return f"'{self.one_of(('', 'a', 'abc', 'xyzabc'))}'"
        if kind in REALS:
            text = self.one_of(("0.0", "1.0", "-2.5", "0.1", "3.0E38", "1.0E-30", "123456.789"))
            return f"{kind}#{text}"
        width = WIDTHS[kind]
        if kind in BITS:
            return f"{kind}#16#{self.number(0, (1 << width) - 1):X}"
        low = -(1 << (width - 1)) + 1 if kind in SIGNED else 0
        high = (1 << (width - 1)) - 1 if kind in SIGNED else (1 << width) - 1
        small = self.number(max(low, -9), 9)
        return f"{kind}#{self.draw(st.sampled_from([small, low, high, high // 3]))}"

    def variable(self, kind: str) -> str:
        """A variable, an element or a part of the type; the index is rarely out of range."""
        if kind in ARRAY_TYPES and self.number(0, 39) == 39:
            index = self.one_of((f"{self.mark}i", f"{self.mark}i MOD 3", f"{self.mark}guard"))
            return f"{self.mark}list{kind[0]}{kind[1:].lower()}[{index}]"
        return self.one_of(self.readable[kind])

    def expression(self, kind: str, depth: int) -> str:
        """Some expression of the type."""
        if depth <= 0 or self.number(0, 5) == 0:
            return self.variable(kind) if self.number(0, 3) else self.literal(kind)
        choices = [self._choice, self._function, self._conversion]
        if kind == "BOOL":
            choices += [self._logic, self._comparison, self._comparison]
        elif kind in BITS:
            choices += [self._logic, self._shift]
        elif kind == "STRING":
            choices = [self._choice, self._text]
        elif kind == "TIME":
            choices += [self._duration, self._duration]
        else:
            choices += [self._arithmetic] * 4
        return choices[self.number(0, len(choices) - 1)](kind, depth - 1)

    def _logic(self, kind: str, depth: int) -> str:
        operators = ("AND", "OR", "XOR", "NOT")
        if kind == "BOOL" and not self.mark:
            operators += ("AND_THEN", "OR_ELSE")
        operator = self.one_of(operators)
        left = self.expression(kind, depth)
        if operator == "NOT":
            return f"(NOT {left})"
        return f"({left} {operator} {self.expression(kind, depth)})"

    def _comparison(self, kind: str, depth: int) -> str:
        compared = self.one_of(self.types)
        operators = ("=", "<>") if compared == "BOOL" else ("=", "<>", "<", ">", "<=", ">=")
        left, right = self.expression(compared, depth), self.expression(compared, depth)
        return f"({left} {self.one_of(operators)} {right})"

    def _arithmetic(self, kind: str, depth: int) -> str:
        operators = ["+", "-", "*", "/"]
        if kind not in REALS:
            operators.append("MOD")
        operator = self.one_of(operators)
        left = self.expression(kind, depth)
        right = self._divisor(kind) if operator in ("/", "MOD") else self.expression(kind, depth)
        if kind not in UNSIGNED and self.number(0, 5) == 0:
            left = f"(-{left})"
        return f"({left} {operator} {right})"

    def _divisor(self, kind: str) -> str:
        """Rarely zero, and never a constant zero."""
        match self.number(0, 29):
            case 29:
                return self.variable(kind)
            case 27 | 28:
                one = f"{kind}#1.0" if kind in REALS else f"{kind}#1"
                return f"MAX(IN1 := {self.variable(kind)}, IN2 := {one})"
            case _:
                number = self.number(1, 9) * (1 if kind in UNSIGNED else self.number(0, 1) * 2 - 1)
                return f"{kind}#{number}.5" if kind in REALS else f"{kind}#{number}"

    def _duration(self, kind: str, depth: int) -> str:
        left = self.expression("TIME", depth)
        match self.number(0, 3):
            case 0:
                return f"({left} + {self.expression('TIME', depth)})"
            case 1:
                return f"({left} - {self.expression('TIME', depth)})"
            case 2:
                return f"({left} * {self.expression(self.one_of(('INT', 'REAL')), depth)})"
            case _:
                return f"({left} / {self._divisor(self.one_of(('INT', 'REAL')))})"

    def _shift(self, kind: str, depth: int) -> str:
        name = self.one_of(("SHL", "SHR", "ROL", "ROR"))
        return f"{name}(IN := {self.expression(kind, depth)}, N := {self.expression('INT', 0)})"

    def _choice(self, kind: str, depth: int) -> str:
        first, second = self.expression(kind, depth), self.expression(kind, depth)
        if self.number(0, 3) == 0:
            selector = self.one_of(("0", "1", "1", "0", "1", self.variable("INT")))
            return f"MUX(K := {selector}, IN0 := {first}, IN1 := {second})"
        return f"SEL(G := {self.expression('BOOL', depth)}, IN0 := {first}, IN1 := {second})"

    def _function(self, kind: str, depth: int) -> str:
        operand = self.expression(kind, depth)
        if kind in REALS:
            name = self.one_of(("ABS", "SQRT", "SIN", "EXP", "LN", "MAX", "LIMIT"))
        elif kind in BITS or kind in ("BOOL", "TIME"):
            name = "SEL" if kind == "BOOL" else self.one_of(("MAX", "LIMIT"))
        else:
            name = self.one_of(("ABS", "MIN", "MAX", "LIMIT"))
        if name == "SEL":
            return self._choice(kind, depth)
        if name in ("MIN", "MAX"):
            return f"{name}(IN1 := {operand}, IN2 := {self.expression(kind, depth)})"
        if name == "LIMIT":
            low, high = self.expression(kind, 0), self.expression(kind, 0)
            return f"LIMIT(MN := {low}, IN := {operand}, MX := {high})"
        return f"{name}({operand})"

    def _conversion(self, kind: str, depth: int) -> str:
        whole = self._known((*SIGNED, *UNSIGNED))
        bits, reals = self._known(BITS), self._known(REALS)
        if kind == "BOOL":
            source = self.one_of((*bits, *whole))
        elif kind in REALS:
            source = self.one_of((*whole, *(real for real in reals if real != kind)))
        elif kind == "TIME":
            source = "DINT"
        elif kind in BITS:
            source = self.one_of(tuple(one for one in (*whole, *bits, "BOOL") if one != kind))
        else:
            source = self.one_of(tuple(one for one in (*whole, *bits, *reals) if one != kind))
        return f"{source}_TO_{kind}({self.expression(source, depth)})"

    def _known(self, kinds: Sequence[str]) -> tuple[str, ...]:
        return tuple(kind for kind in kinds if kind in self.types)

    def _text(self, kind: str, depth: int) -> str:
        text = self.expression("STRING", depth)
        part = self.expression("STRING", 0)
        length, position = self.number(-1, 7), self.number(-1, 7)
        return self.one_of((
            f"CONCAT(IN1 := {text}, IN2 := {part})",
            f"LEFT(IN := {text}, L := {length})",
            f"RIGHT(IN := {text}, L := {length})",
            f"MID(IN := {text}, L := {length}, P := {position})",
            f"INSERT(IN1 := {text}, IN2 := {part}, P := {position})",
            f"DELETE(IN := {text}, L := {length}, P := {position})",
            f"REPLACE(IN1 := {text}, IN2 := {part}, L := {length}, P := {position})",
            f"INT_TO_STRING({self.expression('INT', depth)})",
        ))  # fmt: skip

    # --- statements ---------------------------------------------------------------------------

    def statements(self, depth: int, indent: str) -> str:
        """One to four statements."""
        return "".join(self.statement(depth, indent) for _ in range(self.number(1, 4)))

    def statement(self, depth: int, indent: str) -> str:
        """Some statement; compound ones only while `depth` lasts."""
        kinds = [self._assignment] * 5 + [self._call, self._jump]
        if self.mark:
            kinds += [self._chain, self._enabled, self._reference, self._open_array]
            kinds += [self._own_error]
        else:
            kinds += [self._named_value, self._limited_value, self._method, self._method]
        if self.mark and depth > 0:
            kinds += [self._labelled, self._repeated_by_jump]
        if depth > 0:
            kinds += [self._if, self._if, self._case, self._for, self._while, self._repeat]
        return kinds[self.number(0, len(kinds) - 1)](depth - 1, indent)

    def _assignment(self, depth: int, indent: str) -> str:
        kind = self.one_of(self.types)
        target = self.one_of(self.writable[kind])
        return f"{indent}{target} := {self.expression(kind, 3)};\n"

    def _reference(self, depth: int, indent: str) -> str:
        """A reference is bound, rarely to nothing, or handed to a function beside an in-out."""
        target = self.one_of(self.writable["INT"])
        match self.number(0, 11):
            case 0:
                return f"{indent}#toInt := NULL;\n"
            case 1 | 2 | 3:
                own = [one for one in self.writable["INT"] if "^" not in one]
                return f"{indent}#toInt := REF({self.one_of(own)});\n"
            case 4 | 5:
                return f"{indent}#toFrame := REF(#frames[{self.number(1, 2)}]);\n"
            case 6 | 7:
                same = self.one_of(("#toInt = REF(#statInt)", "#toInt = NULL", "#toInt <> #other"))
                return f"{indent}{self.one_of(self.writable['BOOL'])} := {same};\n"
            case 8:
                return f"{indent}#other := #toInt;\n"
            case _:
                value = self.expression("INT", 1)
                return f'{indent}"Through"(one := {target}, also := #toInt, value := {value});\n'

    def _own_error(self, depth: int, indent: str) -> str:
        """The block asks for its errors, or does what may be one; without the question it stops."""
        match self.number(0, 5):
            case 0 | 1 | 2:
                return f"{indent}#statWord := GET_ERR_ID();\n"
            case 3:
                return f"{indent}IF GET_ERR_ID() = 16#2522 THEN #guard := #guard + 1; END_IF;\n"
            case 4:
                target = self.one_of(self.writable["INT"])
                return f"{indent}{target} := #listInt[#i] + {self.expression('INT', 1)};\n"
            case _:
                return f"{indent}#listInt[#k] := {self.expression('INT', 2)};\n"

    def _open_array(self, depth: int, indent: str) -> str:
        """Arrays of several lengths for one parameter; the index is often out of range."""
        array = self.one_of(("#listInt", "#listInt", "#short"))
        index = f"{self.one_of(self.readable['INT'])} MOD 4"
        target = self.one_of(self.writable["INT"])
        if self.number(0, 3):
            index = str(self.number(1, 3) if array == "#listInt" else self.number(-1, 0))
        value = self.expression("INT", 1)
        return f'{indent}{target} := "Put"(list := {array}, at := {index}, value := {value});\n'

    def _named_value(self, depth: int, indent: str) -> str:
        """An enumeration is assigned, chosen, or selects."""
        condition, target = self.expression("BOOL", 1), self.one_of(self.writable["INT"])
        match self.number(0, 3):
            case 0:
                return f"{indent}statMode := SEL({condition}, typeMode#off, fast);\n"
            case 1:
                return f"{indent}IF statMode <> slow THEN statMode := slow; END_IF;\n"
            case 2:
                return f"{indent}{target} := TO_INT(statMode);\n"
            case _:
                first, second = self.expression("INT", 1), self.expression("INT", 1)
                return (
                    f"{indent}CASE statMode OF\n{indent}  off, fast: {target} := {first};\n"
                    f"{indent}ELSE {target} := {second};\n{indent}END_CASE;\n"
                )

    def _limited_value(self, depth: int, indent: str) -> str:
        """A subrange is assigned; rarely what it does not allow, and never a constant."""
        value = f"({self.variable('INT')} + {self.expression('INT', 1)})"
        if self.number(0, 9):
            value = f"LIMIT(0, {value}, {self.one_of(('100', '100', '101'))})"
        return f"{indent}statLevel := {value};\n"

    def _chain(self, depth: int, indent: str) -> str:
        """Several targets in one statement, with whole numbers of one or two types."""
        first, last = self.one_of(self.writable["DINT"]), self.one_of(self.writable["INT"])
        middle = self.one_of(self.writable["INT"])
        sign = self.one_of((":=", "+=", "-=", "*="))
        return f"{indent}{first} := {middle} {sign} {last} := {self.expression('INT', 2)};\n"

    def _method(self, depth: int, indent: str) -> str:
        """Methods, a property and an action, of the block itself and of the inner one."""
        value, target = self.expression("INT", 1), self.one_of(self.writable["INT"])
        place = self.one_of(self.writable["INT"])
        match self.number(0, 5):
            case 0:
                return f"{indent}instInner.Total := {value};\n"
            case 1:
                return (
                    f"{indent}{target} := instInner.Total + Touch(amount := 1, place := {place});\n"
                )
            case 2:
                return f"{indent}instInner.Reset();\n"
            case 3:
                return f"{indent}{target} := instInner.Bump(amount := {value}, place := {place});\n"
            case 4:
                head = f"{indent}IF Touch(amount := {value}, place := {place}) > statInt THEN\n"
                body = self.statements(0, indent + "    ")
                return f"{head}{body}{indent}END_IF;\n"
            case _:
                return f"{indent}{target} := THIS^.Touch(amount := {value}, place := {place});\n"

    def _enabled(self, depth: int, indent: str) -> str:
        """A call with EN and ENO, of the function, the inner block or a conversion."""
        enable, ok = self.expression("BOOL", 1), self.one_of(self.writable["BOOL"])
        value, target = self.expression("INT", 2), self.one_of(self.writable["INT"])
        match self.number(0, 2):
            case 0:
                place = self.one_of(self.writable["DINT"])
                call = f'{target} := "Twice"(EN := {enable}, value := {value}, total := {place}'
            case 1:
                call = f"#instInner(EN := {enable}, value := {value}, place := {target}"
            case _:
                source = self.one_of(("DINT", "REAL", "LREAL", "UINT"))
                call = f"{target} := {source}_TO_INT(IN := {self.expression(source, 2)}"
        return f"{indent}{call}, ENO => {ok});\n"

    def _new_label(self) -> str:
        self.label_count += 1
        return f"label{self.label_count}"

    def _labelled(self, depth: int, indent: str) -> str:
        """Statements with a label behind them that they may jump to."""
        label = self._new_label()
        self.labels.append(label)
        # A label that nobody jumps to would be one of CASE inside of its arms.
        body = f"{indent}IF {self.expression('BOOL', 1)} THEN GOTO {label}; END_IF;\n"
        body += self.statements(depth, indent)
        self.labels.remove(label)
        return f"{body}{indent}{label}: ;\n"

    def _repeated_by_jump(self, depth: int, indent: str) -> str:
        """A loop without a keyword, which EXIT does not know."""
        label, counter = self._new_label(), f"{self.mark}guard"
        body = self.statements(depth, indent)
        condition = self.expression("BOOL", 1)
        return (
            f"{indent}{label}: {counter} := {counter} + 1;\n{body}"
            f"{indent}IF {counter} < 45 AND {condition} THEN\n{indent}    GOTO {label};\n"
            f"{indent}END_IF;\n"
        )

    def _call(self, depth: int, indent: str) -> str:
        mark = self.mark
        signal = self.expression("BOOL", 1)
        twice = '"Twice"' if mark else "Twice"
        match self.number(0, 5):
            case 0:
                preset = self.expression("TIME", 1)
                name = self.one_of(("instOn", "instOff", "instPulse"))
                target = self.one_of(self.writable["BOOL"])
                return f"{indent}{mark}{name}(IN := {signal}, PT := {preset}, Q => {target});\n"
            case 1:
                name = self.one_of(("instRise", "instFall"))
                return f"{indent}{mark}{name}(CLK := {signal});\n"
            case 2:
                reset, preset = self.expression("BOOL", 1), self.expression("INT", 0)
                target = self.one_of(self.writable["INT"])
                return (
                    f"{indent}{mark}instCount(CU := {signal}, R := {reset}, PV := {preset}, "
                    f"CV => {target});\n"
                )
            case 3:
                target = self.one_of(self.writable["INT"])
                value = self.expression("INT", 2)
                place = self.one_of(self.writable["DINT"])
                return f"{indent}{target} := {twice}(value := {value}, total := {place});\n"
            case _:
                value, place = self.expression("INT", 2), self.one_of(self.writable["INT"])
                target = self.one_of(self.writable["INT"])
                return (
                    f"{indent}{mark}instInner(value := {value}, place := {place}, "
                    f"sum => {target});\n"
                )

    def _jump(self, depth: int, indent: str) -> str:
        condition = self.expression("BOOL", 1)
        jumps = ("EXIT", "CONTINUE", "RETURN") if self.loops else ("RETURN",)
        jumps = (*jumps, *(f"GOTO {label}" for label in self.labels))
        return f"{indent}IF {condition} THEN\n{indent}    {self.one_of(jumps)};\n{indent}END_IF;\n"

    def _if(self, depth: int, indent: str) -> str:
        inner = indent + "    "
        text = f"{indent}IF {self.expression('BOOL', 2)} THEN\n{self.statements(depth, inner)}"
        for _ in range(self.number(0, 2)):
            condition = self.expression("BOOL", 2)
            text += f"{indent}ELSIF {condition} THEN\n{self.statements(depth, inner)}"
        if self.number(0, 1):
            text += f"{indent}ELSE\n{self.statements(depth, inner)}"
        return f"{text}{indent}END_IF;\n"

    def _case(self, depth: int, indent: str) -> str:
        inner = indent + "        "
        # A subrange alone takes only labels of its own range.
        text = f"{indent}CASE {self.expression('INT', 2)} + 0 OF\n"
        start = self.number(-3, 3)
        for _ in range(self.number(1, 3)):
            end = start + self.number(0, 3)
            label = f"{start}..{end}" if end > start else f"{start}"
            text += f"{indent}    {label}:\n{self.statements(depth, inner)}"
            start = end + self.number(1, 2)
        if self.number(0, 1):
            text += f"{indent}ELSE\n{self.statements(depth, inner)}"
        return f"{text}{indent}END_CASE;\n"

    def _for(self, depth: int, indent: str) -> str:
        kind = self.one_of(("i", "j", "k"))
        first, step = self.number(-3, 5), self.number(-2, 2) or 1
        last = self.expression("INT", 1) if kind == "i" and self.number(0, 3) == 0 else None
        if kind == "k":
            first, step = self.number(200, 250), abs(step)
            last = str(self.number(250, 255))
        text = f"{indent}FOR {self.mark}{kind} := {first} TO {last or self.number(-3, 5)}"
        text += f" BY {step} DO\n" if step != 1 else " DO\n"
        return f"{text}{self._body(depth, indent)}{indent}END_FOR;\n"

    def _while(self, depth: int, indent: str) -> str:
        counter = f"{self.mark}guard"
        condition = self.expression("BOOL", 1)
        return (
            f"{indent}WHILE {counter} < 50 AND {condition} DO\n"
            f"{indent}    {counter} := {counter} + 1;\n"
            f"{self._body(depth, indent)}{indent}END_WHILE;\n"
        )

    def _repeat(self, depth: int, indent: str) -> str:
        counter = f"{self.mark}guard"
        body = self._body(depth, indent)
        return (
            f"{indent}REPEAT\n{indent}    {counter} := {counter} + 1;\n{body}"
            f"{indent}UNTIL {counter} > 40 OR {self.expression('BOOL', 1)}\n{indent}END_REPEAT;\n"
        )

    def _body(self, depth: int, indent: str) -> str:
        self.loops += 1
        body = self.statements(depth, indent + "    ")
        self.loops -= 1
        return body

    # --- the whole ----------------------------------------------------------------------------

    def program(self) -> str:
        """The text of the program; the block to run is `Outer`."""
        self.name_variables()
        mark = self.mark
        self.readable["BOOL"].append(f"{mark}instFall.Q")
        if mark:
            for places in (self.writable, self.readable):
                places["INT"] += ["#toInt^", "#toFrame^.intPart"]
        else:
            self.readable["INT"].append("statLevel")
            self.readable["BOOL"].append("(statMode = fast)")
        body = self.statements(3, "    ")
        return declarations(mark) + body + "END_FUNCTION_BLOCK\n"

    def name_variables(self) -> None:
        """The variables that programs of all kinds have, by their types."""
        mark = self.mark
        for kind in self.types:
            name = kind[0].upper() + kind[1:].lower()
            places = [f"{mark}stat{name}", f"{mark}out{name}"]
            if kind in ARRAY_TYPES:
                places += [f"{mark}list{name}[{index}]" for index in (1, 2, 3)]
            if kind in ("INT", "REAL"):
                places += [f"{mark}frame.{kind.lower()}Part", f"{mark}frames[2].{kind.lower()}Part"]
            self.writable[kind] = places
            self.readable[kind] = [*places, f"{mark}in{name}"]
        self.readable["BOOL"] += [f"{mark}instOn.Q", f"{mark}instOff.Q", f"{mark}instCount.Q"]
        self.readable["TIME"].append(f"{mark}instPulse.ET")
        if mark:
            self.writable["BOOL"] += [f"{mark}statWord.%X3", f"{mark}statDint.%X31"]
            self.writable["BYTE"].append(f"{mark}statDword.%B2")


@st.composite
def program_texts(draw: Callable[..., object], dialect: str) -> str:
    """The text of a program in `tia` or `iec`."""
    return Writer(draw, "#" if dialect == "tia" else "").program()
