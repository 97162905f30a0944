"""What can differ between dialects of the PLC language."""

from dataclasses import field
from enum import Enum

from fbgen.dataclass import dataclass


class Feature(Enum):
    """Something that only some dialects have; the value is how a person calls it."""

    __hash__ = object.__hash__  # members are single objects; Enum's own hash runs in Python

    LOCAL_MARKS = "'#' in front of local names"
    OUTER_NAMES = "'.' in front of global names"
    QUOTED_NAMES = "names in double quotes"
    LINE_COMMENTS = "'//' comments that are written (all dialects read them)"
    REGIONS = "REGION"
    SLICES = "slices such as .%X0"
    BIT_MEMBERS = "bit access such as w.3"
    COMPOUND_ASSIGNMENTS = "assignments with += -= *= /="
    SET_ASSIGNMENTS = "assignments with S= and R="
    JUMPS = "JMP"
    LONG_TEXTS = "texts over two lines"
    EXCEPTIONS = "__TRY with __CATCH"
    ENUMERATIONS = "enumerations"
    BASE_BEHIND = "the base type behind an enumeration"
    SUBRANGES = "subranges"
    UNIONS = "UNION"
    ROUND_LENGTHS = "lengths of strings in parentheses"
    BARE_ENDS = "END_IF and the like without ';'"
    OBJECTS = "METHOD, PROPERTY, ACTION, INTERFACE and EXTENDS"
    CLASSES = "CLASS"
    NAMESPACES = "namespaces"
    GOTO = "GOTO"
    CHAINED_ASSIGNMENTS = "assignments in assignments"
    ASSIGNMENT_ATTEMPTS = "assignment attempts with ?="
    REFERENCES = "references (REF_TO, POINTER TO and '^')"
    SHORT_CIRCUIT = "AND_THEN and OR_ELSE"
    MARKED_ADDRESSES = "absolute addresses with '%'"
    PLAIN_ADDRESSES = "absolute addresses without '%'"
    PERIPHERAL = "peripheral addresses with ':P'"
    DB_ADDRESSES = "absolute addresses in data blocks"
    BRACKETED_INDICES = "absolute addresses with an index in brackets"
    VAR_CONSTANT = "VAR CONSTANT"
    BARE_ARRAYS = "initial values of arrays without brackets"
    CONST_SECTIONS = "CONST sections"
    LABEL_SECTIONS = "LABEL sections"
    DATA_BLOCKS = "DATA_BLOCK"
    ARRAY_BLOCKS = "ARRAY data blocks"
    ORGANIZATION_BLOCKS = "ORGANIZATION_BLOCK"
    HEADERS = "block headers with TITLE, AUTHOR, FAMILY, NAME and VERSION"
    PROGRAMS = "PROGRAM"
    CONFIGURATIONS = "CONFIGURATION"
    POWER_FIRST = "** that binds tighter than a sign"
    DIV_OPERATOR = "the operator DIV"
    EMPTY_ARGUMENTS = "arguments without a value, and ',' behind the last one"


@dataclass(frozen=True, slots=True)
class Dialect:
    """One dialect. `advice` says, for a missing feature, what to write in its place.

    `reserved` are the upper-case words that cannot be plain names; `indent` is one level of the
    canonical layout; `identifier_length` is the longest name the tools take; `absent_types` has the
    elementary types that other dialects have and this one lacks, each with what to use instead.
    """

    name: str
    title: str
    features: frozenset[Feature]
    advice: dict[Feature, str]
    reserved: frozenset[str]
    indent: str
    identifier_length: int
    absent_types: dict[str, str] = field(default_factory=dict)

    def has(self, feature: Feature) -> bool:
        """Whether the dialect has it."""
        return feature in self.features
