"""From the syntax trees of some files to one checked program."""

import sys
from collections.abc import Collection, Iterator, Mapping, Sequence
from contextlib import contextmanager
from types import MappingProxyType

from fbgen.diagnostics import Diagnostic, DiagnosticError
from fbgen.lang import ast
from fbgen.lang.analysis import analyse, without_allowed
from fbgen.lang.ast import BlockKind
from fbgen.lang.checked import Block, Program, Statement, Stop, Variable
from fbgen.lang.checker.calls.enabling import begin_enabled
from fbgen.lang.checker.declared.configuration import tasks_of
from fbgen.lang.checker.declared.recursion import report_recursive_calls
from fbgen.lang.checker.findings import Findings
from fbgen.lang.checker.library import Library
from fbgen.lang.checker.operands import expressions  # noqa: F401  (enters the checks of expressions
from fbgen.lang.checker.operands.pointed_memory import lay_out_what_is_pointed_to
from fbgen.lang.checker.rules import Rules, rules_for
from fbgen.lang.checker.statements.jumps import check_jumps
from fbgen.lang.checker.statements.kinds import check_body
from fbgen.lang.checker.statements.local_errors import with_local_errors
from fbgen.lang.checker.supplied.standard_blocks import STANDARD_BLOCKS
from fbgen.lang.collector import collector_at_rest
from fbgen.lang.unread_parts import unread_parts

_FRAMES = 12_000
"""Python frames for the deepest nesting that `context.NESTING_LIMIT` lets through."""


def check(
    files: Sequence[ast.File],
    dialect: str = "tia",
    *,
    rules: Rules | None = None,
    db_numbers: Mapping[str, int] = MappingProxyType({}),
    stubbed: Collection[str] = (),
) -> Program:
    """The program that the files make up together, in any order.

    Raises one DiagnosticError with all errors over all files. `rules` replaces the dialect's own
    rules, for a project with other compiler settings. `db_numbers` has the numbers of data blocks
    by their names, for absolute addresses; `DB100` has its number in its name. `stubbed` are the
    names of blocks that the files do not have, because a stub of the user stands for them.
    """
    rules = rules or rules_for(dialect)
    findings = Findings()
    with _room_for_nesting(), collector_at_rest():
        program, _ = _check(files, Library(rules, findings, db_numbers, stubbed))
    if findings.keeps_from_running:
        raise DiagnosticError(
            findings.keeping_from_running(tuple(one.source.name for one in files))
        )
    return with_local_errors(program)


def check_reporting(
    files: Sequence[ast.File],
    dialect: str = "tia",
    *,
    rules: Rules | None = None,
    db_numbers: Mapping[str, int] = MappingProxyType({}),
    stubbed: Collection[str] = (),
    unread: Sequence[Diagnostic] = (),
) -> tuple[Program | None, list[Diagnostic]]:
    """The program, None if it cannot run, and all errors, warnings and hints by file and place.

    Comments in the text can allow warnings (`analysis.allow`). `unread` are the errors that reading
    the files has found: the units that they are in are left alone, and there is no program.

    Raises FB4000 for an unknown dialect, and nothing else.
    """
    rules = rules or rules_for(dialect)
    findings = Findings()
    parts = unread_parts(files, unread)
    with _room_for_nesting(), collector_at_rest():
        library = Library(rules, findings, db_numbers, stubbed)
        library.incomplete = parts.incomplete
        program, library = _check(files, library)
        analyse(program, library, findings)
    findings.replace(without_allowed(findings.found(), files))
    found = findings.in_order(tuple(file.source.name for file in files))
    if unread:
        return None, [one for one in found if not parts.follows(one)]
    return (None if findings.keeps_from_running else with_local_errors(program)), list(found)


@contextmanager
def _room_for_nesting() -> Iterator[None]:
    before = sys.getrecursionlimit()
    sys.setrecursionlimit(max(before, _FRAMES))
    try:
        yield
    finally:
        sys.setrecursionlimit(before)


def _check(files: Sequence[ast.File], library: Library) -> tuple[Program, Library]:
    library.collect(files)
    library.declare_constants()
    library.types.all_user_types()
    library.declare_globals()
    library.memory.report_strangers(library.findings)
    blocks = library.all_blocks()
    library.objects.check_blocks()
    bodies: dict[Block, tuple[Statement, ...]] = {}
    for block in blocks.values():
        library.context_of(block).resolve_all()
    library.types.settle()
    for block in blocks.values():
        ctx = library.context_of(block)
        body = check_body(ctx, block.syntax.body)
        if ctx.not_started:
            body = (Stop(block.syntax.name.span, ctx.not_started[0]), *body)
        bodies[block] = begin_enabled(ctx, body)
        check_jumps(ctx, block.syntax)
    report_recursive_calls(library, blocks)
    lay_out_what_is_pointed_to(library, bodies)
    library.starts.write()
    bodies.update(library.starts.bodies)
    tasks = tasks_of(library)
    program = Program(
        dialect=library.rules.dialect,
        blocks={
            key: block for key, block in blocks.items() if not library.objects.is_promise(block)
        },
        bodies=bodies,
        structures=library.types.structures,
        globals={
            key: entry
            for key, entry in library.globals.entries.items()
            if isinstance(entry, Variable)
        }
        | library.programs,
        standard_blocks={**STANDARD_BLOCKS, **library.unmodelled},
        tasks=tasks,
        byte_memory=library.memory.byte_memory(library),
        data_blocks=library.memory.numbers,
        members=library.objects.members_by_name(),
        starts=library.starts.functions,
        lists=library.lists.members,
        called_programs=frozenset(
            called
            for block in blocks.values()
            for called in library.context_of(block).calls
            if called.kind is BlockKind.PROGRAM
        ),
        temporaries={
            block: tuple(found)
            for block in blocks.values()
            if (found := library.context_of(block).temporaries)
        },
    )
    return program, library
