"""Which files the arguments of a command name, and which of them make one program.

Files, folders (with all folders in them) and patterns such as `blocks/**/*.scl`. All files of one
dialect are one program; the suffix tells the dialect.
"""

from collections.abc import Iterable, Sequence
from pathlib import Path

import typer

from fbgen.dataclass import dataclass

_PATTERN = frozenset("*?[")


@dataclass(frozen=True, slots=True)
class ProgramFiles:
    """All files of one dialect: one program. `is_open`: nobody has said that it is this dialect."""

    dialect: str
    paths: tuple[Path, ...]
    is_open: bool = False


def expand(arguments: Iterable[Path]) -> list[Path]:
    """Every file once, in order; folders and patterns replaced by the PLC texts they stand for.

    Raises a usage error for a folder or pattern without any.
    """
    found: dict[Path, None] = {}
    for path in arguments:
        if path.is_dir():
            texts = [item for item in path.rglob("*") if _is_plc_text(item, path)]
            if not texts:
                raise typer.BadParameter(f"there is no file with PLC text in {path}")
            found.update(dict.fromkeys(sorted(texts)))
        elif not path.exists() and _PATTERN & set(str(path)):
            texts = _matches(path)
            if not texts:
                raise typer.BadParameter(f"no file is named like {path}")
            found.update(dict.fromkeys(sorted(texts)))
        else:
            found[path] = None
    return list(found)


def _is_plc_text(item: Path, folder: Path) -> bool:
    """A PLC text that lies in no hidden folder; an .xml may be anything, so it is looked into."""
    from fbgen.lang.containers import SUFFIXES

    hidden = any(part.startswith(".") for part in item.relative_to(folder).parts)
    suffix = item.suffix.lower()
    if suffix not in SUFFIXES or hidden or not item.is_file():
        return False
    return suffix != ".xml" or _is_plcopen(item)


def _is_plcopen(item: Path) -> bool:
    """A project of PLCopen XML says so at its beginning."""
    with item.open("rb") as file:
        return b"plcopen.org/xml/tc6" in file.read(2000)


def _matches(pattern: Path) -> list[Path]:
    fixed = Path(*(part for part in _until_pattern(pattern.parts)))
    rest = pattern.parts[len(fixed.parts) :] if fixed.parts else pattern.parts
    return [item for item in fixed.glob(str(Path(*rest))) if item.is_file()]


def _until_pattern(parts: Sequence[str]) -> Iterable[str]:
    for part in parts:
        if _PATTERN & set(part):
            return
        yield part


def programs_of(paths: Sequence[Path], dialect: str | None) -> list[ProgramFiles]:
    """The files by dialect: by their suffixes, or all of the one that is given.

    SCL of STEP 7 V5 has the suffix of TIA Portal's: where a text can only be the one, it is; what
    can be either goes with the others.
    """
    if dialect is not None:
        return [ProgramFiles(dialect, tuple(paths))]
    by_dialect: dict[str, list[Path]] = {}
    for path in paths:
        told = _told(path)
        if told is None and not path.exists():
            raise typer.BadParameter(f"there is no file or folder {path}")
        if told is None:
            raise typer.BadParameter(f"the name of {path} does not tell its dialect: add --dialect")
        by_dialect.setdefault(told, []).append(path)
    if {"iec", "twincat"} <= set(by_dialect):
        # One project: the .st beside a .TcPOU is of the same tool.
        joined = {*by_dialect.pop("iec"), *by_dialect["twincat"]}
        by_dialect["twincat"] = [path for path in paths if path in joined]
    classic, newer = _by_age(by_dialect.get("tia", ()))
    if classic:
        by_dialect["step7"] = classic
        by_dialect["tia"] = newer
    return [
        ProgramFiles(name, tuple(files), is_open=name == "iec")
        for name, files in by_dialect.items()
        if files
    ]


def _by_age(paths: Sequence[Path]) -> tuple[list[Path], list[Path]]:
    """Which of the SCL files are those of STEP 7 V5, and which those of TIA Portal."""
    from fbgen.lang.containers.age import Age, age_of

    ages = [age_of(path.read_bytes()) if path.is_file() else Age.EITHER for path in paths]
    either = Age.EITHER if Age.TIA not in ages else Age.CLASSIC
    if Age.CLASSIC not in ages:
        return [], list(paths)
    parts: tuple[list[Path], list[Path]] = ([], [])
    for path, age in zip(paths, ages, strict=True):
        parts[age not in (Age.CLASSIC, either)].append(path)
    return parts


def _told(path: Path) -> str | None:
    """The dialect of a file by its name and what is in it; None if nothing tells."""
    from fbgen.lang.containers import SUFFIXES, told_dialect

    if SUFFIXES.get(path.suffix.lower()) == "iec" and path.is_file():
        return told_dialect(path, path.read_bytes().decode("latin-1"))
    return SUFFIXES.get(path.suffix.lower())


def dialect_of(paths: Sequence[Path]) -> str:
    """The dialect that these files stand for; wrong usage if they do not tell one.

    Structured Text that only CODESYS and TwinCAT take, because of what they convert by themselves,
    is `twincat`.
    """
    from fbgen.cli.sources.checking import Settings, settled

    programs = programs_of(paths, None)
    if len(programs) == 1:
        return settled(programs[0], Settings()).dialect
    raise typer.BadParameter("the files are of several dialects: add --dialect")
