"""What the files of a plant declare, and the types of places in them.

Only what lowering needs: the declared type of a variable, a member, an element. Whether the text
is right is the checker's business and is taken for granted.
"""

from collections.abc import Iterable, Sequence

from fbgen.lang.ast import (
    ArraySpec,
    Block,
    BlockKind,
    DataBlock,
    Declaration,
    Expression,
    File,
    Index,
    Literal,
    Member,
    Name,
    NamedType,
    Parenthesized,
    StructSpec,
    TypeDeclaration,
    TypeSpec,
    VarSection,
)


class PlantText:
    """All blocks, data blocks and types of a plant, by casefolded name."""

    def __init__(self, files: Sequence[File]) -> None:
        self.units = tuple(unit for file in files for unit in file.units)
        self.blocks: dict[str, Block] = {}
        self.data_blocks: dict[str, DataBlock] = {}
        self.types: dict[str, TypeDeclaration] = {}
        for unit in self.units:
            if isinstance(unit, Block):
                self.blocks[unit.name.name.casefold()] = unit
            elif isinstance(unit, DataBlock):
                self.data_blocks[unit.name.name.casefold()] = unit
            elif isinstance(unit, TypeDeclaration):
                self.types[unit.name.name.casefold()] = unit

    def is_data_block(self, name: Name) -> bool:
        """Whether a name that is not local names a data block."""
        return not name.local and name.name.casefold() in self.data_blocks

    def function(self, name: str) -> Block | None:
        """The FUNCTION of that name."""
        block = self.blocks.get(name.casefold())
        return block if block and block.kind is BlockKind.FUNCTION else None


class BlockScope:
    """The names that a block declares, in front of those of the plant."""

    def __init__(self, plant: PlantText, block: Block) -> None:
        self.plant = plant
        self.block = block
        self.declared: dict[str, TypeSpec] = {}
        self.constants: dict[str, Expression] = {}
        self.inputs: set[str] = set()
        for section in block.sections:
            for declaration in section.declarations:
                for name in declaration.names:
                    key = name.name.casefold()
                    self.declared[key] = declaration.type
                    if section.keyword == "VAR_INPUT":
                        self.inputs.add(key)
                    if "CONSTANT" in section.qualifiers and declaration.initial is not None:
                        self.constants[key] = declaration.initial
        if block.return_type is not None:
            self.declared.setdefault(block.name.name.casefold(), block.return_type)

    def is_declared(self, name: Name) -> bool:
        """Whether the block itself declares the name."""
        key = name.name.casefold()
        is_result = key == self.block.name.name.casefold()
        return (name.local or not name.quoted or is_result) and key in self.declared

    def type_of(self, place: Expression) -> TypeSpec | None:
        """The declared type of a place or a typed literal; None if it cannot be seen."""
        if isinstance(place, Parenthesized):
            return self.type_of(place.inner)
        if isinstance(place, Literal):
            return NamedType(place.span, place.type_name) if place.type_name else None
        if isinstance(place, Name):
            if self.is_declared(place):
                return self.declared[place.name.casefold()]
            block = self.plant.data_blocks.get(place.name.casefold())
            return _type_of_data_block(block) if block else None
        if isinstance(place, Index):
            array = self._resolved(self.type_of(place.base))
            return array.element if isinstance(array, ArraySpec) else None
        if isinstance(place, Member):
            return self._member(self._resolved(self.type_of(place.base)), place.name)
        return None

    def elementary_of(self, place: Expression) -> str:
        """The upper-case name of the elementary type of a place, else ""."""
        spec = self._resolved(self.type_of(place))
        return spec.name.upper() if isinstance(spec, NamedType) and not spec.quoted else ""

    def _resolved(self, spec: TypeSpec | None) -> TypeSpec | None:
        """A UDT's own type in place of its name, as often as it takes."""
        for _ in range(len(self.plant.types) + 1):
            if not isinstance(spec, NamedType):
                break
            declaration = self.plant.types.get(spec.name.casefold())
            if declaration is None:
                break
            spec = declaration.type
        return spec

    def _member(self, spec: TypeSpec | None, name: str) -> TypeSpec | None:
        if isinstance(spec, StructSpec):
            return _find(spec.fields, name)
        if isinstance(spec, NamedType):
            block = self.plant.blocks.get(spec.name.casefold())
            if block is not None:
                return _find(_all(block.sections), name)
        return None


def _type_of_data_block(block: DataBlock) -> TypeSpec:
    if block.type is not None:
        return block.type
    return block.struct or StructSpec(block.span, tuple(_all(block.sections)))


def _all(sections: Iterable[VarSection]) -> tuple[Declaration, ...]:
    return tuple(one for section in sections for one in section.declarations)


def _find(declarations: Iterable[Declaration], name: str) -> TypeSpec | None:
    key = name.casefold()
    for declaration in declarations:
        if any(declared.name.casefold() == key for declared in declaration.names):
            return declaration.type
    return None
