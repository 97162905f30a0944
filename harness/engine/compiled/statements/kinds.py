"""Statements: assignments, calls, jumps, and what is nested too deep for Python."""

from collections.abc import Sequence

from fbgen.lang.checked import (
    Assignment,
    Branch,
    Case,
    CaseArm,
    Continue,
    Evaluate,
    Exit,
    For,
    FunctionCall,
    Guarded,
    If,
    InstanceCall,
    Repeat,
    Return,
    RoutineCall,
    Statement,
    Stop,
    SystemCall,
    Try,
    While,
)
from fbgen.source import Span
from harness.engine.compiled.data.model import has_memory
from harness.engine.compiled.evaluation import value
from harness.engine.compiled.expressions.places import assign, place
from harness.engine.compiled.procedure import DEEPEST_INDENT, DEEPEST_LOOPS, Procedure
from harness.engine.compiled.shortening.caching import worth_keeping
from harness.engine.compiled.shortening.hardware_reads import several_reads, write_several_reads
from harness.engine.compiled.shortening.hardware_writes import several_writes, write_several_writes
from harness.engine.compiled.shortening.intervals import written_inside
from harness.engine.compiled.shortening.passing_time import timer_behind, timer_inside
from harness.engine.compiled.statements.calls import (
    evaluate,
    function_statement,
    instruction_statement,
)
from harness.engine.compiled.statements.exceptions import write_try
from harness.engine.compiled.statements.instances import instance_call
from harness.engine.compiled.statements.jumps import Dispatcher, has_jumps
from harness.engine.compiled.statements.local_errors import write_guarded
from harness.engine.compiled.statements.loops import write_for, write_repeat, write_while
from harness.engine.compiled.statements.routine_calls import routine_statement
from harness.engine.compiled.statements.selection import write_case, write_if
from harness.engine.compiled.walk import WRITING, nodes_of, root_of, written_places
from harness.engine.compiled.watching.probes import Moment, Probed

_GOES_ON, _RETURN, _EXIT, _CONTINUE = 0, 1, 2, 3
DEEPEST_LOCALS = 20
"""Indentation up to which branches look for variables to keep in locals."""
LONGEST_FUNCTION = 4000
"""Statements of a block that Python compiles as one function."""
LONGEST_SEGMENT = 1000
"""Statements between two labels that stay in the function of the block."""


def write_body(
    procedure: Procedure, body: Sequence[Statement], owner: Probed | None = None
) -> None:
    """Statements one level deeper; `pass` if there are none.

    They are the inside of `owner`: a branch, an arm, a loop, or the ELSE of an IF or CASE.
    """
    listing = procedure.listing
    listing.indent += 4
    before = len(listing.lines)
    if owner is not None:
        procedure.probe(owner, Moment.INSIDE)
    if (
        listing.indent > 4 * DEEPEST_INDENT or len(procedure.loops) >= DEEPEST_LOOPS
    ) and _is_nested(body):
        _split(procedure, body)
        listing.indent -= 4
        return
    aliases, paths = procedure.aliases, procedure.paths
    if isinstance(owner, Branch | CaseArm):
        _keep_in_locals(procedure, body)
    write_statements(procedure, body)
    procedure.aliases, procedure.paths = aliases, paths
    if len(listing.lines) == before:
        procedure.line("pass")
    listing.indent -= 4


def _keep_in_locals(procedure: Procedure, body: Sequence[Statement]) -> None:
    """Read often used attributes into locals; the mappings of `procedure` become new ones."""
    context = procedure.context
    if not has_memory(context.block) or procedure.listing.indent > DEEPEST_LOCALS:
        return
    kept = worth_keeping(body, context.block, context.facts)
    aliases = dict(procedure.aliases)
    for variable, is_read_first in kept.variables:
        if variable not in aliases:
            name = context.names.of(variable.name)
            if is_read_first:
                procedure.line(f"{name} = {procedure.text_of(variable)}")
            aliases[variable] = name
    procedure.aliases = aliases
    for path, node in kept.structures:
        if path not in procedure.paths:
            name = context.path_name(path, node.name)
            procedure.line(f"{name} = {place(procedure, node).text}")
            procedure.paths = {**procedure.paths, path: name}


def _is_nested(body: Sequence[Statement]) -> bool:
    return any(isinstance(one, If | Case | For | While | Repeat | Try) for one in body)


def write_statements(procedure: Procedure, body: Sequence[Statement]) -> None:
    """Statements at the present level."""
    procedure.timer = None
    at = 0
    while at < len(body):
        if (reads := several_reads(body, at, procedure.context.block)) is not None:
            write_several_reads(procedure, reads, _write_each)
            at += len(reads.statements)
        elif (writes := several_writes(procedure, body, at)) is not None:
            write_several_writes(procedure, writes, _write_each)
            at += len(writes.statements)
        else:
            _write_each(procedure, body[at : at + 1])
            at += 1


def _write_each(procedure: Procedure, body: Sequence[Statement]) -> None:
    for statement in body:
        if procedure.known:
            procedure.forget(written_inside(statement))
        procedure.timer, behind = (
            timer_inside(procedure.timer, statement),
            timer_behind(procedure.timer, statement),
        )
        write_statement(procedure, statement)
        procedure.timer = behind
        if procedure.known and isinstance(statement, Assignment):
            procedure.forget({root_of(statement.target)})


