"""What expressions are worth."""

from collections.abc import Callable, Mapping
from dataclasses import replace

from fbgen.diagnostics import DiagnosticError
from fbgen.lang.checked import (
    Attempt,
    Binary,
    BoundOf,
    Constant,
    Convert,
    ElementCount,
    Expression,
    FunctionCall,
    Guarded,
    Place,
    ReferenceTo,
    RoutineCall,
    SameReference,
    SameTypes,
    StandardCall,
    Substituted,
    SystemCall,
    TakenError,
    TypeTest,
    Unary,
)
from fbgen.lang.checker.supplied.system_instructions import ELEMENT_MOVES, INSTRUCTIONS, ON_VARIANTS
from fbgen.lang.types import (
    AnyType,
    ArrayType,
    Scalar,
    StringType,
    StructType,
    refers_to_anything,
)
from harness.engine.environment import Area, Environment
from harness.engine.interface import Value
from harness.engine.local_errors import local_error
from harness.engine.reference.areas import StorageArea
from harness.engine.reference.arithmetic import binary, unary
from harness.engine.reference.attempts import is_bad_calculation, is_right, nothing
from harness.engine.reference.bcd import BIT_FUNCTIONS
from harness.engine.reference.conversion import convert
from harness.engine.reference.date_functions import DATE_FUNCTIONS
from harness.engine.reference.frames import Frame
from harness.engine.reference.functions import NUMERIC_FUNCTIONS, Signature
from harness.engine.reference.memory_instructions import (
    elements,
    move_areas,
    move_elements,
    poke_block,
)
from harness.engine.reference.places import Places
from harness.engine.reference.pointers import Pointed
from harness.engine.reference.stamps import parts_of, stamp_of
from harness.engine.reference.storage import Storage
from harness.engine.reference.text_functions import TEXT_FUNCTIONS
from harness.engine.reference.variants import ON_VARIANTS as ON_VARIANTS_BY_NAME
from harness.engine.reference.variants import ask

STANDARD_FUNCTIONS = {**NUMERIC_FUNCTIONS, **BIT_FUNCTIONS, **TEXT_FUNCTIONS, **DATE_FUNCTIONS}
"""By canonical name."""


