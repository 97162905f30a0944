"""The page of the Python interface, from what `harness` gives and its docstrings."""

import inspect
import re
from collections.abc import Iterator
from pathlib import Path

import harness
from harness.engine.loading import Clock
from harness.engine.variables import BlockInstance

TEXT = Path(__file__).parent / "texts" / "python.md"
FIRST = ("load_program", "LoadedProgram")
GIVEN = ("LoadedProgram", "Recorder", "Trace")
"""What other functions give and nobody makes."""
REACHED: tuple[type, ...] = (Clock, BlockInstance)
"""What is given, too, and has no name in `harness`: `program.clock`, and what `instance` gives."""


def python_page() -> str:
    """The page."""
    names = [*FIRST, *(name for name in harness.__all__ if name not in FIRST)]
    shown = [(name, getattr(harness, name)) for name in names]
    shown[2:2] = [(kind.__name__, kind) for kind in REACHED]
    sections = "\n\n".join(_section(name, item) for name, item in shown)
    return TEXT.read_text(encoding="utf-8").replace("@SECTIONS@", sections)


def _section(name: str, item: object) -> str:
    is_given = any(item is one for one in (*REACHED, *(getattr(harness, one) for one in GIVEN)))
    head = "" if is_given else f"```text\n{_signature(name, item)}\n```\n\n"
    rows = "".join(_members(item)) if isinstance(item, type) else ""
    table = f"\n\n| member | what |\n|---|---|\n{rows}" if rows else ""
    return f"## {name}\n\n{head}{_text(inspect.getdoc(item) or '')}{table}".rstrip()


def _signature(name: str, item: object) -> str:
    """As it would be written, one parameter a line where there are many."""
    assert callable(item)
    parameters = inspect.signature(item).parameters.values()
    shown = [_parameter(one) for one in parameters]
    for place, one in enumerate(parameters):
        if one.kind is inspect.Parameter.KEYWORD_ONLY:
            shown.insert(place, "*")
            break
    line = f"{name}({', '.join(shown)})"
    return line if len(line) <= 96 else f"{name}(\n    " + ",\n    ".join(shown) + ",\n)"


def _parameter(parameter: inspect.Parameter) -> str:
    default = parameter.default
    if default is inspect.Parameter.empty:
        return parameter.name
    simple = isinstance(default, str | int | float | bool) or default is None
    empty = "{}" if hasattr(default, "keys") else "()"
    return f"{parameter.name}={default!r}" if simple else f"{parameter.name}={empty}"


def _members(kind: type) -> Iterator[str]:
    for name, member in vars(kind).items():
        if name.startswith("_") or not (isinstance(member, property) or inspect.isfunction(member)):
            continue
        about = _text((inspect.getdoc(member) or "").partition("\n\n")[0]).replace("|", "\\|")
        shown = name if isinstance(member, property) else _call(name, member)
        yield f"| `{shown}` | {' '.join(about.split())} |\n"


def _call(name: str, function: object) -> str:
    assert callable(function)
    parameters = list(inspect.signature(function).parameters.values())[1:]
    prefix = {inspect.Parameter.VAR_KEYWORD: "**", inspect.Parameter.VAR_POSITIONAL: "*"}
    shown = [prefix.get(one.kind, "") + _parameter(one) for one in parameters]
    return f"{name}({', '.join(shown)})"


def _text(text: str) -> str:
    """Text of a docstring, in which * and < stand for themselves."""
    return re.sub(r"(?<!`)<(?!`)", "&lt;", text)
