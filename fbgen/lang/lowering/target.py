"""What the dialects that text is lowered to can say: the differences between them, as data.

Source: IEC 61131-3 second edition for `iec`, which is what MATIEC and OpenPLC take; Beckhoff
Information System and CODESYS help for `twincat`.
"""

from fbgen.dataclass import dataclass
from fbgen.lang.dialects import Dialect, dialect_named
from fbgen.lang.dialects.words import words

_SECOND_EDITION = words(
    "BOOL BYTE WORD DWORD LWORD SINT INT DINT LINT USINT UINT UDINT ULINT REAL LREAL TIME DATE "
    "TIME_OF_DAY TOD DATE_AND_TIME DT"
)


@dataclass(frozen=True, slots=True)
class Target:
    """One target.

    `elementary` are the types it has. `has_free_globals`: every block reaches global variables, and
    they need no CONFIGURATION; else only programs and function blocks do, through VAR_EXTERNAL.
    `has_writable_inputs`: a block may change its own inputs. `has_continue` and `has_jumps`: it
    knows CONTINUE and jumps to labels. `drops_results`: a function with a result may stand alone as
    a statement.
    """

    dialect: Dialect
    elementary: frozenset[str]
    has_free_globals: bool
    has_writable_inputs: bool
    has_continue: bool
    has_jumps: bool
    drops_results: bool


TARGETS = {
    "iec": Target(
        dialect_named("iec"),
        _SECOND_EDITION,
        has_free_globals=False,
        has_writable_inputs=False,
        has_continue=False,
        has_jumps=False,
        drops_results=False,
    ),
    "twincat": Target(
        dialect_named("twincat"),
        _SECOND_EDITION | words("LTIME"),
        has_free_globals=True,
        has_writable_inputs=True,
        has_continue=True,
        has_jumps=True,
        drops_results=True,
    ),
}
"""By the name of the dialect."""
