"""What a folder of generated files holds, and what would become of it.

The folder keeps a list of what was generated (`fbgen-files.json`) with the hash of each file and
the blocks; `fbgen.kept_folder` tells from it which files are a person's.
"""

import json
import re
from collections.abc import Mapping
from pathlib import Path

from fbgen.dataclass import dataclass
from fbgen.emit.block_list import BlockChanges, GeneratedBlock, block_changes
from fbgen.emit.generated import GeneratedSet
from fbgen.kept_folder import (
    ContentChanges,
    compare_contents,
    damaged_list,
    hash_of,
    read_content,
)

FILE_LIST = "fbgen-files.json"
_SUFFIXES = "scl|udt|db|sdf|st|TcPOU|TcDUT|TcGVL|xml|csv|xlsx|md"
_FILE_NAME = re.compile(rf"[A-Za-z][A-Za-z0-9_]*\.({_SUFFIXES})")
"""What fbgen calls its files; a list that names anything else is not followed."""


@dataclass(frozen=True, slots=True)
class FolderChanges(ContentChanges):
    """What generating does to a folder, by the names of files and of blocks.

    `last_inputs` is the hash of what the folder was generated from, "" for a new one.
    """

    blocks: BlockChanges
    last_inputs: str


@dataclass(frozen=True, slots=True)
class _FileList:
    inputs: str = ""
    files: Mapping[str, str] | None = None
    blocks: tuple[GeneratedBlock, ...] = ()


def compare(generated: GeneratedSet, folder: Path) -> FolderChanges:
    """What writing this set into the folder would change.

    Raises DiagnosticError FB5021 where the folder cannot be read, FB5022 where its list cannot.
    """
    owned = {file.name for file in generated.files if file.is_owned}
    texts = {
        name: data
        for name, data in generated.contents.items()
        if name not in owned or read_content(folder / name) is None
    }
    last = _read_list(folder)
    known = {name: value for name, value in (last.files or {}).items() if name not in owned}
    found = compare_contents(texts, known, folder)
    changed = set(found.written)
    return FolderChanges(
        found.changes,
        tuple(name for name in generated.contents if name not in changed),
        found.kept,
        found.theirs,
        block_changes(last.blocks, generated.blocks),
        last.inputs,
    )


def file_list(generated: GeneratedSet) -> bytes:
    """The content of the list for this set."""
    owned = {file.name for file in generated.files if file.is_owned}
    contents = sorted(generated.contents.items())
    hashes = {name: hash_of(data) for name, data in contents if name not in owned}
    blocks = [block.as_json() for block in generated.blocks]
    content = {"inputs": generated.inputs_hash, "files": hashes, "blocks": blocks}
    return (json.dumps(content, indent=2) + "\n").encode("ascii")


def _read_list(folder: Path) -> _FileList:
    data = read_content(folder / FILE_LIST)
    if data is None:
        return _FileList()
    try:
        content = json.loads(data)
        files = {str(name): str(value) for name, value in content["files"].items()}
        blocks = tuple(GeneratedBlock(**item) for item in content.get("blocks", ()))
        inputs = str(content.get("inputs", ""))
    except (ValueError, LookupError, TypeError, AttributeError, RecursionError):
        raise damaged_list(folder / FILE_LIST) from None
    followed = {name: value for name, value in files.items() if _FILE_NAME.fullmatch(name)}
    return _FileList(inputs, followed, blocks)
