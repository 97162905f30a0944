"""From template to parsed canonical SCL, with every piece knowing where it came from."""

from fbgen.blocks.plan import BlockPlan, BlockSpec
from fbgen.emit.environment import TemplateRenderer
from fbgen.lang import ast
from fbgen.lang.parser import parse

CANONICAL_DIALECT = "tia"
"""Templates are written in SCL as TIA Portal has it."""


def render_unit(
    spec: BlockSpec, plan: BlockPlan, renderer: TemplateRenderer, heading: str
) -> ast.File:
    """One unit of the plan as a syntax tree of canonical SCL, below a comment with `heading`.

    Raises DiagnosticError where the template is wrong or what it gives is no SCL; the places name
    the template lines.
    """
    context = dict(plan.context) | dict(spec.context)
    marked = f"// {heading}\n{renderer.render(spec.template, context)}"
    return parse(renderer.table.source(f"{spec.name}.{spec.kind}", marked), CANONICAL_DIALECT)
