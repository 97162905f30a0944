"""What templates may do: Jinja's sandbox, and limits for what it leaves open.

Templates of a user are text from anywhere. Jinja's own sandbox keeps them away from Python's
insides; it does not keep them from running for years (loops in loops, `9 ** 9 ** 9`), from filling
the memory, or from calling methods of the catalogue's models, one of which reads files.
"""

from collections.abc import Iterable, Iterator, Sequence, Sized
from typing import Any

from jinja2 import nodes
from jinja2.exceptions import SecurityError
from jinja2.sandbox import ImmutableSandboxedEnvironment
from jinja2.visitor import NodeTransformer
from pydantic import BaseModel

LOOP_PASSES = 2_000_000
"""How many passes all loops of one template may begin together."""

LARGEST_TEXT = 4_000_000
"""How many characters a text, or elements a list, may come to by an operator."""

LARGEST_EXPONENT = 64
LARGEST_NUMBER = 2**64


class TemplateSandbox(ImmutableSandboxedEnvironment):
    """The sandbox with limits. Call `refill` before each template."""

    intercepted_binops = frozenset({"*", "**", "+", "%"})

    def __init__(self, **options: Any) -> None:
        super().__init__(**options)
        self._passes_left = LOOP_PASSES
        self._known_attributes: dict[tuple[type, str], bool] = {}
        self.globals["range"] = _range

    def refill(self) -> None:
        """A new template may use all passes again."""
        self._passes_left = LOOP_PASSES

    def is_safe_attribute(self, obj: Any, attr: str, value: Any) -> bool:
        """Of the catalogue's models only the fields: their methods are not made for templates."""
        kind = type(obj)
        known = self._known_attributes.get((kind, attr))
        if known is None:
            own = not issubclass(kind, BaseModel) or attr in kind.model_fields
            known = own and super().is_safe_attribute(obj, attr, value)
            self._known_attributes[kind, attr] = known
        return known

    def call_binop(self, context: Any, operator: str, left: Any, right: Any) -> Any:
        """An operator whose result could be too large for any use."""
        if _grows_too_large(operator, left, right):
            raise SecurityError(f"the result of {operator} is too large for a template")
        return super().call_binop(context, operator, left, right)

    def counted(self, items: Iterable[Any]) -> Iterator[Any]:
        """The elements of a loop, each of which uses up one pass."""
        for item in items:
            self._passes_left -= 1
            if self._passes_left < 0:
                raise SecurityError(f"the loops of the template take over {LOOP_PASSES} passes")
            yield item

    def _parse(self, source: str, name: str | None, filename: str | None) -> nodes.Template:
        tree = super()._parse(source, name, filename)
        limited = _Limits().visit(tree)
        assert isinstance(limited, nodes.Template)
        return limited

    def joined(self, *parts: Any) -> str:
        """What `~` gives."""
        texts = [str(part) for part in parts]
        if sum(len(text) for text in texts) > LARGEST_TEXT:
            raise SecurityError("the result of ~ is too large for a template")
        return "".join(texts)


class _Limits(NodeTransformer):
    """Leads loops and `~` through the sandbox."""

    def visit_For(self, loop: nodes.For) -> nodes.For:  # noqa: N802  # the visitor's own spelling
        self.generic_visit(loop)
        loop.iter = _call("counted", [loop.iter], loop.lineno)
        return loop

    def visit_Concat(self, node: nodes.Concat) -> nodes.Call:  # noqa: N802
        self.generic_visit(node)
        return _call("joined", node.nodes, node.lineno)


def _call(method: str, arguments: Sequence[nodes.Node], line: int) -> nodes.Call:
    callee = nodes.EnvironmentAttribute(method, lineno=line)
    return nodes.Call(callee, list(arguments), [], None, None, lineno=line)


def _range(*arguments: int) -> range:
    """Python's range, up to as many elements as loops may have passes."""
    found = range(*arguments)
    if len(found) > LOOP_PASSES:
        raise SecurityError(f"a range of {len(found)} elements is too large for a template")
    return found


def _grows_too_large(operator: str, left: Any, right: Any) -> bool:
    if operator == "**":
        return not (_is_small(left) and isinstance(right, int) and abs(right) <= LARGEST_EXPONENT)
    if operator == "*":
        sized, number = (right, left) if isinstance(left, int) else (left, right)
        if isinstance(sized, Sized) and isinstance(number, int):
            return len(sized) * number > LARGEST_TEXT
        return not (_is_small(left) and _is_small(right))
    if operator == "+" and isinstance(left, Sized) and isinstance(right, Sized):
        return len(left) + len(right) > LARGEST_TEXT
    return operator == "%" and isinstance(left, str)


def _is_small(number: Any) -> bool:
    return not isinstance(number, int) or abs(number) <= LARGEST_NUMBER
