"""The whole program."""

from collections.abc import Mapping
from dataclasses import field

from fbgen.lang.ast import BlockKind, node
from fbgen.lang.checked.statements import Statement
from fbgen.lang.checked.variables import AnyBlock, Block, StandardBlock, Variable
from fbgen.lang.types import BlockType, StructType


@node
class Task:
    """A task of a configuration: period in nanoseconds (None: free running), lower is earlier.

    `single` names the global BOOL whose rising edge starts it, "" if it has none.
    """

    name: str
    interval_ns: int | None
    priority: int
    programs: tuple[tuple[str, Block], ...]
    single: str = ""


@node
class BlockMembers:
    """What an instance of a block can be asked for, its bases included, by casefolded name.

    `starts` are the FB_init of the bases and the block itself, in the order in which they run.
    """

    methods: Mapping[str, Block]
    getters: Mapping[str, Block]
    setters: Mapping[str, Block]
    actions: Mapping[str, Block]
    starts: tuple[Block, ...] = ()


@node
class Program:
    """All blocks, types and global variables of a set of files.

    The mappings are keyed by the casefolded name. `bodies` has the statements of every block.
    `dialect` chooses between the rules of S7 and IEC where they differ.

    `byte_memory` has what is reached besides its name and lies in bytes as `fbgen.lang.layout`
    says: overlays and what is under them, addressed data blocks, the variables of their function
    blocks. `data_blocks` are those with a number. `members` has the blocks with methods, properties
    or actions. `starts` has for blocks with instances inside that have an FB_init the FUNCTION that
    calls those, with the in-out THIS and the input `retains`; "" is for the global variables.
    `temporaries` are further variables of a block, TEMP, that hold a value within one statement;
    they are written before they are read. `lists` has for each list of global variables its
    variables and the keys that these have in `globals`, all casefolded. `called_programs` are the
    PROGRAMs that some block calls.
    """

    dialect: str
    blocks: Mapping[str, Block]
    bodies: Mapping[Block, tuple[Statement, ...]]
    structures: Mapping[str, StructType]
    globals: Mapping[str, Variable]
    standard_blocks: Mapping[str, StandardBlock]
    tasks: tuple[Task, ...] = field(default=())
    byte_memory: frozenset[Variable] = field(default=frozenset())
    data_blocks: Mapping[int, Variable] = field(default_factory=dict)
    members: Mapping[str, BlockMembers] = field(default_factory=dict)
    starts: Mapping[str, Block] = field(default_factory=dict)
    temporaries: Mapping[Block, tuple[Variable, ...]] = field(default_factory=dict)
    lists: Mapping[str, Mapping[str, str]] = field(default_factory=dict)
    called_programs: frozenset[Block] = field(default=frozenset())

    def program_instances(self) -> dict[str, Block]:
        """The PROGRAMs by casefolded names: their own, and those that a configuration gives."""
        instances = {
            key: block for key, block in self.blocks.items() if block.kind is BlockKind.PROGRAM
        }
        for task in self.tasks:
            instances |= {name.casefold(): block for name, block in task.programs}
        return instances

    def program_variable(self, key: str) -> Variable | None:
        """The global variable that a PROGRAM is because other blocks name it; else None."""
        variable = self.globals.get(key)
        kind = None if variable is None else variable.type
        block = self.blocks.get(key)
        is_own = isinstance(kind, BlockType) and block is not None and kind.name == block.name
        return variable if is_own else None

    def block_of(self, type_name: str) -> AnyBlock:
        """The function block of that name, the user's before the standard one."""
        key = type_name.casefold()
        return self.blocks[key] if key in self.blocks else self.standard_blocks[key]
