"""What the checking of one block's text works with."""

from typing import TYPE_CHECKING

from fbgen.dataclass import dataclass
from fbgen.lang.checked import Assignment, Block, Variable
from fbgen.lang.checker.findings import Findings
from fbgen.lang.checker.rules import Rules
from fbgen.lang.checker.symbols import PendingSymbol, Scope, Symbol
from fbgen.source import Span

if TYPE_CHECKING:
    from fbgen.lang.checker.library import Library


@dataclass(frozen=True, slots=True)
class Place:
    """Where a jump or a label stands: its name as written, and the loops around it."""

    name: str
    span: Span
    loops: tuple[Span, ...]


NESTING_LIMIT = 1000
"""How many nodes may be nested in each other; the parser's own limit comes long before it."""


class Context:
    """Rules, names and findings for one block, and what was seen while its text was checked.

    `used` and `written` collect the symbols that the text mentions and assigns, `calls` the
    blocks it calls with the place of the first call, `respelled` the first mention of a symbol in
    other capitals than it is declared with, `labels` and `jumps` what GOTO needs. `loops` are the
    loops around the present statement, the outermost first. `own_eno` is the ENO of a block that
    uses it, `overflow_flag` the same where errors of calculation make it FALSE, and `call_flag`
    what the ENO of a standard function is collected in. `this` is the instance in the body, the
    methods and the actions of a block that has members, `owner` that block, and `method` the
    casefolded name of a method. `temporaries` are those that nobody declared. `copies` are what the
    present statement does with outputs that are converted on their way; None where it cannot.
    `not_run` is what the present statement has that cannot run, None outside of statements;
    `not_started` what keeps the block from starting.
    """

    __slots__ = (
        "block",
        "call_flag",
        "calls",
        "copies",
        "depth",
        "findings",
        "jumps",
        "labels",
        "library",
        "loops",
        "method",
        "not_run",
        "not_started",
        "overflow_flag",
        "own_eno",
        "owner",
        "respelled",
        "rules",
        "scope",
        "temporaries",
        "this",
        "used",
        "written",
    )

    def __init__(self, library: "Library", scope: Scope, block: Block | None = None) -> None:
        self.library = library
        self.rules: Rules = library.rules
        self.findings: Findings = library.findings
        self.scope = scope
        self.block = block
        self.depth = 0
        self.loops: tuple[Span, ...] = ()
        self.labels: dict[str, Place] = {}
        self.jumps: list[Place] = []
        self.own_eno: Variable | None = None
        self.overflow_flag: Variable | None = None
        self.call_flag: Variable | None = None
        self.owner: Block | None = None
        self.this: Variable | None = None
        self.method = ""
        self.not_run: list[str] | None = None
        self.not_started: list[str] = []
        self.temporaries: list[Variable] = []
        self.copies: list[Assignment] | None = None
        self.used: set[Symbol] = set()
        self.written: set[Variable] = set()
        self.calls: dict[Block, Span] = {}
        self.respelled: dict[Symbol, Span] = {}

    def local(self, key: str) -> Symbol | None:
        """The symbol that the block itself declares under a casefolded name."""
        return self._resolved(self.scope, key)

    def of_owner(self, key: str) -> Symbol | None:
        """In a method: the symbol that its block declares, or the method in VAR_INST."""
        if self.owner is None or not self.method:
            return None
        around = self.library.context_of(self.owner)
        return around.local(f"{self.method}.{key}") or around.local(key)

    def of_program(self, key: str) -> Symbol | None:
        """The global variable, data block or constant under a casefolded name."""
        return self._resolved(self.library.globals, key)

    def resolve_all(self) -> None:
        """Look up every name that is still pending, so that errors in unused ones are found."""
        for key in list(self.scope.entries):
            self.local(key)

    def is_read_only(self, variable: Variable) -> bool:
        """True for constants that are kept as variables."""
        return variable in self.scope.read_only or variable in self.library.globals.read_only

    def too_deep(self, span: Span) -> bool:
        """Report and say so if the nesting goes beyond the limit."""
        if self.depth <= NESTING_LIMIT:
            return False
        self.findings.error(
            "FB4053",
            f"nested deeper than {NESTING_LIMIT} levels",
            span,
            "split it: put a part into a variable or into a block of its own",
        )
        return True

    def _resolved(self, scope: Scope, key: str) -> Symbol | None:
        entry = scope.entries.get(key)
        if not isinstance(entry, PendingSymbol):
            return entry
        if entry.busy:
            self.findings.error(
                "FB4050",
                f"the value of '{entry.name}' depends on itself",
                entry.span,
                "give one of the constants a value that does not use the others",
            )
            return None
        entry.busy = True
        symbol = entry.evaluate()
        scope.entries[key] = symbol
        if isinstance(symbol, Variable) and entry.is_constant:
            scope.read_only.add(symbol)
        return symbol
