"""Classic S7-SCL of STEP 7 V5 for S7-300/400: `.scl`, `.gsd`-free sources with a symbol table.

Source: published S7-SCL sources; TIA Portal help, "Migrating SCL programs" and "Overview of the
valid data types" for what S7-300/400 lack. Absolute names of blocks (`FB4200`, `DB10`, `SFC14`)
are names like others; absolute addresses need no `%` and come with German or English mnemonics.
"""

import re

from fbgen.lang.dialects.dialect import Dialect, Feature
from fbgen.lang.dialects.words import COMMON, words

_ABSOLUTE = re.compile(
    r"(?:P?[IEQA]|M|D)[XBWD]?\d+|(?:DB|FB|FC|OB|SFB|SFC|UDT|T|C|Z)\d+", re.IGNORECASE
)


def is_absolute(name: str) -> bool:
    """Whether STEP 7 reads a name as an address or a block, where it stands without quotes."""
    return _ABSOLUTE.fullmatch(name) is not None


_WIDER = "use DINT or REAL; S7-300/400 calculate with 16 and 32 bits"
_UNSIGNED = "use INT or DINT; S7-300/400 have no unsigned integers"
_NARROW = "use INT or BYTE; S7-300/400 have no integers of 8 bits"
_BITS = "use two DWORDs"
_DATES = "use DATE_AND_TIME"

STEP7 = Dialect(
    name="step7",
    title="STEP 7 V5 SCL",
    features=frozenset(
        {
            Feature.LOCAL_MARKS,
            Feature.QUOTED_NAMES,
            Feature.LINE_COMMENTS,
            Feature.GOTO,
            Feature.PLAIN_ADDRESSES,
            Feature.DB_ADDRESSES,
            Feature.BRACKETED_INDICES,
            Feature.BARE_ARRAYS,
            Feature.CONST_SECTIONS,
            Feature.LABEL_SECTIONS,
            Feature.DATA_BLOCKS,
            Feature.ORGANIZATION_BLOCKS,
            Feature.HEADERS,
            Feature.POWER_FIRST,
            Feature.DIV_OPERATOR,
        }
    ),
    advice={
        Feature.REGIONS: "write the title as a comment: // title",
        Feature.SLICES: "lay an AT view over the variable, or shift and mask",
        Feature.BIT_MEMBERS: "lay an AT view over the variable, or shift and mask",
        Feature.COMPOUND_ASSIGNMENTS: "write the variable again: x := x + 1;",
        Feature.CHAINED_ASSIGNMENTS: "write one assignment a statement",
        Feature.ASSIGNMENT_ATTEMPTS: "hand the variable over with its own type",
        Feature.REFERENCES: "hand the variable over as VAR_IN_OUT",
        Feature.SHORT_CIRCUIT: "nest two IFs, or write AND or OR, which work out both sides",
        Feature.MARKED_ADDRESSES: "write the address without '%'",
        Feature.PERIPHERAL: "write the peripheral address: PIB256 or PEB256",
        Feature.VAR_CONSTANT: "write CONST name := value; END_CONST",
        Feature.SET_ASSIGNMENTS: "write IF condition THEN x := TRUE; END_IF;",
        Feature.JUMPS: "write GOTO",
        Feature.ENUMERATIONS: "declare an INT and named constants",
        Feature.SUBRANGES: "declare the whole type, and LIMIT what is assigned to it",
        Feature.UNIONS: "lay an AT view over the variable",
        Feature.OBJECTS: "write a FUNCTION_BLOCK or a FUNCTION for each",
        Feature.CLASSES: "write a FUNCTION_BLOCK",
        Feature.OUTER_NAMES: "write the global name without the point",
        Feature.LONG_TEXTS: "write the end of the line as $R$L",
        Feature.EXCEPTIONS: "check for the fault beforehand",
        Feature.NAMESPACES: "put the name of the namespace into the names themselves",
        Feature.ARRAY_BLOCKS: "write STRUCT THIS : ARRAY[...] OF ...; END_STRUCT;",
        Feature.PROGRAMS: "write an ORGANIZATION_BLOCK or a FUNCTION",
        Feature.CONFIGURATIONS: "tasks are set in the hardware configuration of the project",
    },
    reserved=COMMON
    | words(
        "DATA_BLOCK END_DATA_BLOCK ORGANIZATION_BLOCK END_ORGANIZATION_BLOCK BEGIN GOTO DIV "
        "CONST END_CONST LABEL END_LABEL S5TIME ANY POINTER VOID EN ENO OK NIL BLOCK_DB BLOCK_FB "
        "BLOCK_FC BLOCK_SDB TIMER COUNTER"
    ),
    indent="   ",
    identifier_length=24,
    absent_types={
        "SINT": _NARROW,
        "USINT": _UNSIGNED,
        "UINT": _UNSIGNED,
        "UDINT": _UNSIGNED,
        "LINT": _WIDER,
        "ULINT": _UNSIGNED,
        "LREAL": _WIDER,
        "LWORD": _BITS,
        "LTIME": "use TIME",
        "LTOD": "use TIME_OF_DAY",
        "LTIME_OF_DAY": "use TIME_OF_DAY",
        "LDT": _DATES,
        "DTL": _DATES,
        "WCHAR": "use CHAR",
        "WSTRING": "use STRING",
        "VARIANT": "use ANY",
    },
)
