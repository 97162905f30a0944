"""NAMESPACE and USING: every name of a unit in a namespace is written whole, before all checking.

A name means the unit in the innermost namespace around it that has one; where a namespace, a block
or a file opens others by USING, also theirs. What INTERNAL hides is reported where it is named.
Behind this pass `Plant.Motors.Axis` is a name like any other.
Source: IEC 61131-3 third edition, section 6.9 "Namespaces".
"""

from collections.abc import Iterator, Sequence
from typing import Any, ClassVar, TypeAlias

from fbgen.dataclass import dataclass
from fbgen.diagnostics import Note
from fbgen.lang import ast
from fbgen.lang.checker.findings import Findings
from fbgen.lang.rewriting import Rewriter, Rule, replaced
from fbgen.nearest import nearest
from fbgen.source import Span

Named: TypeAlias = ast.Block | ast.TypeDeclaration | ast.Interface | ast.DataBlock


@dataclass(frozen=True, slots=True)
class Level:
    """One layer of what a name can mean: a namespace ("" around all), and what is opened there."""

    namespace: str | None
    opened: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Element:
    """A unit by its whole name."""

    name: str
    span: Span
    hidden_in: str | None
    """The namespace outside of which INTERNAL hides it; None where nothing does."""


class Namespaces:
    """The units of a program by their whole names."""

    def __init__(self) -> None:
        self.elements: dict[str, Element] = {}
        self.names: dict[str, str] = {"": ""}
        """All namespaces, by casefolded name."""
        self.blocks: dict[str, ast.Block] = {}

    def enter(self, units: Sequence[ast.Unit], around: str = "", hidden: str | None = None) -> None:
        """Take note of all units, and of those in the namespaces among them."""
        for unit in units:
            if isinstance(unit, ast.Namespace):
                name = joined(around, unit.name)
                for part in _prefixes(name):
                    self.names.setdefault(part.casefold(), part)
                outside = around if "INTERNAL" in unit.modifiers else hidden
                self.enter(unit.units, name, outside)
            elif isinstance(unit, Named):
                name = joined(around, unit.name.name)
                modifiers = () if isinstance(unit, ast.DataBlock) else unit.modifiers
                inside = around if "INTERNAL" in modifiers else hidden
                self.elements.setdefault(name.casefold(), Element(name, unit.name.span, inside))
                if isinstance(unit, ast.Block):
                    self.blocks.setdefault(name.casefold(), unit)

    def namespaces_with(self, name: str) -> list[str]:
        """The namespaces that have a unit of this name, for a help text."""
        key = "." + name.casefold()
        return [
            one.name[: -len(key)] for found, one in self.elements.items() if found.endswith(key)
        ]


def written_whole(
    files: Sequence[ast.File], findings: Findings
) -> tuple[Sequence[ast.File], Namespaces]:
    """The files with whole names, and all that namespaces hold; the same without namespaces."""
    known = Namespaces()
    if not any(
        isinstance(unit, ast.Namespace | ast.Using)
        or (isinstance(unit, ast.Block | ast.Interface) and unit.usings)
        for file in files
        for unit in file.units
    ):
        return files, known
    for file in files:
        known.enter(file.units)
    written = []
    for file in files:
        scope = _Scope(known, findings, (), "")
        units, behind = scope.units(file.units)
        written.append(ast.File(file.source, file.dialect, units, (*behind, *file.closing)))
    return written, known


def joined(namespace: str, name: str) -> str:
    """A name in a namespace, whole."""
    return f"{namespace}.{name}" if namespace else name


def namespace_help(known: Namespaces, name: str) -> str:
    """Where a name is that is not seen here; "" if it is in no namespace."""
    found = known.namespaces_with(name)
    if not found:
        return ""
    whole = " or ".join(f"{one}.{name}" for one in found)
    return f"it is in a namespace: write {whole}, or open that with USING {found[0]};"


def is_inside(namespace: str, other: str) -> bool:
    """True for a namespace that is `other`, or in it."""
    return f"{namespace}.".casefold().startswith(f"{other}.".casefold()) or not other


def _prefixes(name: str) -> Iterator[str]:
    parts = name.split(".")
    for length in range(1, len(parts) + 1):
        yield ".".join(parts[:length])


