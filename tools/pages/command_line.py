"""The page of the command line, from the commands, arguments and options that the program has."""

import inspect
import re
import types
from collections.abc import Callable, Iterator
from enum import Enum
from pathlib import Path
from typing import Annotated, Literal, Union, get_args, get_origin, get_type_hints

import typer
from typer.models import ArgumentInfo, OptionInfo

from fbgen.cli.program import program_for
from fbgen.dataclass import dataclass

_HEAD = """\
# The command line

All commands of `fbgen` with their arguments and options. This page is made from the program by
`make pages`; `fbgen COMMAND --help` prints the same.

What a command gives goes to standard output, everything else to standard error; colours and
progress are for terminals only. A command ends with

| status | when |
|---|---|
| 0 | done |
| 1 | findings, each a message with a code: see [all messages](diagnostics.md) |
| 2 | the command line is wrong |
| 70 | a defect of fbgen itself |
| 130 | after Ctrl-C |
| 141 | the reader of standard output went away, as in a pipe to `head` |

"""


@dataclass(frozen=True, slots=True)
class _Parameter:
    """An argument or an option: what typer was told, its type and its default."""

    name: str
    info: ArgumentInfo | OptionInfo
    kind: object
    default: object


@dataclass(frozen=True, slots=True)
class _Command:
    """A command with the function that does it."""

    name: str
    function: Callable[..., object]
    epilog: str

    @property
    def paragraphs(self) -> list[str]:
        """What its help says."""
        parts = re.split(r"\n\s*\n", inspect.getdoc(self.function) or "")
        return [" ".join(part.split()) for part in parts]

    @property
    def parameters(self) -> list[_Parameter]:
        """In the order of the help."""
        hints = get_type_hints(self.function, include_extras=True)
        found = []
        for name, parameter in inspect.signature(self.function).parameters.items():
            kind, default = hints[name], parameter.default
            while get_origin(kind) is Annotated:
                kind, info = get_args(kind)
                if not info.hidden:
                    found.append(_Parameter(name, info, kind, default))
        return found

    @property
    def examples(self) -> str:
        """Those of its help; what stands behind two spaces says what the line does."""
        lines = self.epilog.partition("Examples:\n")[2].splitlines()
        shown = [line[2:] for line in lines if line.startswith("  fbgen")]
        return "\n".join(re.sub(r"(\S)(  +)(?=\S)", r"\1\2# ", line) for line in shown)


def command_line_page() -> str:
    """The page."""
    commands = list(_commands(program_for([]), "fbgen"))
    index = "".join(
        f"| [`{one.name}`](#{one.name.replace(' ', '-')}) | {_cell(one.paragraphs[0])} |\n"
        for one in commands
    )
    sections = "".join(map(_section, commands))
    return f"{_HEAD}| command | what it does |\n|---|---|\n{index}\n{sections}".rstrip() + "\n"


def _commands(program: typer.Typer, path: str) -> Iterator[_Command]:
    for command in program.registered_commands:
        assert command.callback
        name = command.name or command.callback.__name__
        yield _Command(f"{path} {name}", command.callback, command.epilog or "")
    for group in program.registered_groups:
        assert group.typer_instance
        yield from _commands(group.typer_instance, f"{path} {group.name}")


def _section(command: _Command) -> str:
    arguments = [one for one in command.parameters if isinstance(one.info, ArgumentInfo)]
    options = [one for one in command.parameters if isinstance(one.info, OptionInfo)]
    usage = " ".join([command.name, *map(_in_usage, arguments), "[OPTIONS]" if options else ""])
    parts = [f"## {command.name}", "\n\n".join(map(_text, command.paragraphs))]
    parts.append(f"```text\n{usage.strip()}\n```")
    if rows := [f"| `{_name(one)}` | {_cell(one.info.help or '')} |" for one in arguments]:
        parts.append("| argument | meaning |\n|---|---|\n" + "\n".join(rows))
    if rows := [_option_row(one) for one in options]:
        head = "| option | meaning | default |\n|---|---|---|\n"
        parts.append(head + "\n".join(rows))
    if command.examples:
        parts.append(f"```sh\n{command.examples}\n```")
    return "\n\n".join(parts) + "\n\n"


def _in_usage(argument: _Parameter) -> str:
    name = _value(argument) + ("..." if _is_many(argument.kind) else "")
    return name if argument.default is inspect.Parameter.empty else f"[{name}]"


def _option_row(option: _Parameter) -> str:
    assert isinstance(option.info, OptionInfo)
    # Within Annotated the first name stands where a default would be otherwise.
    given = [
        one for one in (option.info.default, *(option.info.param_decls or ())) if one is not ...
    ]
    spelled = given or [f"--{option.name.replace('_', '-')}"]
    names = ", ".join(f"`{name}`" for name in spelled)
    is_flag = bool in (option.kind, *get_args(option.kind))
    takes = "" if is_flag else f" `{_name(option)}`"
    meaning = (option.info.help or "").rstrip(".")
    if _is_many(option.kind) and "several times" not in meaning:
        meaning += "; may be given several times"
    known = not is_flag and option.default not in (inspect.Parameter.empty, None, "")
    default = f"`{getattr(option.default, 'value', option.default)}`" if known else ""
    return f"| {names}{takes} | {_cell(meaning)} | {default} |"


def _name(parameter: _Parameter) -> str:
    """How it stands in a table."""
    return _value(parameter).replace("|", "\\|")


def _value(parameter: _Parameter) -> str:
    """How the value of an argument or an option is written."""
    return parameter.info.metavar or _kind(parameter.kind) or parameter.name.upper()


def _kind(kind: object) -> str:
    if get_origin(kind) in (Union, types.UnionType):
        return next(filter(None, map(_kind, get_args(kind))), "")
    if get_origin(kind) is Literal:
        return "|".join(map(str, get_args(kind)))
    if isinstance(kind, type) and issubclass(kind, Enum):
        return "|".join(str(one.value) for one in kind)
    return {int: "N", float: "X", Path: "FILE"}.get(kind, "") if isinstance(kind, type) else ""


def _is_many(kind: object) -> bool:
    return get_origin(kind) is list or any(get_origin(one) is list for one in get_args(kind))


def _text(text: str) -> str:
    """Options as code, so that Markdown leaves them alone."""
    return re.sub(r"(?<![\w`-])(--[a-z][a-z-]*)", r"`\1`", text)


def _cell(text: str) -> str:
    return _text(" ".join(text.split())).replace("|", "\\|").replace("*", "\\*")
