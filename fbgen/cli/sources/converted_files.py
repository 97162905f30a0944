"""Where converted text goes: names of files, and the bytes in them."""

from collections import Counter
from collections.abc import Mapping, Sequence
from os.path import commonpath
from pathlib import Path

import typer

from fbgen.dataclass import dataclass
from fbgen.lang.ast import File
from fbgen.lang.containers import NewFile, new_files

_XML_SUFFIXES = {".xml": "plcopen"} | dict.fromkeys(
    (".tcpou", ".tcdut", ".tcgvl", ".tcio", ".tctto"), "twincat"
)
_STEM = "converted"


@dataclass(frozen=True, slots=True)
class Destination:
    """`target` is a dialect or `plcopen`; `output` a file, a folder or None: standard output."""

    target: str
    output: Path | None
    as_text: bool

    @property
    def dialect(self) -> str:
        """The dialect to convert to."""
        return "iec" if self.target == "plcopen" else self.target

    @property
    def is_folder(self) -> bool:
        """A folder that is there, or a name without suffix."""
        return self.output is not None and (self.output.is_dir() or not self.output.suffix)

    @property
    def container(self) -> str:
        """How the text is wrapped. Raises a usage error for a suffix that means another one."""
        suffix = "" if self.output is None or self.is_folder else self.output.suffix.lower()
        if suffix in _XML_SUFFIXES and _XML_SUFFIXES[suffix] != self.target:
            raise typer.BadParameter(f"{suffix} is for --to {_XML_SUFFIXES[suffix]}")
        if self.target == "plcopen":
            return "plcopen"
        if (
            self.target == "twincat"
            and not self.as_text
            and (self.is_folder or suffix in _XML_SUFFIXES)
        ):
            return "twincat"
        return "text"


def encoded_files(
    trees: Sequence[File], destination: Destination, inputs: int
) -> Mapping[Path, bytes]:
    """The content of each file to write; for standard output one whose name does not count.

    What several `inputs` become together is named like the folder that it goes to.
    Raises a usage error where one file was named and several come out, and DiagnosticError for
    what has no place in such files: FB3019, FB3056.
    """
    container, output = destination.container, destination.output
    if output is None:
        return {Path(new.name): new.data for new in new_files(trees, container, _STEM)}
    if not destination.is_folder:
        found = new_files(trees, container, output.stem)
        if len(found) != 1 or (container == "twincat" and not _is_suffix_of(found[0], output)):
            names = ", ".join(new.name for new in found)
            raise typer.BadParameter(f"this becomes {names}: name a folder")
        return {output: found[0].data}
    stems = _stems([tree.source.name for tree in trees])
    if container != "text" or len(trees) == 1:
        stem = stems[0] if inputs == 1 else output.resolve().name
        return {output / new.name: new.data for new in new_files(trees, container, stem)}
    return {
        (output / stem).parent / new.name: new.data
        for stem, tree in zip(stems, trees, strict=True)
        for new in new_files([tree], container, Path(stem).name)
    }


def _is_suffix_of(new: NewFile, output: Path) -> bool:
    return Path(new.name).suffix.lower() == output.suffix.lower()


def _stems(names: Sequence[str]) -> list[str]:
    """The names of files without suffix, from the folder on that they share, each once."""
    paths = [Path(name).absolute() for name in names]
    shared = Path(commonpath([path.parent for path in paths])) if paths else Path()
    stems = [path.relative_to(shared).with_suffix("").as_posix() for path in paths]
    often = Counter(stem.casefold() for stem in stems)
    return [
        f"{stem}_{path.suffix.removeprefix('.')}" if often[stem.casefold()] > 1 else stem
        for stem, path in zip(stems, paths, strict=True)
    ]
