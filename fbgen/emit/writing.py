"""Generated files to disk, without ever losing what a person wrote.

Where a file belongs to a person, nothing at all is written. Each file goes to a temporary name
first and is renamed, the list of files goes last, so an interrupted run loses nothing. What became
of blocks that were renamed or are gone is written down in the folder, newest last: it is work for
whoever has them in a project already.
"""

from pathlib import Path

from fbgen.diagnostics import DiagnosticError
from fbgen.emit.folder import FILE_LIST, FolderChanges, compare, file_list
from fbgen.emit.generated import GeneratedSet
from fbgen.emit.origin_map import ORIGIN_MAP, origin_map
from fbgen.kept_folder import not_writable, read_content
from fbgen.writing import replace_file

CHANGED_BLOCKS = "fbgen-changed-blocks.txt"
"""Which blocks were renamed or removed, each time that the folder was generated again."""

_CHANGED_BLOCKS_HEADING = """\
Blocks that were renamed or are not generated any more, each time this folder was generated again.
Newest last. In a project that has them: rename or delete them, and mend what calls them.
"""


def write_set(generated: GeneratedSet, folder: Path, *, force: bool = False) -> FolderChanges:
    """Write all files into the folder, which is made if need be, and say what was done.

    A file that is not generated any more is removed unless a person has changed it. Raises
    DiagnosticError FB5020 for files that a person has changed (unless `force`), FB5021 where the
    folder cannot be written, FB5022 where the list of generated files cannot be read.
    """
    found = compare(generated, folder)
    if found.theirs and not force:
        raise DiagnosticError(found.refusals(folder))
    try:
        folder.mkdir(parents=True, exist_ok=True)
        found.apply(folder)
        if found.blocks or found.kept:
            before = read_content(folder / CHANGED_BLOCKS) or _CHANGED_BLOCKS_HEADING.encode()
            entry = _entry(found, generated.inputs_hash).encode("ascii")
            replace_file(folder / CHANGED_BLOCKS, before + entry)
        if origins := origin_map(generated.files):
            _keep(folder / ORIGIN_MAP, origins)
        _keep(folder / FILE_LIST, file_list(generated))
    except OSError as problem:
        raise not_writable(folder, problem) from None
    return found


def _keep(path: Path, content: bytes) -> None:
    if read_content(path) != content:
        replace_file(path, content)


def _entry(found: FolderChanges, inputs: str) -> str:
    lines = [f"inputs {found.last_inputs} -> {inputs}"]
    lines += [f"   renamed  {old} -> {new}" for old, new in found.blocks.renamed]
    lines += [f"   removed  {name}" for name in found.blocks.removed]
    lines += [f"   kept     {name}, not generated any more, changed by hand" for name in found.kept]
    return "\n" + "\n".join(lines) + "\n"
