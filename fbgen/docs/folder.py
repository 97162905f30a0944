"""A site in its folder: its own pages are written again, those that a person has changed are kept.

Each format has a list of its own, so that two of them can lie in one folder.
"""

import json
import re
from collections.abc import Mapping
from pathlib import Path

from fbgen.diagnostics import DiagnosticError
from fbgen.kept_folder import (
    ContentChanges,
    compare_contents,
    damaged_list,
    hash_of,
    not_writable,
    read_content,
)
from fbgen.writing import replace_file

_FILE_NAME = re.compile(r"[A-Za-z0-9_][A-Za-z0-9_.-]*\.(html|css|js|md|svg|pdf)")
"""What fbgen calls the files of a site; a list that names anything else is not followed."""


def list_name(kind: str) -> str:
    """The list of the files of one format."""
    return f"fbgen-docs-{kind}.json"


def write_site(
    contents: Mapping[str, bytes], folder: Path, kind: str, *, force: bool = False
) -> ContentChanges:
    """Write all files into the folder, which is made if need be, and say what was done.

    Raises DiagnosticError FB5020 for files that a person has changed (unless `force`), FB5021 where
    the folder cannot be written, FB5022 where its list cannot be read.
    """
    found = compare_contents(contents, _known(folder / list_name(kind)), folder)
    if found.theirs and not force:
        raise DiagnosticError(found.refusals(folder))
    try:
        folder.mkdir(parents=True, exist_ok=True)
        found.apply(folder)
        _replace_if_other(folder / list_name(kind), _listed(contents))
    except OSError as problem:
        raise not_writable(folder, problem) from None
    return found


def _listed(contents: Mapping[str, bytes]) -> bytes:
    files = {name: hash_of(data) for name, data in sorted(contents.items())}
    return (json.dumps({"files": files}, indent=2) + "\n").encode("ascii")


def _replace_if_other(path: Path, data: bytes) -> None:
    if read_content(path) != data:
        replace_file(path, data)


def _known(path: Path) -> dict[str, str]:
    data = read_content(path)
    if data is None:
        return {}
    try:
        files = {str(name): str(value) for name, value in json.loads(data)["files"].items()}
    except (ValueError, LookupError, TypeError, AttributeError, RecursionError):
        raise damaged_list(path) from None
    return {name: value for name, value in files.items() if _FILE_NAME.fullmatch(name)}
