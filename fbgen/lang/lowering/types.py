"""Types and declarations in IEC: structures get names, bounds become literals.

Source: IEC 61131-3 second edition: a structure can only be declared in TYPE ... END_TYPE.
"""

from fbgen.lang.ast import (
    ArraySpec,
    Bounds,
    Declaration,
    DeclaredName,
    Name,
    NamedType,
    StringSpec,
    StructSpec,
    TypeDeclaration,
    TypeSpec,
)
from fbgen.lang.lowering.context import Context
from fbgen.lang.lowering.expressions import ExpressionLowering
from fbgen.lang.lowering.plant import BlockScope
from fbgen.lang.lowering.spelling import STANDARD_BLOCKS, TYPES


class TypeLowering:
    """Rewrites the types of one unit. `owner` names the types of its structures."""

    def __init__(self, context: Context, owner: str, scope: BlockScope | None) -> None:
        self.context = context
        self.scope = scope
        self._owner = owner
        self._values = ExpressionLowering(context, scope)

    def type_spec(self, spec: TypeSpec, wish: str) -> TypeSpec:
        """A type where a variable uses it; `wish` is the name for a structure in it."""
        if isinstance(spec, NamedType):
            return self._named(spec)
        if isinstance(spec, StringSpec):
            return self._string(spec)
        if isinstance(spec, ArraySpec):
            bounds = tuple(self._bounds(one) for one in spec.bounds)
            return ArraySpec(spec.span, bounds, self.type_spec(spec.element, wish))
        if not isinstance(spec, StructSpec):
            self.context.findings.refuse(
                "this type", spec.span, "use elementary types, arrays and structures"
            )
            return spec
        name = self.context.names.new(f"{self._owner}_{wish}" if wish else self._owner)
        self.context.new_types.append(
            TypeDeclaration(spec.span, Name(spec.span, name), (), self.structure(spec))
        )
        return NamedType(spec.span, name)

    def structure(self, spec: StructSpec) -> StructSpec:
        """A structure as it stands in a TYPE."""
        fields = tuple(self.declaration(one) for one in spec.fields)
        return StructSpec(spec.span, fields, spec.closing, spec.opening)

    def declaration(self, node: Declaration) -> Declaration:
        """A variable or a field."""
        for name in node.names:
            self._check_name(name)
        if node.at is not None:
            self.context.findings.refuse(
                f"{node.names[0].name} AT {node.at.span.text}",
                node.span,
                "take the value apart with shifts and masks",
            )
        names = tuple(DeclaredName(name.span, name.name) for name in node.names)
        spec = self.type_spec(node.type, node.names[0].name)
        initial = None if node.initial is None else self._values.expression(node.initial)
        return Declaration(node.span, names, spec, initial, None, "", node.leading, node.trailing)

    def _check_name(self, name: DeclaredName) -> None:
        """Fields may be called like blocks, variables of a block may not."""
        if self.scope is None:
            self.context.names.check(name.name, name.span)
        else:
            self.context.names.check_declared(name.name, name.span)

    def _named(self, spec: NamedType) -> TypeSpec:
        upper = spec.name.upper()
        key = spec.name.casefold()
        if key in self.context.plant.types:
            return NamedType(spec.span, self.context.plant.types[key].name.name)
        if key in self.context.plant.blocks:
            return NamedType(spec.span, self.context.plant.blocks[key].name.name)
        if not spec.quoted:
            upper = TYPES.get(upper, upper)
            if upper in self.context.target.elementary or upper in STANDARD_BLOCKS:
                return NamedType(spec.span, upper)
        if spec.quoted:
            message = f"the type {spec.name} is declared in none of the files"
            help_text = "convert the file that declares it as well"
        else:
            dialect = self.context.findings.dialect
            message = f"the type {spec.name} has no counterpart in dialect {dialect}"
            help_text = "use an elementary type of IEC 61131-3"
        self.context.findings.report("FB3052", message, spec.span, help_text)
        return spec

    def _string(self, spec: StringSpec) -> TypeSpec:
        if spec.wide:
            self.context.findings.report(
                "FB3052",
                f"the type WSTRING has no counterpart in dialect {self.context.findings.dialect}",
                spec.span,
                "use STRING",
            )
        length = None if spec.length is None else self._values.constant(spec.length)
        return StringSpec(spec.span, spec.wide, length)

    def _bounds(self, bounds: Bounds) -> Bounds:
        if bounds.first is None or bounds.last is None:
            self.context.findings.refuse("ARRAY[*]", bounds.span, "write the bounds")
            return bounds
        return Bounds(
            bounds.span, self._values.constant(bounds.first), self._values.constant(bounds.last)
        )