class Expressions:
    """Evaluates the expressions of one program."""

    __slots__ = ("_call_function", "_call_routine", "_environment", "_on_s7", "_places")

    def __init__(
        self,
        dialect: str,
        environment: Environment,
        places: Places,
        call_function: Callable[[FunctionCall, Frame], Value | None],
        call_routine: Callable[[RoutineCall, Frame], Value | None],
    ) -> None:
        self._on_s7 = dialect in ("tia", "step7")
        self._environment = environment
        self._places = places
        self._call_function = call_function
        self._call_routine = call_routine

    def value(self, expression: Expression, frame: Frame) -> Value:
        """The value of any expression; of a structure or an array a copy."""
        if isinstance(expression, Place):
            return self._places.find(expression, frame).read()
        if isinstance(expression, FunctionCall):
            value = self._call_function(expression, frame)
            assert value is not None
            return value
        if isinstance(expression, RoutineCall):
            result = self._call_routine(expression, frame)
            assert result is not None
            return result
        return self._calculated(expression, frame)

    def scalar(self, expression: Expression, frame: Frame) -> Scalar:
        """The value of an expression of an elementary type or a text."""
        value = self.value(expression, frame)
        assert isinstance(value, bool | int | float | str)
        return value

    def integer(self, expression: Expression, frame: Frame) -> int:
        """The value of an expression that counts in whole numbers."""
        value = self.value(expression, frame)
        assert isinstance(value, int)
        return value

    def system_call(self, call: SystemCall, frame: Frame) -> Scalar:
        """A system instruction: areas by reference, everything else by value."""
        instruction = INSTRUCTIONS[call.name.casefold()]
        if instruction.on_memory:
            return self._on_memory(call, frame)
        parameters = instruction.parameters
        areas = {
            parameter.name
            for parameter in parameters
            if parameter.is_output or isinstance(parameter.type, AnyType)
        }
        arguments: dict[str, Scalar | Area] = {}
        for name, expression in call.arguments:
            if name in areas:
                storage = self._places.find(_as_place(expression), frame)
                arguments[name] = StorageArea(storage, expression.span)
            else:
                arguments[name] = self.scalar(expression, frame)
        return self._environment.instruction(call.name, arguments, call.span)

    def _on_memory(self, call: SystemCall, frame: Frame) -> Scalar:
        """An instruction that works on memory alone; 0 for those without a result."""
        places = self._places
        if call.name == "POKE_BLK":
            numbers = [self.integer(argument, frame) for _, argument in call.arguments]
            poke_block(call, numbers, places)
        elif call.name in ON_VARIANTS:
            return ON_VARIANTS_BY_NAME[call.name](
                [
                    self.pointed(argument, frame)
                    if refers_to_anything(argument.type)
                    else self.integer(argument, frame)
                    for _, argument in call.arguments
                ],
                call.span,
            )
        elif call.name in ELEMENT_MOVES:
            (_, source), (_, count), (_, target) = call.arguments
            if "FILL" in call.name:
                values = [self.value(source, frame)]
            else:
                values = [storage.read() for storage in elements(source, places, frame)]
            wanted = self.integer(count, frame)
            move_elements(call, values, elements(target, places, frame), wanted)
        else:
            return move_areas(call, places, frame)
        return 0

    def _calculated(
        self,
        expression: Constant
        | Unary
        | Binary
        | Convert
        | StandardCall
        | BoundOf
        | ReferenceTo
        | SameReference
        | TypeTest
        | SameTypes
        | ElementCount
        | SystemCall
        | Attempt
        | Substituted
        | TakenError,
        frame: Frame,
    ) -> Value:
        match expression:
            case Constant():
                return expression.value
            case Unary():
                operand = self.scalar(expression.operand, frame)
                return unary(expression.operator, operand, expression.type)
            case Binary() | Convert():
                return self._chain(expression, frame)
            case StandardCall():
                return self._standard_call(expression, frame)
            case ReferenceTo():
                place = expression.place
                return Pointed(None if place is None else self._places.find(place, frame))
            case SameReference():
                return self.pointed(expression.left, frame) is self.pointed(expression.right, frame)
            case TypeTest() | SameTypes() | ElementCount():
                return ask(expression, lambda variant: self.pointed(variant, frame))
            case BoundOf():
                array = self._places.find(expression.base, frame).kind
                assert isinstance(array, ArrayType)
                return array.bounds[expression.dimension][expression.upper]
            case SystemCall():
                return self.system_call(expression, frame)
            case Attempt():
                return self._attempt(expression, frame)
            case Substituted():
                return self._substituted(expression, frame)
            case TakenError():
                memory = self._places.find(expression.memory, frame)
                noted = memory.read()
                assert isinstance(noted, int)
                memory.write(0)
                return noted & 0xFFFF

    def _attempt(self, attempt: Attempt, frame: Frame) -> Scalar:
        """A calculation that says whether it works instead of stopping the program."""
        operand = attempt.operand
        values: list[Scalar] = []
        try:
            result = self.scalar(self._settled(operand, frame, values), frame)
            works = is_right(operand, values, result)
        except DiagnosticError as stop:
            if not is_bad_calculation(stop):
                raise
            works, result = False, nothing(attempt.type)
        if not works:
            self._places.find(attempt.flag, frame).write(False)
        return result

    def _substituted(self, node: Substituted, frame: Frame) -> Value:
        try:
            return self._places.find(node.place, frame).read()
        except DiagnosticError as stop:
            self.note(stop, node, frame)
        return nothing(node.type)

    def note(self, stop: DiagnosticError, node: Substituted | Guarded, frame: Frame) -> None:
        """Keep the first error of a block that handles its own; raises all others again."""
        number = local_error(stop, node)
        if number is None:
            raise stop
        memory = self._places.find(node.memory, frame)
        if not memory.read():
            memory.write(number)

    def _settled(
        self,
        operand: Unary | Binary | Convert | StandardCall,
        frame: Frame,
        values: list[Scalar],
    ) -> Unary | Binary | Convert | StandardCall:
        """The same calculation with its operands worked out; they go to `values` too."""

        def settle(part: Expression) -> Constant:
            values.append(self.scalar(part, frame))
            return Constant(part.span, values[-1], part.type)

        match operand:
            case Binary():
                return replace(operand, left=settle(operand.left), right=settle(operand.right))
            case Unary() | Convert():
                return replace(operand, operand=settle(operand.operand))
            case StandardCall():
                return replace(operand, arguments=tuple(map(settle, operand.arguments)))

    def pointed(self, expression: Expression, frame: Frame) -> Storage | None:
        """What a reference or a VARIANT refers to."""
        value = self.value(expression, frame)
        assert isinstance(value, Pointed)
        return value.find(expression.span)

    def _chain(self, expression: Binary | Convert, frame: Frame) -> Value:
        """A left-deep tree, which may have conversions between its links, from the left up."""
        links: list[Binary | Convert] = []
        leftmost: Expression = expression
        while isinstance(leftmost, Binary | Convert):
            links.append(leftmost)
            leftmost = leftmost.left if isinstance(leftmost, Binary) else leftmost.operand
        result = self.value(leftmost, frame)
        for link in reversed(links):
            if isinstance(link, Convert):
                source = link.operand.type
                if isinstance(result, Mapping):
                    result = stamp_of(result, link.span)
                    continue
                assert isinstance(result, bool | int | float | str)
                if isinstance(link.type, StructType):
                    result = parts_of(int(result))
                    continue
                result = convert(result, source, link.type, link.rounding, link.span)
            elif link.operator in ("AND_THEN", "OR_ELSE"):
                if result is (link.operator == "AND_THEN"):
                    result = self.scalar(link.right, frame)
            else:
                assert isinstance(result, bool | int | float | str)
                right = self.scalar(link.right, frame)
                result = binary(link.operator, result, right, link.left.type, link.span)
        return result

    def _standard_call(self, call: StandardCall, frame: Frame) -> Scalar:
        values = [self.scalar(argument, frame) for argument in call.arguments]
        kinds = tuple(argument.type for argument in call.arguments)
        signature = Signature(kinds, call.type, self._on_s7, call.span)
        result = STANDARD_FUNCTIONS[call.name](values, signature)
        if isinstance(call.type, StringType):
            assert isinstance(result, str)
            return result[: call.type.length]
        return result


def _as_place(expression: Expression) -> Place:
    assert isinstance(expression, Place)
    return expression
