"""Whether a code block of a page is text of its language, also where it is a part of a file.

YAML is held against the models of all files and of their parts. Of a part nothing has to be there,
but what is there has a name and a value that the model knows.
"""

import ast
import json
import re
import tomllib
from collections.abc import Callable, Iterator
from functools import cache

import jsonschema
import yaml
from defusedxml import ElementTree
from jinja2 import Environment

from fbgen.cli.schemas import schema_texts
from fbgen.diagnostics import DiagnosticError, Severity
from fbgen.lang.checker import check_reporting
from fbgen.lang.parser import parse
from fbgen.source import Source

DIALECTS = {
    "scl": "tia", "st": "iec", "iecst": "iec", "step7": "step7", "twincat": "twincat",
}  # fmt: skip
"""The languages of PLC text and the dialects that they are read as."""
_WHOLE = re.compile(
    r"^ *(\{.*\}\s*)?(FUNCTION|FUNCTION_BLOCK|PROGRAM|ORGANIZATION_BLOCK|TYPE|DATA_BLOCK|VAR_GLOBAL"
    r"|CONFIGURATION|INTERFACE|NAMESPACE|CLASS)\b",
    re.MULTILINE,
)
_AROUND = (
    "{head}BEGIN\n{text}\nEND_FUNCTION_BLOCK\n",
    "{head}{text}\nEND_FUNCTION_BLOCK\n",
    "{head}{text}\nBEGIN\nEND_FUNCTION_BLOCK\n",
    "{head}VAR\n{text}\nEND_VAR\nBEGIN\nEND_FUNCTION_BLOCK\n",
    "{head}VAR\n{text}\nEND_VAR\nEND_FUNCTION_BLOCK\n",
)
"""What stands around statements, sections and declarations where a page shows them alone."""


_OTHER_FILES = ({"version", "equivalents"}, {"en", "de"})
"""Files without a model: reasons why mutants change nothing, and a text with its translation."""


class Loader(yaml.SafeLoader):
    """`on` is a word, as fbgen reads it."""


Loader.yaml_implicit_resolvers = {
    letter: [item for item in found if item[0] != "tag:yaml.org,2002:bool"]
    for letter, found in yaml.SafeLoader.yaml_implicit_resolvers.items()
}
Loader.add_implicit_resolver("tag:yaml.org,2002:bool", re.compile("true|false"), list("tf"))


def plc_problems(text: str, dialect: str) -> list[str]:
    """Errors of PLC text: of whole blocks all, of declarations and statements those of reading."""
    if _WHOLE.search(text):
        return _errors(text, dialect)
    head = 'FUNCTION_BLOCK "Part"\n' if dialect == "tia" else "FUNCTION_BLOCK Part\n"
    found = []
    for around in _AROUND:
        found = [*found, _reading_errors(around.format(head=head, text=text), dialect)]
    return min(found, key=len)


def _reading_errors(text: str, dialect: str) -> list[str]:
    try:
        parse(Source("page", text), dialect)
    except DiagnosticError as error:
        return [f"{one.code} {one.message}" for one in error.diagnostics]
    return []


def _errors(text: str, dialect: str) -> list[str]:
    if found := _reading_errors(text, dialect):
        return found
    _, findings = check_reporting([parse(Source("page", text), dialect)], dialect)
    return [f"{one.code} {one.message}" for one in findings if one.severity is Severity.ERROR]


@cache
def _parts() -> list[tuple[frozenset[str], dict[str, object]]]:
    """Keys and schema of each file and of each of its parts, without what has to be there."""
    found = []
    for text in schema_texts().values():
        whole = json.loads(text, object_hook=without_required)
        definitions = whole.pop("$defs", {})
        for part in (whole, *definitions.values()):
            if "properties" in part:
                found.append((frozenset(part["properties"]), {**part, "$defs": definitions}))
    return found


def without_required(schema: dict[str, object]) -> dict[str, object]:
    if isinstance(schema.get("required"), list):
        del schema["required"]
    return schema


def yaml_problems(text: str) -> list[str]:
    """What no model knows, of a file or of a part of one."""
    try:
        data = yaml.load(text, Loader)
    except yaml.YAMLError as error:
        return [str(error)]
    return list(_unknown(data))


def _unknown(data: object) -> Iterator[str]:
    if isinstance(data, list):
        for item in data:
            yield from _unknown(item)
    elif isinstance(data, dict) and set(data) not in _OTHER_FILES:
        candidates = [schema for keys, schema in _parts() if set(map(str, data)) <= keys]
        if not candidates:
            yield f"no file has all of these keys: {', '.join(map(str, data))}"
        elif not any(jsonschema.Draft202012Validator(one).is_valid(data) for one in candidates):
            errors = jsonschema.Draft202012Validator(candidates[0]).iter_errors(data)
            yield f"{', '.join(map(str, data))}: {next(errors).message}"


def _with(read: Callable[[str], object]) -> Callable[[str], list[str]]:
    def problems(text: str) -> list[str]:
        try:
            read(text)
        except Exception as error:  # each of these libraries has errors of its own
            return [str(error)]
        return []

    return problems


PROBLEMS: dict[str, Callable[[str], list[str]]] = {
    "yaml": yaml_problems,
    "python": _with(ast.parse),
    "json": _with(lambda text: [json.loads(line) for line in text.splitlines()]),
    "toml": _with(tomllib.loads),
    "xml": _with(ElementTree.fromstring),
    "jinja": _with(Environment(extensions=["jinja2.ext.do"]).parse),
}
"""What is wrong with a text, by its language; PLC text apart."""


def problems_of(language: str, text: str) -> list[str]:
    """What is wrong with a code block that is not run."""
    if language in DIALECTS:
        return plc_problems(text, DIALECTS[language])
    return PROBLEMS[language](text)
