"""From template to parsed canonical SCL, with every piece knowing where it came from."""

from fbgen.blocks.plan import BlockPlan
from fbgen.blocks.specs import BlockSpec
from fbgen.blocks.texts import Texts
from fbgen.dataclass import dataclass
from fbgen.emit.environment import TemplateRenderer
from fbgen.emit.heading import with_head
from fbgen.lang import ast
from fbgen.lang.parser import parse
from fbgen.plant import with_prefix
from fbgen.source import Source

CANONICAL_DIALECT = "tia"
"""Templates are written in SCL as TIA Portal has it."""


@dataclass(frozen=True, slots=True)
class FilledUnit:
    """One unit of the plan as its template gives it: with marks and names with the usual prefix,
    and as the text that is read, in which names have the plant's."""

    spec: BlockSpec
    marked: str
    source: Source


@dataclass(frozen=True, slots=True)
class RenderedUnit:
    """One unit of the plan: its text with marks, names still with the usual prefix, and its tree,
    in which names have the plant's."""

    spec: BlockSpec
    marked: str
    file: ast.File


def fill_in(
    spec: BlockSpec, plan: BlockPlan, renderer: TemplateRenderer, heading: str, prefix: str
) -> FilledUnit:
    """The template of a unit, filled in; `heading` is the first line of its head.

    Raises DiagnosticError where the template is wrong.
    """
    context = dict(plan.context) | dict(spec.context)
    marked = renderer.render(spec.template, context)
    text = with_prefix(f"// {heading}\n{marked}", prefix)
    name = with_prefix(f"{spec.name}.{spec.kind}", prefix)
    return FilledUnit(spec, marked, renderer.table.source(name, text))


def read_unit(unit: FilledUnit, texts: Texts) -> RenderedUnit:
    """The unit in canonical SCL with a complete head.

    Raises DiagnosticError where it is no SCL; the places name the template lines.
    """
    file = parse(unit.source, CANONICAL_DIALECT)
    return RenderedUnit(unit.spec, unit.marked, with_head(file, texts))
