"""What all parts of one lowering share: the plant, the findings, new types and globals."""

from fbgen.lang.ast import (
    Block,
    BlockKind,
    Declaration,
    DeclaredName,
    DirectAddress,
    Name,
    NamedType,
    TypeDeclaration,
    TypeSpec,
)
from fbgen.lang.lowering.findings import Findings
from fbgen.lang.lowering.names import Names
from fbgen.lang.lowering.plant import PlantText
from fbgen.lang.lowering.target import Target
from fbgen.lang.walk import walk


class Context:
    """State of one lowering. `new_types` and `located_variables` grow while blocks are lowered."""

    def __init__(self, plant: PlantText, target: Target, findings: Findings) -> None:
        self.plant = plant
        self.target = target
        self.findings = findings
        self.names = Names(target.dialect, findings)
        self.new_types: list[TypeDeclaration] = []
        self.located_variables: dict[str, Declaration] = {}
        self.types_of_globals: dict[str, TypeSpec] = {}
        for name in (*plant.blocks, *plant.data_blocks, *plant.types):
            self.names.reserve(name)
        self._programs = self._find_programs()

    def is_program(self, block: Block) -> bool:
        """Whether a block becomes a PROGRAM."""
        return block.name.name.casefold() in self._programs

    def global_name(self, name: str) -> str:
        """The name of a data block as it was declared."""
        return self.plant.data_blocks[name.casefold()].name.name

    def located(self, address: DirectAddress) -> str:
        """The global variable that stands for an absolute address."""
        size = "B" if address.size == "B" else "X"
        bit = f"_{address.bit}" if size == "X" else ""
        key = f"{address.area}{size}{address.byte}{bit}"
        if key.casefold() not in self.located_variables:
            place = address.span
            spec = NamedType(place, "BYTE" if size == "B" else "BOOL")
            declared = DeclaredName(place, key)
            self.located_variables[key.casefold()] = Declaration(
                place, (declared,), spec, None, address
            )
            self.types_of_globals[key.casefold()] = spec
        return key

    def _find_programs(self) -> frozenset[str]:
        """Organization blocks, and functions that reach global data where only programs may."""
        functions = {
            key: block
            for key, block in self.plant.blocks.items()
            if block.kind is BlockKind.FUNCTION
        }
        reaching = {
            key
            for key, block in functions.items()
            if not self.target.has_free_globals and self._uses_global_data(block)
        }
        organization = {
            key
            for key, block in self.plant.blocks.items()
            if block.kind in (BlockKind.ORGANIZATION_BLOCK, BlockKind.PROGRAM)
        }
        return frozenset(reaching | organization)

    def _uses_global_data(self, block: Block) -> bool:
        for node in walk(block.body):
            if isinstance(node, DirectAddress):
                return True
            if isinstance(node, Name) and self.plant.is_data_block(node):
                return True
        return False
