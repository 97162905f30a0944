"""What stops a running program: the diagnostics FB6002 to FB6049, one function each.

Both engines raise these and nothing else. A real CPU sets a status bit, goes on with a value that
differs from family to family, or stops; here the scan ends, so that a test sees what happened.
"""

from collections.abc import Sequence

from fbgen.diagnostics import DiagnosticError, error
from fbgen.lang.checked import RoutineCall
from fbgen.lang.types import VOID, Subrange, Type
from fbgen.nearest import did_you_mean
from fbgen.source import Span
from harness.engine.area_pointers import NULL_ANY

# --- what the program does --------------------------------------------------------------------


def index_out_of_range(
    span: Span | None, index: int, first: int, last: int, dimension: int = 1
) -> DiagnosticError:
    """FB6002: an array index outside its bounds; `dimension` counts from 1."""
    which = f"index {dimension}" if dimension > 1 else "the index"
    return error(
        "FB6002",
        f"{which} is {index}, the array has {first}..{last}",
        span,
        "limit the index before it is used, or declare the array larger",
    )


def division_by_zero(span: Span) -> DiagnosticError:
    """FB6003: / or MOD on whole numbers or times with zero on the right."""
    return error(
        "FB6003", "division by zero", span, "test the divisor first: IF divisor <> 0 THEN ..."
    )


def endless_loop(loop: Span, passes: int) -> DiagnosticError:
    """FB6004: the loops of one call from outside have begun more than `passes` passes.

    `loop` is the span of the loop that began the last one.
    """
    first_line = loop.text.split("\n", 1)[0].strip()
    return error(
        "FB6004",
        f"the cycle watchdog stopped '{first_line}': more than {passes} loop passes in one cycle",
        loop,
        "make sure that the loop's condition changes in its body",
    )


def nesting_too_deep(span: Span | None, block: str, depth: int) -> DiagnosticError:
    """FB6005: more than `depth` blocks are inside each other."""
    return error(
        "FB6005",
        f"the call of '{block}' is nested more than {depth} deep",
        span,
        "a block must not call itself, not even through another one",
    )


def value_out_of_range(span: Span, value: float, target: Type) -> DiagnosticError:
    """FB6006: a floating-point number (or NaN) that the whole-number type cannot hold."""
    return error(
        "FB6006",
        f"{value!r} does not fit into {target}",
        span,
        "limit the value before it is converted, for example with LIMIT",
    )


def not_a_number(span: Span, text: str, target: Type) -> DiagnosticError:
    """FB6007: a text that cannot be read as a value of the type, or is out of its range."""
    return error(
        "FB6007",
        f"the text {text!r} cannot be read as {target}",
        span,
        "the whole text must be one number of the type, blanks around it are allowed",
    )


def step_is_zero(span: Span) -> DiagnosticError:
    """FB6008: a FOR that would never end."""
    return error("FB6008", "the step of this FOR is 0", span, "use BY with a step that is not 0")


def selector_out_of_range(span: Span, selector: int, count: int) -> DiagnosticError:
    """FB6009: MUX with a selector for which there is no input."""
    return error(
        "FB6009",
        f"MUX has the inputs 0..{count - 1}, the selector is {selector}",
        span,
        "limit the selector before it is used",
    )


def address_out_of_range(span: Span | None, address: str, size: int) -> DiagnosticError:
    """FB6010: an absolute address behind the end of its area of `size` bytes."""
    return error(
        "FB6010",
        f"{address} lies outside of its area, which has {size} bytes",
        span,
        "use an address inside the area, or make the area larger",
    )


def no_data_block(span: Span | None, number: int) -> DiagnosticError:
    """FB6011: a data block is addressed by a number that none has, or none with addresses."""
    return error(
        "FB6011",
        f"there is no data block DB{number} with standard access",
        span,
        f"name it DB{number}, or give its number: --db-number NAME={number}, or db_numbers of "
        "load_program",
    )


def unknown_area(span: Span, code: int) -> DiagnosticError:
    """FB6040: PEEK, POKE or a pointer with a code that means no area of memory."""
    return error(
        "FB6040",
        f"there is no memory area 16#{code:02X}",
        span,
        "16#81 inputs, 16#82 outputs, 16#83 bit memory, 16#84 data block, 1 and 2 hardware",
    )


def too_many_elements(span: Span, name: str, count: int, room: int) -> DiagnosticError:
    """FB6041: MOVE_BLK and the like with more elements than there are from the given one on."""
    return error(
        "FB6041",
        f"{name} works on {count} elements, the array has {room} from there on",
        span,
        "limit COUNT to the elements that are left",
    )


def reference_not_set(span: Span | None, name: str) -> DiagnosticError:
    """FB6012: an in-out is used that no call has connected yet."""
    return error(
        "FB6012",
        f"the in-out '{name}' is used and nothing is connected to it",
        span,
        "give the in-out a variable in the call",
    )


def not_decimal(span: Span, value: int) -> DiagnosticError:
    """FB6014: a word that should hold decimal digits (BCD, S5TIME) has a digit above 9."""
    return error(
        "FB6014",
        f"16#{value:04X} is not binary coded decimal",
        span,
        "each hexadecimal digit must be 0 to 9; the first one is the sign or the time base",
    )


def outside_subrange(span: Span, value: int, kind: Subrange) -> DiagnosticError:
    """FB6030: a value that the declaration of its target does not allow."""
    return error(
        "FB6030",
        f"{value} is outside of {kind.base.name} ({kind.lowest}..{kind.highest})",
        span,
        "limit the value before it is assigned, for example with LIMIT",
    )


