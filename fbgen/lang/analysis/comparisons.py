"""Comparisons that say nothing, or not what they seem to.

Sources: TIA Portal help, "Relational expressions" (floating-point numbers should not be compared
for equality); the ranges are those of the types.
"""

from fbgen.lang.analysis.effects import same_value
from fbgen.lang.analysis.report import Report
from fbgen.lang.checked import Binary, Constant, Convert, Expression
from fbgen.lang.types import Elementary, Family

_COUNTED = (Family.SIGNED, Family.UNSIGNED, Family.BITS)
_TURNED = {"<": ">", ">": "<", "<=": ">=", ">=": "<=", "=": "=", "<>": "<>"}


def check_comparison(report: Report, node: Binary, copied: "CopiedTexts") -> None:
    """FB4230, FB4231, FB4232."""
    kind = node.left.type
    if not isinstance(kind, Elementary):
        return
    if kind.family is Family.REAL:
        if node.operator in ("=", "<>"):
            _real_equality(report, node, copied)
        return
    if same_value(node.left, node.right):
        always = "TRUE" if node.operator in ("=", "<=", ">=") else "FALSE"
        report.warning(
            "FB4232",
            f"both sides of {node.operator} are the same, so this is always {always}",
            node.span,
            "compare with something else, or remove the comparison",
        )
    elif kind.family in _COUNTED:
        _range(report, node)


class CopiedTexts:
    """Which values a block copies without a change: a later comparison finds exactly the copy."""

    __slots__ = ("pairs", "waiting")

    def __init__(self) -> None:
        self.pairs: set[tuple[str, str]] = set()
        self.waiting: list[Binary] = []

    def copy(self, target: str, value: str) -> None:
        """`target := value;` stands in the block."""
        self.pairs.add((target, value))

    def report(self, report: Report) -> None:
        """The comparisons of REALs that no copy explains."""
        for node in self.waiting:
            left, right = node.left.span.text, node.right.span.text
            if (left, right) in self.pairs or (right, left) in self.pairs:
                continue
            report.warning(
                "FB4230",
                f"{node.left.type.name} values are compared with {node.operator}",
                node.span,
                "calculated values are hardly ever exactly equal: use ABS(a - b) < limit",
            )


def _real_equality(report: Report, node: Binary, copied: CopiedTexts) -> None:
    """Exact comparisons with 0 and of a value with itself (is it a number?) are on purpose."""
    for side in (node.left, node.right):
        if isinstance(side, Constant) and side.value == 0:
            return
    if same_value(node.left, node.right):
        return
    copied.waiting.append(node)


def _range(report: Report, node: Binary) -> None:
    if isinstance(node.right, Constant):
        value, tested, operator = node.right.value, node.left, node.operator
    elif isinstance(node.left, Constant):
        value, tested, operator = node.left.value, node.right, _TURNED[node.operator]
    else:
        return
    if isinstance(tested, Constant) or not isinstance(value, int):
        return
    low, high = _range_of(tested)
    answer: bool | None = None
    if value < low:
        answer = operator in (">", ">=", "<>")
    elif value > high:
        answer = operator in ("<", "<=", "<>")
    elif value == low and operator in ("<", ">="):
        answer = operator == ">="
    elif value == high and operator in (">", "<="):
        answer = operator == "<="
    if answer is not None:
        report.warning(
            "FB4231",
            f"this is always {str(answer).upper()}: '{tested.span.text}' lies in {low}..{high}",
            node.span,
            "compare with a value inside of that range, or remove the comparison",
        )


def _range_of(expression: Expression) -> tuple[int, int]:
    """Smallest and largest value; a widening conversion does not widen the range."""
    kind = expression.type
    assert isinstance(kind, Elementary)
    low, high = kind.minimum, kind.maximum
    while isinstance(expression, Convert):
        expression = expression.operand
        kind = expression.type
        if not isinstance(kind, Elementary) or kind.family not in _COUNTED:
            break
        if kind.minimum < low or kind.maximum > high:
            break
        low, high = kind.minimum, kind.maximum
    return low, high
