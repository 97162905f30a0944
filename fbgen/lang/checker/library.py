"""Everything that the files of one program declare, found by name and resolved when needed.

All units share one set of names, as on the controller. Interfaces are resolved on demand, so the
order of files and units does not matter; what needs itself is reported as recursion.
"""

from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace
from types import MappingProxyType

from fbgen.diagnostics import Note
from fbgen.lang import ast
from fbgen.lang.ast import BlockKind
from fbgen.lang.checked import LIVING, AnyBlock, Block, StandardBlock, Variable, VariableKind
from fbgen.lang.checked.variables import RECEIVER
from fbgen.lang.checker.calls.enabling import enable_variables
from fbgen.lang.checker.calls.unmodelled import assigned_members, hardware_block, stubbed_block
from fbgen.lang.checker.context import Context
from fbgen.lang.checker.declared.configured_variables import with_configured_variables
from fbgen.lang.checker.declared.generic_blocks import with_values
from fbgen.lang.checker.declared.global_lists import GlobalLists, named_by_their_files
from fbgen.lang.checker.declared.initials import Initials
from fbgen.lang.checker.declared.instance_starts import InstanceStarts
from fbgen.lang.checker.declared.interfaces import Interfaces
from fbgen.lang.checker.declared.lone_members import with_their_members
from fbgen.lang.checker.declared.memory_use import MemoryUse, is_optimized
from fbgen.lang.checker.declared.namespaces import Namespaces, written_whole
from fbgen.lang.checker.declared.objects import Objects, kept_sections
from fbgen.lang.checker.declared.type_names import TypeResolver
from fbgen.lang.checker.declared.variable_access import VariableAccess
from fbgen.lang.checker.findings import Findings
from fbgen.lang.checker.operands.own_names import with_own_names
from fbgen.lang.checker.rules import Rules
from fbgen.lang.checker.supplied.standard_blocks import STANDARD_BLOCKS, standard_block
from fbgen.lang.checker.symbols import Scope
from fbgen.lang.checker.types.literals import ERRONEOUS
from fbgen.lang.other_languages import is_foreign
from fbgen.lang.types import VOID, BlockType, Initial, StructType, Type
from fbgen.source import Span

_NESTING = 60
_S7 = ("tia", "step7")


