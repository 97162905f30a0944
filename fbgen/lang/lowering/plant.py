"""What the files of a plant declare, and the types of places in them.

Only what lowering needs: the declared type of a variable, a member, an element. Whether the text
is right is the checker's business and is taken for granted.
"""

from collections.abc import Iterable, Mapping, Sequence

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

_PARAMETERS = ("VAR_INPUT", "VAR_OUTPUT", "VAR_IN_OUT")


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


class Scope:
    """Names that mean variables, in front of those of the plant."""

    def __init__(self, plant: PlantText, declared: Mapping[str, TypeSpec]) -> None:
        self.plant = plant
        self.declared = dict(declared)

    @classmethod
    def of_data_block(cls, plant: PlantText, block: DataBlock) -> "Scope":
        """The names that the start values of a data block are given to."""
        scope = cls(plant, {})
        scope.declared |= _types_by_name(scope.fields_of(_type_of_data_block(block)))
        return scope

    def is_declared(self, name: Name) -> bool:
        """Whether the name is one of them."""
        return name.name.casefold() in self.declared

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
            array = self.resolved(self.type_of(place.base))
            return array.element if isinstance(array, ArraySpec) else None
        if isinstance(place, Member):
            return _types_by_name(self.fields_of(self.type_of(place.base))).get(
                place.name.casefold()
            )
        return None

    def elementary_of(self, place: Expression) -> str:
        """The upper-case name of the elementary type of a place, else ""."""
        spec = self.resolved(self.type_of(place))
        return spec.name.upper() if isinstance(spec, NamedType) and not spec.quoted else ""

    def resolved(self, spec: TypeSpec | None) -> TypeSpec | None:
        """A UDT's own type in place of its name, as often as it takes."""
        for _ in range(len(self.plant.types) + 1):
            if not isinstance(spec, NamedType):
                break
            declaration = self.plant.types.get(spec.name.casefold())
            if declaration is None:
                break
            spec = declaration.type
        return spec

    def fields_of(self, spec: TypeSpec | None) -> tuple[Declaration, ...]:
        """What a structure, or an instance of a block, consists of."""
        spec = self.resolved(spec)
        if isinstance(spec, StructSpec):
            return spec.fields
        if isinstance(spec, NamedType):
            block = self.plant.blocks.get(spec.name.casefold())
            if block is not None:
                return _all(block.sections)
        return ()

    def block_called(self, callee: Expression) -> Block | None:
        """The user's function, or block of an instance, that a call means."""
        name: str | None = None
        if isinstance(callee, Name) and not self.is_declared(callee):
            name = callee.name
        kind = self.type_of(callee)
        if isinstance(kind, NamedType):
            name = kind.name
        return self.plant.blocks.get(name.casefold()) if name else None

    def parameters_of(self, callee: Expression) -> tuple[tuple[str, TypeSpec], ...]:
        """Names and types of the parameters of a function or instance, in their order."""
        block = self.block_called(callee)
        return tuple(
            (declared.name, declaration.type)
            for section in (block.sections if block else ())
            if section.keyword in _PARAMETERS
            for declaration in section.declarations
            for declared in declaration.names
        )


class BlockScope(Scope):
    """The names that a block declares, in front of those of the plant."""

    def __init__(self, plant: PlantText, block: Block) -> None:
        super().__init__(plant, {})
        self.block = block
        self.constants: dict[str, Expression] = {}
        self.inputs: set[str] = set()
        for section in block.sections:
            self.declared |= _types_by_name(section.declarations)
            for declaration in section.declarations:
                keys = [name.name.casefold() for name in declaration.names]
                if section.keyword == "VAR_INPUT":
                    self.inputs |= set(keys)
                if "CONSTANT" in section.qualifiers and declaration.initial is not None:
                    self.constants |= dict.fromkeys(keys, declaration.initial)
        if block.return_type is not None:
            self.declared.setdefault(block.name.name.casefold(), block.return_type)

    def is_declared(self, name: Name) -> bool:
        """Whether the block itself declares the name."""
        key = name.name.casefold()
        is_result = key == self.block.name.name.casefold()
        return (name.local or not name.quoted or is_result) and key in self.declared


def _type_of_data_block(block: DataBlock) -> TypeSpec:
    if block.type is not None:
        return block.type
    return block.struct or StructSpec(block.span, tuple(_all(block.sections)))


def _all(sections: Iterable[VarSection]) -> tuple[Declaration, ...]:
    return tuple(one for section in sections for one in section.declarations)


def _types_by_name(declarations: Iterable[Declaration]) -> dict[str, TypeSpec]:
    return {
        declared.name.casefold(): declaration.type
        for declaration in declarations
        for declared in declaration.names
    }
