"""`fbgen explain`: the page of a diagnostic code, or where a generated line is from."""

import re
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from fbgen.cli.examples import examples
from fbgen.cli.layers import JsonOption
from fbgen.cli.output import result, result_json

if TYPE_CHECKING:
    from fbgen.emit.origin_map import ExplainedLine
    from fbgen.source import Origin

_LINE = re.compile(r"(.+):(\d{1,9})")


def register(program: typer.Typer) -> None:
    """Add the command to the program."""
    program.command(
        epilog=examples(
            "fbgen explain FB2006",
            "fbgen explain fb3001 | less",
            "fbgen explain out/TOS_Line.scl:96",
            "fbgen explain out/TOS_Line.scl:96 --json",
        )
    )(explain)


def explain(
    what: Annotated[
        str,
        typer.Argument(
            metavar="CODE|FILE:LINE",
            help="The code in the brackets of a message, or a line of a generated file.",
        ),
    ],
    as_json: JsonOption = False,
) -> None:
    """Explain a message by its code, with an example, or where a line of a generated block is from.

    A line has its line of the template and, for each value in it, the entry of the catalogue or the
    plant file with its manual and section.
    """
    place = _LINE.fullmatch(what)
    if place is not None:
        _explain_line(Path(place[1]), int(place[2]), as_json=as_json)
    elif as_json:
        raise typer.BadParameter("--json is for FILE:LINE")
    else:
        _explain_code(what)


def _explain_code(code: str) -> None:
    from fbgen.diagnostics import error
    from fbgen.nearest import nearest
    from fbgen.pages import pages

    wanted = code.strip().strip("[]").upper()
    page = pages().get(wanted)
    if page is None:
        advice = nearest(wanted, pages())
        if _is_file(code):
            advice = f"for a line of a file add its number: {code}:1"
        raise error("FB9003", f"there is no message with the code '{code}'", None, advice)
    result(page.read_text(encoding="utf-8").rstrip("\n"))


def _is_file(name: str) -> bool:
    try:
        return Path(name).is_file()
    except OSError:  # a name that is too long
        return False


def _explain_line(path: Path, line: int, *, as_json: bool) -> None:
    from fbgen.emit.origin_map import explain_line

    found = explain_line(path, line)
    if as_json:
        result_json(
            {
                "file": str(path),
                "line": line,
                "text": found.text,
                "own": found.own,
                "origins": [_as_json(origin) for origin in found.origins],
            }
        )
        return
    result(f"{path}:{line}\n    {found.text.strip()}".rstrip())
    if not found.own:
        result("This line says nothing by itself. The nearest one that does:")
    for text in _told(found):
        result(text)


def _told(found: "ExplainedLine") -> list[str]:
    lines: list[str] = []
    for origin in found.origins:
        lines.append("")
        if origin.is_template:
            lines.append(f"template   {origin.file}:{origin.line}")
            if text := _template_line(origin):
                lines.append(f"           {text}")
        else:
            lines += _entry(origin, "value      ")
            for item in origin.inputs:
                lines += _entry(item, "with       ")
    return lines


def _entry(origin: "Origin", label: str) -> list[str]:
    indent = " " * len(label)
    lines = [f"{label}{origin.what}", f"{indent}{origin.file}:{origin.line}"]
    return [*lines, f"{indent}{origin.source}"] if origin.source else lines


def _template_line(origin: "Origin") -> str:
    """The line in the template; empty where that is not at hand."""
    from fbgen.resources import shipped

    name = origin.file.removeprefix("templates/")
    path = Path(origin.file) if name == origin.file else shipped("templates") / name
    try:
        return path.read_text("utf-8").split("\n")[origin.line - 1].strip()
    except (OSError, UnicodeDecodeError, IndexError):
        return ""


def _as_json(origin: "Origin") -> dict[str, object]:
    data: dict[str, object] = {
        "what": origin.what,
        "file": origin.file,
        "line": origin.line,
        "source": origin.source,
    }
    if origin.inputs:
        data["inputs"] = [_as_json(item) for item in origin.inputs]
    return data