def null_reference(span: Span) -> DiagnosticError:
    """FB6031: a reference is followed that refers to nothing."""
    return error(
        "FB6031",
        "the reference refers to nothing",
        span,
        "bind it first, and ask it before it is followed: IF r <> NULL THEN ...",
    )


def no_date(span: Span) -> DiagnosticError:
    """FB6032: a DTL is used whose parts are no date and time."""
    return error(
        "FB6032",
        "the parts of this DTL are no date and time",
        span,
        "set YEAR, MONTH and DAY to a day of the calendar, from 1970 to 2553",
    )


def no_such_date(span: Span, text: str) -> DiagnosticError:
    """FB6015: numbers that make up no date or time of day that the type can hold."""
    return error(
        "FB6015",
        f"{text} is not in the calendar of this type",
        span,
        "check the numbers before they are put together: month 1..12, day 1..31, hour 0..23",
    )


def stop_requested(span: Span) -> DiagnosticError:
    """FB6016: the program asks the controller to stop (STP, SFC46)."""
    return error("FB6016", "the program stops the CPU here", span, "call STP under a condition")


def cannot_run(span: Span | None, what: str) -> DiagnosticError:
    """FB6072: a statement that is read and checked only."""
    return error(
        "FB6072",
        f"{what} cannot run",
        span,
        "test the other statements on their own, or write this one without it",
    )


def not_modelled(node: RoutineCall) -> DiagnosticError:
    """FB6070: a call of something that only a stub could carry out, or a module of the plant."""
    inputs = ", ".join(name for name, _ in node.inputs)
    outputs = ", ".join(f'"{name}": ...' for name, _ in node.outputs)
    return error(
        "FB6070",
        f"nobody has said what {node.name}({inputs}) does",
        node.span,
        f'before the run: program.stub("{node.name}", lambda **inputs: {{{outputs}}})',
    )


def wrong_result(node: RoutineCall, given: object) -> DiagnosticError:
    """FB6071: a stub gives a result where there is none, or none where there is one."""
    wanted = f"a {node.type}" if node.type != VOID else "no result"
    return error(
        "FB6071",
        f"the stub of {node.name} gave {_shortened(given)}, and the call has {wanted}",
        node.span,
        "return a mapping from the names of the outputs (and RET_VAL) to their values",
    )


def unknown_output(node: RoutineCall, name: str, known: Sequence[str]) -> DiagnosticError:
    """FB6071: a stub gives an output that the call does not take."""
    return error(
        "FB6071",
        f"the stub of {node.name} gave '{name}', which the call does not ask for",
        node.span,
        f"it takes: {', '.join(known)}" if known else "it takes nothing",
    )


def too_many_bytes(node: RoutineCall, given: int, size: int) -> DiagnosticError:
    """FB6071: a stub gives more bytes than the area has that the call hands over."""
    return error(
        "FB6071",
        f"the stub of {node.name} gave {given} bytes, and the area has {size}",
        node.span,
        "give it no more bytes than it has",
    )


# --- what is asked from outside ---------------------------------------------------------------


def unknown_name(what: str, name: str, known: Sequence[str]) -> DiagnosticError:
    """FB6020: nothing has this name; `what` is "block", "variable", "input" and the like."""
    there = f"there is: {', '.join(sorted(known, key=str.casefold)[:12])}" if known else ""
    advice = did_you_mean(name, known) or there
    return error("FB6020", f"there is no {what} '{name}'", None, advice)


def no_such_area(span: Span | None, pattern: bytes, reason: str) -> DiagnosticError:
    """FB6017: the bytes of an ANY or POINTER that is followed do not mean an area."""
    shown = " ".join(f"{byte:02X}" for byte in pattern)
    kind = "ANY" if len(pattern) == len(NULL_ANY) else "POINTER"
    return error(
        "FB6017",
        f"the {kind} {shown} means no area: {reason}",
        span,
        "write 16#10, type code, count, number of the data block, 16#84000000 + 8 * byte + bit",
    )


def wrong_value(path: str, value: object, kind: Type, reason: str) -> DiagnosticError:
    """FB6021: a Python value that the variable at `path` cannot hold."""
    return error("FB6021", f"{path} : {kind} cannot be {_shortened(value)}: {reason}")


def wrong_kind_of_block(name: str, found: str, use: str) -> DiagnosticError:
    """FB6022: a block is used in a way that its kind does not allow; `use` says what would do."""
    return error("FB6022", f"'{name}' is a {found}", None, use)


def missing_argument(block: str, name: str) -> DiagnosticError:
    """FB6023: a call from outside leaves out what the block cannot do without."""
    return error(
        "FB6023", f"'{block}' needs a value for '{name}'", None, f"add {name}=... to the call"
    )


def wrong_path(path: str, reason: str) -> DiagnosticError:
    """FB6024: a path that does not lead to a variable."""
    return error("FB6024", f"'{path}' does not name a variable: {reason}")


def unknown_engine(name: str, known: Sequence[str]) -> DiagnosticError:
    """FB6025: an engine that does not exist is asked for."""
    return error("FB6025", f"there is no engine '{name}'", None, f"known: {', '.join(known)}")


def engine_without_probes(name: str, instead: str) -> DiagnosticError:
    """FB6026: somebody wants to look on while an engine runs that cannot be looked at."""
    message = f"nobody can look on at the engine '{name}', as coverage does"
    return error("FB6026", message, None, f'use engine="{instead}"; both give the same results')


def _shortened(value: object) -> str:
    text = repr(value)
    return text if len(text) <= 60 else text[:57] + "..."
