"""Single statements that do nothing, or less than they seem to."""

from fbgen.lang.analysis.effects import same_value
from fbgen.lang.analysis.report import Report
from fbgen.lang.checked import Assignment, Binary, Statement
from fbgen.source import Span


def report_unreachable(report: Report, statement: Statement) -> None:
    """FB4210: no path comes to this statement; those behind it are not reported again."""
    report.warning(
        "FB4210",
        "nothing comes here: the statements before always leave",
        statement.span,
        "remove the statement, or the RETURN, EXIT, CONTINUE, GOTO or endless loop before it",
    )


def check_assignment(report: Report, node: Assignment) -> None:
    """FB4233."""
    if type(node.target) is type(node.value) and same_value(node.target, node.value):
        report.warning(
            "FB4233",
            f"'{node.target.span.text}' is assigned to itself",
            node.span,
            "assign another variable, or remove the statement",
        )


def report_division(report: Report, node: Binary) -> None:
    """FB4215: the fraction is lost before the quotient becomes a REAL."""
    report.warning(
        "FB4215",
        f"this divides {node.type.name} by {node.type.name} and cuts the fraction off before the"
        " result becomes a floating-point number",
        node.span,
        "convert an operand first: INT_TO_REAL(a) / b; or write the conversion of the quotient",
    )


def report_label(report: Report, span: Span) -> None:
    """FB4208."""
    report.warning(
        "FB4208", f"nothing jumps to label '{_name(span)}'", span, "remove the label, or jump to it"
    )


def _name(span: Span) -> str:
    return span.text.partition(":")[0].strip()