class _Scope:
    """What names mean in one place of the text; `around` has the innermost level last."""

    def __init__(
        self, known: Namespaces, findings: Findings, around: tuple[Level, ...], namespace: str
    ) -> None:
        self.known = known
        self.findings = findings
        self.around = around
        self.namespace = namespace

    def units(self, units: Sequence[ast.Unit]) -> tuple[tuple[ast.Unit, ...], ast.TriviaList]:
        """The units of this namespace with whole names, those of namespaces in it among them.

        Comments of what is gone go to the unit behind it; the second part is what has none.
        """
        usings = [unit for unit in units if isinstance(unit, ast.Using)]
        inside = self.within(self.namespace, usings)
        found: list[ast.Unit] = []
        waiting: ast.TriviaList = ()
        for unit in units:
            if isinstance(unit, ast.Namespace):
                inner, behind = inside._nested(unit)
                waiting += unit.leading
                if inner:
                    inner = (_with_comments(inner[0], waiting), *inner[1:])
                    waiting = ()
                found += inner
                waiting += (*behind, *unit.closing)
            elif isinstance(unit, ast.Using):
                waiting += (*unit.leading, *((unit.trailing,) if unit.trailing else ()))
            else:
                found.append(_with_comments(inside._whole(unit), waiting))
                waiting = ()
        return tuple(found), waiting

    def _nested(self, node: ast.Namespace) -> tuple[tuple[ast.Unit, ...], ast.TriviaList]:
        *outer, _ = _prefixes(joined(self.namespace, node.name))
        around = self.around
        for name in outer:
            if not is_inside(self.namespace, name):
                around = (*around, Level(name, ()))
        name = joined(self.namespace, node.name)
        return _Scope(self.known, self.findings, around, name).units(node.units)

    def _whole(self, unit: ast.Unit) -> ast.Unit:
        scope = self
        if isinstance(unit, ast.Block | ast.Interface) and unit.usings:
            scope = self.within(None, unit.usings)
        written: ast.Unit = _Writer(scope).rewrite(unit)
        if isinstance(written, Named):
            name = joined(self.namespace, written.name.name)
            return replaced(written, name=replaced(written.name, name=name))
        return written

    def within(self, namespace: str | None, usings: Sequence[ast.Using]) -> "_Scope":
        """The scope with one more level."""
        opened = [self._opened(one, name) for one in usings for name in one.names]
        level = Level(namespace, tuple(name for name in opened if name is not None))
        return _Scope(self.known, self.findings, (*self.around, level), self.namespace)

    def _opened(self, node: ast.Using, name: str) -> str | None:
        names = [joined(level.namespace, name) for level in self.around if level.namespace]
        for one in (*reversed(names), name):
            if (found := self.known.names.get(one.casefold())) is not None:
                return found
        known = [one for one in self.known.names.values() if one]
        self.findings.unknown(
            "FB4096",
            f"there is no namespace '{name}'",
            node.span,
            lambda: nearest(name, known) if known else "check the file that has it, too",
        )
        return None

    # --- looking up ---------------------------------------------------------------------------

    def find(self, name: str, span: Span) -> str | None:
        """The whole name of the unit that a name means; None if it means none."""
        for level in reversed(self.around):
            element = None
            if level.namespace is not None:
                element = self._element(joined(level.namespace, name))
            if element is None:
                element = self._one_of(level.opened, name, span)
            if element is not None:
                self._check_hidden(element, span)
                return element.name
        return None

    def _element(self, name: str) -> Element | None:
        return self.known.elements.get(name.casefold())

    def _one_of(self, opened: tuple[str, ...], name: str, span: Span) -> Element | None:
        found = [
            element
            for one in dict.fromkeys(opened)
            if (element := self._element(joined(one, name))) is not None
        ]
        seen = [one for one in found if not self._is_hidden(one)]
        if len(seen) > 1:
            self.findings.error(
                "FB4097",
                f"'{name}' is in several namespaces that are opened here",
                span,
                f"write {' or '.join(one.name for one in seen)}",
                tuple(Note(f"{one.name} is declared here", one.span) for one in seen),
            )
        return (*seen, *found)[0] if found else None

    def _is_hidden(self, element: Element) -> bool:
        return element.hidden_in is not None and not is_inside(self.namespace, element.hidden_in)

    def _check_hidden(self, element: Element, span: Span) -> None:
        if self._is_hidden(element):
            where = element.hidden_in or "the units without a namespace"
            self.findings.error(
                "FB4085",
                f"{element.name} is INTERNAL",
                span,
                f"only {where} can use it: take something PUBLIC, or remove INTERNAL",
                (Note("it is declared here", element.span),),
            )