class Library:
    """The declarations of a program."""

    def __init__(
        self,
        rules: Rules,
        findings: Findings,
        numbers: Mapping[str, int] = MappingProxyType({}),
        stubbed: Collection[str] = (),
    ) -> None:
        self.rules = rules
        self.memory = MemoryUse(numbers)
        self._stubbed = {name.casefold(): name for name in stubbed}
        self.unmodelled: dict[str, StandardBlock] = {}
        self.incomplete: frozenset[str] = frozenset()
        """The casefolded names of units that may declare more than could be read."""
        self.findings = findings
        self.globals = Scope()
        self.lists = GlobalLists()
        self.namespaces = Namespaces()
        self.types = TypeResolver(self)
        self.implicit: set[Variable] = set()
        """The ENO outputs that nobody declared: no parameters in the order of a call."""
        self.has_members = False
        self.receivers: set[Variable] = set()
        """The in-outs THIS of methods: the caller names them in front of the call."""
        self.linked: set[Variable] = set()
        """Variables that something outside of the program may read and write."""
        self.objects = Objects(self)
        self.access = VariableAccess()
        self.starts = InstanceStarts(self)
        self._interfaces = Interfaces(self)
        self._initials = Initials(self)
        self._units: dict[str, tuple[str, Span]] = {}
        self._syntax: dict[str, ast.Block] = {}
        self._data_blocks: dict[str, ast.DataBlock] = {}
        self._configurations: list[ast.Configuration] = []
        self._blocks: dict[str, Block] = {}
        self._contexts: dict[Block, Context] = {}
        self._busy: list[str] = []
        self._files: tuple[ast.File, ...] = ()
        self._members: Mapping[str, str] | None = None
        self._owners: list[str] = []
        self._classes: set[str] = set()
        self._block_types: dict[str, BlockType] = {}
        self.programs: dict[str, Variable] = {}
        """The PROGRAMs that other blocks name, as the global instances that they are."""

    # --- collecting ---------------------------------------------------------------------------

    def collect(self, files: Sequence[ast.File]) -> None:
        """Make all units of the files known by name."""
        files = with_their_members(named_by_their_files(files), self.findings)
        files = with_own_names(files)
        files, self.namespaces = written_whole(with_values(files, self.findings), self.findings)
        self._files = tuple(with_configured_variables(files, self.findings))
        for file in self._files:
            for unit in file.units:
                self._collect_unit(unit)

    def assigned_members(self) -> Mapping[str, str]:
        """The members that the text assigns, by casefolded name."""
        if self._members is None:
            self._members = assigned_members(self._files)
        return self._members

    def _collect_unit(self, unit: ast.Unit) -> None:
        if isinstance(unit, ast.Globals):
            self.lists.add(unit)
        elif isinstance(unit, ast.Configuration):
            self._configurations.append(unit)
            self.lists.add_configuration(unit)
        elif isinstance(unit, ast.Namespace | ast.Using | ast.LoneMember):
            pass  # what they hold and mean is in the other units by now
        elif isinstance(unit, ast.Interface):
            if self._is_new(unit.name):
                self.objects.interfaces.declare(unit)
                self.has_members = True
        elif self._is_new(unit.name):
            key = unit.name.name.casefold()
            if isinstance(unit, ast.TypeDeclaration):
                self.types.declare(unit)
            elif isinstance(unit, ast.Block):
                if unit.kind is BlockKind.CLASS:
                    # A class is a function block that nobody can call.
                    self._classes.add(key)
                    unit = replace(unit, kind=BlockKind.FUNCTION_BLOCK)
                self._syntax[key] = unit
                self.has_members |= bool(unit.members) or unit.extends is not None
            else:
                self._data_blocks[key] = unit

    def _is_new(self, name: ast.Name) -> bool:
        key = name.name.casefold()
        if key in self._units:
            self.duplicate(name.name, name.span, self._units[key][1])
            return False
        self._units[key] = (name.name, name.span)
        return True

    def duplicate(self, name: str, span: Span, first: Span) -> None:
        """Report a name that is declared twice, with both places."""
        self.findings.error(
            "FB4002",
            f"'{name}' is declared twice",
            span,
            "give one of them another name (upper and lower case are the same)",
            (Note("the first one is here", first),),
        )

    def declare_constants(self) -> None:
        """Declare the global constants."""
        self._interfaces.declare_constants(self.global_context(), self.lists.sections, None)

    def declare_globals(self) -> None:
        """Declare global variables and data blocks."""
        ctx = self.global_context()
        self._interfaces.declare(ctx, self.lists.sections, None)
        for key, node in self._data_blocks.items():
            entry = self.globals.entries.get(key)
            if entry is not None:
                self.duplicate(node.name.name, node.name.span, entry.span)
                continue
            variable = self._data_block(ctx, node)
            self.globals.entries[key] = variable
            self.memory.declare(variable, self._is_optimized(node))
        for key, (name, span) in self._units.items():
            entry = self.globals.entries.get(key)
            in_list = self.lists.has(key)
            if entry is not None and key not in self._data_blocks and not in_list:
                self.duplicate(name, span, entry.span)

    def _is_optimized(self, node: ast.DataBlock) -> bool:
        """An instance has the access that its function block has."""
        block = None if node.type is None else self._syntax.get(node.type.name.casefold())
        return is_optimized(node.header if block is None else block.header)

    def _data_block(self, ctx: Context, node: ast.DataBlock) -> Variable:
        initial: Initial | None = None
        kind: Type
        if node.type is not None:
            resolved = self.types.named(ctx, node.type.name, node.type.span, node.type.quoted)
            kind, initial = resolved.type, resolved.initial
            if not isinstance(kind, StructType | BlockType) and kind != ERRONEOUS:
                self.findings.error(
                    "FB4010",
                    f"a data block cannot be of type {kind.name}",
                    node.type.span,
                    "use a structure (UDT) or a function block",
                )
                kind = ERRONEOUS
        else:
            declarations = list(node.struct.fields) if node.struct is not None else []
            for section in node.sections:
                declarations += section.declarations
            kind = self.types.structure(ctx, tuple(declarations), node.name.name)
        if kind != ERRONEOUS:
            initial = self._initials.assign(ctx, node.assignments, kind, initial)
        remanent = self._is_remanent(node)
        return Variable(
            node.name.span, node.name.name, VariableKind.GLOBAL, kind, initial, remanent
        )

    def _is_remanent(self, node: ast.DataBlock) -> bool:
        """RETAIN in its head or at a section; in STEP 7 V5 all that is not NON_RETAIN."""
        flags = {item.keyword for item in node.header}
        if self.rules.dialect == "step7":
            return "NON_RETAIN" not in flags
        return "RETAIN" in flags or any("RETAIN" in section.qualifiers for section in node.sections)

    # --- asking -------------------------------------------------------------------------------

    def global_context(self) -> Context:
        """A context that knows global names only."""
        return Context(self, self.globals)

    @property
    def configurations(self) -> Sequence[ast.Configuration]:
        """The configurations of all files."""
        return self._configurations

    def block_names(self) -> list[str]:
        """The names of all blocks of the text."""
        return [node.name.name for node in self._syntax.values()]

    def is_block_name(self, key: str) -> bool:
        """True for a casefolded name of a block of the text."""
        return key in self._syntax

    def is_declared(self, name: str) -> bool:
        """True for the name of any unit of the text."""
        return name.casefold() in self._units

    def type_names(self) -> list[str]:
        """The names of all function blocks, as types of instances."""
        kind = BlockKind.FUNCTION_BLOCK
        own = [node.name.name for node in self._syntax.values() if node.kind is kind]
        return own + [block.name for block in STANDARD_BLOCKS.values()]

    def block_type(self, name: str) -> BlockType | None:
        """The type of instances of a function block; None if there is no such block."""
        key = name.casefold()
        node = self._syntax.get(key)
        if node is not None:
            if node.kind is not BlockKind.FUNCTION_BLOCK:
                return None
            name = node.name.name
            self.user_block(name)  # reports a block that contains itself
        else:
            standard = self.controller_block(name)
            if standard is None:
                return None
            name = standard.name
        return self._block_types.setdefault(name.casefold(), BlockType(name))

    def block(self, name: str) -> AnyBlock | None:
        """The block with that name, the user's before the standard one."""
        return self.user_block(name) or self.controller_block(name)

    def controller_block(self, name: str) -> StandardBlock | None:
        """The function block that the text need not have: a standard, hardware or stubbed one."""
        block = standard_block(name)
        if block is not None:
            return block
        dialect = self.rules.dialect
        block = hardware_block(name, dialect) if dialect in _S7 else None
        if block is None and self.is_stubbed(name):
            block = stubbed_block(self._stubbed[name.casefold()])
        if block is not None:
            self.unmodelled[block.name.casefold()] = block
        return block

    def is_incomplete(self, kind: Type) -> bool:
        """True for a structure or block that may have more members than are known."""
        return isinstance(kind, StructType | BlockType) and kind.name.casefold() in self.incomplete

    def is_stubbed(self, name: str) -> bool:
        """True if the user has said that a stub stands for the block of this name."""
        return name.casefold() in self._stubbed

    def stubbed_name(self, name: str) -> str:
        """The name as the user has given it."""
        return self._stubbed[name.casefold()]

    def variables_of(self, kind: BlockType) -> tuple[Variable, ...]:
        """Everything declared in the block of an instance."""
        block = self.block(kind.name)
        return block.variables if block is not None else ()

    def parts_of(self, kind: Type) -> list[tuple[str, Type, Initial | None]]:
        """Name, type and initial value of what a structure or instance holds."""
        if isinstance(kind, StructType):
            return [(part.name, part.type, part.initial) for part in kind.fields]
        if isinstance(kind, BlockType):
            return [
                (part.name, part.type, part.initial)
                for part in self.variables_of(kind)
                if part.kind in LIVING
            ]
        return []

    def initial(
        self, ctx: Context, node: ast.Expression, kind: Type, base: Initial | None
    ) -> Initial | None:
        """The value of an initializer; see `Initials.check`."""
        return self._initials.check(ctx, node, kind, base)

    # --- blocks -------------------------------------------------------------------------------

    def user_block(self, name: str) -> Block | None:
        """The block of the text with that name, its interface resolved; None if there is none."""
        key = name.casefold()
        if key in self._blocks:
            return self._blocks[key]
        node = self._syntax.get(key)
        if node is None:
            return None
        if key in self._busy or len(self._busy) > _NESTING:
            self._report_recursion(key, node)
            return None
        self._busy.append(key)
        self._owners.append(node.name.name)
        block = self._interface(node)
        self._owners.pop()
        self._busy.pop()
        self._blocks[key] = block
        return block

    def _report_recursion(self, key: str, node: ast.Block) -> None:
        if key not in self._busy:
            self.findings.error(
                "FB4053",
                f"instances are nested deeper than {_NESTING} levels",
                node.name.span,
                "put fewer function blocks into each other",
            )
            return
        chain = [self._units[one][0] for one in self._busy[self._busy.index(key) :]]
        self.findings.error(
            "FB4050",
            f"'{node.name.name}' contains an instance of itself: "
            + " -> ".join([*chain, chain[0]]),
            node.name.span,
            "give the inner instance to the block as VAR_IN_OUT, or take it out",
        )

    def _interface(self, node: ast.Block) -> Block:
        kind = node.kind
        ctx = Context(self, Scope())
        base = self.objects.find_base(node)
        inherited = self._inherit(ctx, base) if base is not None else []
        result = self._result(ctx, node) if kind is BlockKind.FUNCTION else None
        if result is not None:
            ctx.scope.entries[result.name.casefold()] = result
        self._interfaces.declare_constants(ctx, node.sections, kind)
        sections = (*node.sections, *kept_sections(node))
        variables = self._interfaces.declare(ctx, sections, kind, node.header)
        variables += self._enable_variables(ctx, node)
        if result is not None:
            variables.append(result)
        every = (*inherited, *variables)
        block = Block(node.span, node.name.name, kind, every, result, node)
        ctx.block = block
        self._contexts[block] = ctx
        self.access.enter(block, node.sections, variables)
        if base is not None:
            self.objects.extend(block, base)
        if is_foreign(node.body):
            self.objects.leave_open(node)
        if node.extends is not None or node.members:
            ctx.owner = block
            ctx.this = self.objects.instance_of(block)
        return block

    def _inherit(self, ctx: Context, base: Block) -> list[Variable]:
        """Names of the base in the scope of a derived block, and its variables."""
        around = self._contexts[base]
        ctx.not_started += around.not_started
        inherited = self.objects.inherited(base)
        for key in list(around.scope.entries):
            symbol = around.local(key)
            if symbol is not None and (not isinstance(symbol, Variable) or symbol in inherited):
                ctx.scope.entries[key] = symbol
                ctx.used.add(symbol)
        return inherited

    # --- members of blocks --------------------------------------------------------------------

    def instance_type(self, block: Block) -> BlockType:
        """The type of the instances of a block, also of one that cannot be declared."""
        return self._block_types.setdefault(block.name.casefold(), BlockType(block.name))

    def program_variable(self, name: str) -> Variable | None:
        """The instance that a PROGRAM is for other blocks; None if the name is of none."""
        key = name.casefold()
        node = self._syntax.get(key)
        if node is None or node.kind is not BlockKind.PROGRAM:
            return None
        block = self.user_block(name)
        if block is not None and key not in self.programs:
            kind = self.instance_type(block)
            self.programs[key] = Variable(block.span, block.name, VariableKind.GLOBAL, kind)
        return self.programs.get(key)

    def own_blocks(self) -> list[Block]:
        """The blocks of the text, without their methods and actions."""
        return list(self._blocks.values())

    def member_block(self, owner: Block, this: Variable, node: ast.Block) -> Block:
        """The code of a method: a FUNCTION with the instance as its first in-out."""
        ctx = Context(self, Scope())
        ctx.owner, ctx.this = owner, this
        ctx.method = node.name.name.casefold()
        ctx.scope.entries[RECEIVER.casefold()] = this
        self.receivers.add(this)
        variables = [this]
        result = self._result(ctx, node)
        if result is not None:
            ctx.scope.entries[result.name.casefold()] = result
        sections = [one for one in node.sections if one.keyword != "VAR_INST"]
        name = f"{owner.name}.{node.name.name}"
        self._owners.append(name)
        self._interfaces.declare_constants(ctx, sections, node.kind)
        variables += self._interfaces.declare(ctx, sections, node.kind)
        self._owners.pop()
        if result is not None:
            variables.append(result)
        block = Block(node.span, name, node.kind, tuple(variables), result, node)
        ctx.block = block
        self._contexts[block] = ctx
        return block

    def add_interface(self, block: Block) -> None:
        """What stands for an interface has no variables: its methods see global names only."""
        self._contexts[block] = Context(self, Scope(), block)

    def is_class(self, block: Block) -> bool:
        """True for a CLASS, whose instances have methods and no body."""
        return block.name.casefold() in self._classes

    def share_context(self, owner: Block, action: Block) -> None:
        """An action sees what its block sees."""
        around = self._contexts[owner]
        ctx = Context(self, around.scope, action)
        ctx.owner, ctx.this = owner, self.objects.instance_of(owner)
        ctx.used, ctx.written = around.used, around.written
        self._contexts[action] = ctx

    def _enable_variables(self, ctx: Context, node: ast.Block) -> list[Variable]:
        """What the block has because it speaks of ENO, if it does not declare that itself."""
        names, flag = enable_variables(node, self.rules.dialect)
        found = [] if flag is None else [flag]
        ctx.call_flag = flag
        for name, variable in names.items():
            if name in ctx.scope.entries:
                continue
            ctx.scope.entries[name] = variable
            if variable is not ctx.own_eno:
                found.append(variable)
            ctx.own_eno = variable
            if variable.kind is VariableKind.OUTPUT:
                self.implicit.add(variable)
        if ctx.own_eno is not None and self.rules.dialect == "step7":
            ctx.overflow_flag = ctx.own_eno
        return found

    def _result(self, ctx: Context, node: ast.Block) -> Variable | None:
        if node.return_type is None:
            return None
        resolved = self.types.resolve(ctx, node.return_type)
        if resolved.type == VOID:
            return None
        name = node.name.name.removesuffix(".GET").rpartition(".")[2]
        return Variable(node.name.span, name, VariableKind.RESULT, resolved.type, resolved.initial)

    def name_of_shared(self, name: str) -> str:
        """The global name of a VAR_STAT of the block or method that is being resolved.

        All instances of the block share it, and it outlives the calls of a FUNCTION.
        """
        return f"{self._owners[-1]}.{name}"

    def all_blocks(self) -> Mapping[str, Block]:
        """All blocks of the text by casefolded name, their interfaces resolved."""
        for node in self._syntax.values():
            self.user_block(node.name.name)
        return {**self._blocks, **self.objects.written_blocks()}

    def context_of(self, block: Block) -> Context:
        """The context in which the block's statements are checked."""
        return self._contexts[block]
