"""From template to parsed canonical SCL, with every piece knowing where it came from."""

from fbgen.blocks.plan import BlockPlan
from fbgen.blocks.specs import BlockSpec
from fbgen.dataclass import dataclass
from fbgen.emit.environment import TemplateRenderer
from fbgen.emit.heading import with_head
from fbgen.lang import ast
from fbgen.lang.parser import parse
from fbgen.plant import with_prefix

CANONICAL_DIALECT = "tia"
"""Templates are written in SCL as TIA Portal has it."""


@dataclass(frozen=True, slots=True)
class RenderedUnit:
    """One unit of the plan: its text with marks, names still with the usual prefix, and its tree,
    in which names have the plant's."""

    spec: BlockSpec
    marked: str
    file: ast.File


def render_unit(
    spec: BlockSpec, plan: BlockPlan, renderer: TemplateRenderer, heading: str, prefix: str
) -> RenderedUnit:
    """One unit of the plan in canonical SCL; `heading` is the first line of its head.

    Raises DiagnosticError where the template is wrong or what it gives is no SCL; the places name
    the template lines.
    """
    context = dict(plan.context) | dict(spec.context)
    marked = renderer.render(spec.template, context)
    text = with_prefix(f"// {heading}\n{marked}", prefix)
    name = with_prefix(f"{spec.name}.{spec.kind}", prefix)
    file = parse(renderer.table.source(name, text), CANONICAL_DIALECT)
    return RenderedUnit(spec, marked, with_head(file, renderer.texts))