def _with_comments(unit: ast.Unit, comments: ast.TriviaList) -> ast.Unit:
    if not comments:
        return unit
    if isinstance(unit, ast.Globals):
        section = replaced(unit.section, leading=(*comments, *unit.section.leading))
        return replaced(unit, section=section)
    if isinstance(unit, ast.LoneMember):
        return unit
    return replaced(unit, leading=(*comments, *unit.leading))


class _Writer(Rewriter):
    """Writes whole names into one unit."""

    def __init__(self, scope: _Scope) -> None:
        self._scope = scope
        self._own: frozenset[str] = frozenset()

    def _declared(self, block: ast.Block) -> frozenset[str]:
        """The names that mean something of the block, its bases included."""
        found: set[str] = set()
        seen: list[ast.Block] = []
        step: ast.Block | None = block
        while step is not None and step not in seen:
            seen.append(step)
            found |= {one.name.name.casefold() for one in step.members}
            found |= _names_in(step.sections)
            base = step.extends and self._scope.find(step.extends.name, step.extends.span)
            step = self._scope.known.blocks.get(base.casefold()) if base else None
        return frozenset(found)

    def _block(self, node: ast.Block) -> ast.Block:
        self._own = self._declared(node)
        written: ast.Block = self.inside(node)
        return replaced(written, usings=()) if written.usings else written

    def _member_with_variables(self, node: ast.Method | ast.Accessor) -> object:
        around, self._own = self._own, self._own | _names_in(node.sections)
        written = self.inside(node)
        self._own = around
        return written

    def _interface(self, node: ast.Interface) -> ast.Interface:
        written: ast.Interface = self.inside(node)
        return replaced(written, usings=()) if written.usings else written

    def _type(self, node: ast.NamedType) -> ast.NamedType:
        whole = self._scope.find(node.name, node.span)
        return node if whole is None else replaced(node, name=whole)

    def _literal(self, node: ast.Literal) -> ast.Literal:
        if node.kind is not ast.LiteralKind.ENUMERATOR:
            return node
        whole = self._scope.find(node.type_name, node.span)
        return node if whole is None else replaced(node, type_name=whole)

    def _call(self, node: ast.Call) -> ast.Call:
        callee = node.callee
        if isinstance(callee, ast.Name) and not self._is_own(callee):
            whole = self._scope.find(callee.name, callee.span)
            if whole is not None:
                node = replaced(node, callee=replaced(callee, name=whole))
        return self.inside(node)

    def _member(self, node: ast.Member) -> ast.Expression:
        steps: list[ast.Member] = [node]
        while isinstance(steps[0].base, ast.Member):
            steps.insert(0, steps[0].base)
        head = steps[0].base
        if not isinstance(head, ast.Name) or self._is_own(head):
            return self.inside(node)
        for length in range(len(steps), -1, -1):
            words = [head.name, *(one.name for one in steps[:length])]
            whole = self._scope.find(".".join(words), node.span)
            if whole is not None:
                last = steps[length - 1] if length else head
                result: ast.Expression = ast.Name(last.span, whole)
                for one in steps[length:]:
                    result = replaced(one, base=result)
                return result
        return self.inside(node)

    def _is_own(self, name: ast.Name) -> bool:
        return name.local or name.quoted or name.outer or name.name.casefold() in self._own

    rules: ClassVar[dict[type, Rule]] = {
        ast.Block: _block,
        ast.Method: _member_with_variables,
        ast.Accessor: _member_with_variables,
        ast.Interface: _interface,
        ast.NamedType: _type,
        ast.Literal: _literal,
        ast.Call: _call,
        ast.Member: _member,
    }


def _names_in(sections: Sequence[Any]) -> set[str]:
    return {
        declared.name.casefold()
        for section in sections
        for declaration in section.declarations
        for declared in declaration.names
    }
