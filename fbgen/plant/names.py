"""Names of a plant file that become names in the PLC program."""

import re
from collections.abc import Iterator

from fbgen.diagnostics import Diagnostic
from fbgen.lang.dialects import DIALECTS
from fbgen.lang.dialects.words import STANDARD_NAMES
from fbgen.plant.prefix import USUAL_PREFIX, reserved_beginnings
from fbgen.source import Span

LONGEST_NAME = 32
_SPELLED = {"ä": "ae", "ö": "oe", "ü": "ue", "ß": "ss", "Ä": "Ae", "Ö": "Oe", "Ü": "Ue"}
_NAME = re.compile(r"[A-Za-z][A-Za-z0-9]*(_[A-Za-z0-9]+)*")


def name_problems(name: str, span: Span | None, prefix: str = USUAL_PREFIX) -> Iterator[Diagnostic]:
    """FB2012 for a name that cannot stand in a PLC program of any dialect.

    All dialects count, so that a plant survives a change of its dialect. `prefix` is how generated
    names begin.
    """
    if not _NAME.fullmatch(name):
        message = f"'{name}' is no name for a PLC program"
        rule = "use letters, digits and single underscores, a letter first: " + _repaired(name)
        yield Diagnostic("FB2012", message, span, rule)
    elif len(name) > LONGEST_NAME:
        message = f"the name '{name}' has {len(name)} characters"
        yield Diagnostic("FB2012", message, span, f"at most {LONGEST_NAME} fit into block names")
    elif name.lower().startswith(reserved_beginnings(prefix)):
        message = f"the name '{name}' begins like those of the generated blocks"
        yield Diagnostic("FB2012", message, span, "choose another beginning")
    elif owners := [item.title for item in DIALECTS.values() if name.upper() in item.reserved]:
        message = f"'{name}' is a reserved word in {' and '.join(owners)}"
        yield Diagnostic("FB2012", message, span, f"choose another name, such as {name}_1")
    elif name.upper() in STANDARD_NAMES:
        message = f"'{name}' is the name of a standard function or block of IEC 61131-3"
        yield Diagnostic("FB2012", message, span, f"choose another name, such as {name}_1")


def _repaired(name: str) -> str:
    spelled = "".join(_SPELLED.get(letter, letter) for letter in name)
    plain = re.sub(r"[^A-Za-z0-9]+", "_", spelled).strip("_")
    return plain if re.match(r"[A-Za-z]", plain) else f"drive_{plain}".rstrip("_")