def write_statement(procedure: Procedure, statement: Statement) -> None:
    """One statement."""
    procedure.listing.span = statement.span
    procedure.enter(statement.span)
    procedure.forget_sites()
    procedure.probe(statement, Moment.BEFORE)
    match statement:
        case Assignment():
            _assignment(procedure, statement)
        case InstanceCall():
            instance_call(procedure, statement)
        case If():
            write_if(procedure, statement, write_body)
        case Case():
            write_case(procedure, statement, write_body)
        case For():
            write_for(procedure, statement, write_body)
        case While():
            write_while(procedure, statement, write_body)
        case Repeat():
            write_repeat(procedure, statement, write_body)
        case Try():
            write_try(procedure, statement, write_body)
        case Guarded():
            write_guarded(procedure, statement, write_statement)
        case Evaluate():
            if isinstance(statement.call, RoutineCall):
                routine_statement(procedure, statement.call)
            else:
                evaluate(procedure, statement.call)
        case Exit():
            _exit(procedure)
        case Continue():
            _continue(procedure)
        case Return():
            _return(procedure)
        case Stop():
            procedure.line(f"_cannot_run({statement.what!r})")
    if not isinstance(statement, Exit | Continue | Return | Stop):
        procedure.listing.span = statement.span
        procedure.probe(statement, Moment.AFTER)
    procedure.nesting -= 1


def _assignment(procedure: Procedure, node: Assignment) -> None:
    if isinstance(node.value, FunctionCall) and (node.value.outputs or node.value.in_outs):
        code = function_statement(procedure, node.value)
        assert code is not None
    elif isinstance(node.value, SystemCall):
        code = instruction_statement(procedure, node.value)
    elif isinstance(node.value, RoutineCall):
        code = routine_statement(procedure, node.value)
    else:
        code = value(procedure, node.value)
    procedure.assigned = node.value
    assign(procedure, node.target, code, node.value.type)
    procedure.assigned = None


# --- jumps --------------------------------------------------------------------------------------


def _return(procedure: Procedure) -> None:
    if procedure.split:
        procedure.line(f"return {_RETURN}")
    else:
        procedure.line(procedure.return_line)


def _exit(procedure: Procedure) -> None:
    procedure.line("break" if procedure.loops else f"return {_EXIT}")


def _continue(procedure: Procedure) -> None:
    if not procedure.loops:
        procedure.line(f"return {_CONTINUE}")
        return
    before = procedure.loops[-1].before_continue
    if before is not None:
        before(procedure)
    procedure.line("continue")


# --- splitting ----------------------------------------------------------------------------------


def _jumps(body: Sequence[Statement], in_loop: bool = False) -> set[type]:
    """The kinds of jump in `body` that lead out of it."""
    found: set[type] = set()
    stack: list[tuple[Statement | Branch | CaseArm, bool]] = [(one, in_loop) for one in body]
    while stack:
        node, inside = stack.pop()
        match node:
            case Return():
                found.add(Return)
            case Exit() | Continue():
                if not inside:
                    found.add(type(node))
            case If():
                stack += [(branch, inside) for branch in node.branches]
                stack += [(one, inside) for one in node.otherwise]
            case Case():
                stack += [(arm, inside) for arm in node.arms]
                stack += [(one, inside) for one in node.otherwise]
            case Branch() | CaseArm():
                stack += [(one, inside) for one in node.body]
            case Try():
                stack += [(one, inside) for one in (*node.body, *node.catch)]
            case For() | While() | Repeat():
                stack += [(one, True) for one in node.body]
            case _:
                pass
    return found


def _split(procedure: Procedure, body: Sequence[Statement]) -> None:
    """Statements in a function of their own, called here."""
    span: Span | None = procedure.listing.span
    part = procedure.start_part("part")
    _keep_in_locals(part, body)
    write_statements(part, body)
    part.listing.span = span
    part.line(f"return {_GOES_ON}")
    call = procedure.finish_part(part)
    procedure.listing.span = span
    jumps = _jumps(body)
    if not jumps:
        procedure.line(call)
        _refresh(procedure, body)
        return
    name = procedure.temporary()
    procedure.line(f"{name} = {call}")
    _refresh(procedure, body)
    for kind, code, write in (
        (Return, _RETURN, _return),
        (Exit, _EXIT, _exit),
        (Continue, _CONTINUE, _continue),
    ):
        if kind in jumps:
            procedure.line(f"if {name} == {code}:")
            procedure.listing.indent += 4
            write(procedure)
            procedure.listing.indent -= 4


def _refresh(procedure: Procedure, body: Sequence[Statement]) -> None:
    """Fill the locals again whose variables another function has written."""
    if procedure.aliases:
        places = (place for node in nodes_of(WRITING, body) for place in written_places(node))
        written = {root_of(place) for place in places}
        for variable, name in procedure.aliases.items():
            if variable in written:
                procedure.line(f"{name} = {procedure.text_of(variable)}")


def _write_plain(procedure: Procedure, body: Sequence[Statement]) -> None:
    """Statements between labels."""
    for start in range(0, len(body), LONGEST_SEGMENT):
        piece = body[start : start + LONGEST_SEGMENT]
        if len(body) > LONGEST_SEGMENT:
            _split(procedure, piece)
        else:
            write_statements(procedure, piece)


def write_long(procedure: Procedure, body: Sequence[Statement]) -> None:
    """The statements of a whole block; in several functions if there are very many."""
    if has_jumps(body):
        Dispatcher(procedure, _write_plain).write(body)
        return
    if len(body) <= LONGEST_FUNCTION:
        _keep_in_locals(procedure, body)
        write_statements(procedure, body)
        return
    for start in range(0, len(body), LONGEST_FUNCTION):
        piece = body[start : start + LONGEST_FUNCTION]
        procedure.listing.span = piece[0].span
        _split(procedure, piece)
