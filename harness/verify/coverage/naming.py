"""What the files are called in reports for other tools, where each name may stand only once."""

from collections import Counter

from harness.verify.coverage.collecting import Coverage
from harness.verify.coverage.model import FileKey


def report_names(coverage: Coverage) -> dict[FileKey, str]:
    """A name for each file, with `/`.

    That is its own one if no other file has it. Files that were generated for several plants or
    dialects are told apart by folders, `one_drive/tia/TOS_Line.scl`; further texts of one plant and
    dialect get a number.
    """
    names: dict[FileKey, str] = {}
    used: set[str] = set()
    own = Counter(key.name for key in coverage.files)
    for key in sorted(coverage.files):
        plain = key.name.replace("\\", "/")
        plants = sorted(coverage.files[key].plants)
        folder = f"{plants[0]}/{key.dialect}/" if plants else ""
        name = plain if own[key.name] == 1 or not folder else folder + plain
        number = 1
        candidate = name
        while candidate in used:
            number += 1
            stem, dot, suffix = name.rpartition(".")
            candidate = f"{stem}-{number}{dot}{suffix}"
        used.add(candidate)
        names[key] = candidate
    return names
