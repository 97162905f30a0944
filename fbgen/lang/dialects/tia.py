"""TIA Portal SCL as external source: `.scl`, `.udt`, `.db` for S7-1200/1500 and S7-300/400.

Source: TIA Portal help, SCL language elements; layout as TIA Portal exports it.
"""

from fbgen.lang.dialects.dialect import Dialect, Feature
from fbgen.lang.dialects.words import COMMON, words

TIA = Dialect(
    name="tia",
    title="TIA Portal SCL",
    features=frozenset(
        {
            Feature.LOCAL_MARKS,
            Feature.QUOTED_NAMES,
            Feature.LINE_COMMENTS,
            Feature.REGIONS,
            Feature.SLICES,
            Feature.COMPOUND_ASSIGNMENTS,
            Feature.CHAINED_ASSIGNMENTS,
            Feature.ASSIGNMENT_ATTEMPTS,
            Feature.REFERENCES,
            Feature.GOTO,
            Feature.MARKED_ADDRESSES,
            Feature.PERIPHERAL,
            Feature.DB_ADDRESSES,
            Feature.VAR_CONSTANT,
            Feature.DATA_BLOCKS,
            Feature.ARRAY_BLOCKS,
            Feature.ORGANIZATION_BLOCKS,
            Feature.HEADERS,
            Feature.POWER_FIRST,
            Feature.DIV_OPERATOR,
        }
    ),
    advice={
        Feature.BIT_MEMBERS: "write the bit as a slice: .%X3",
        Feature.SHORT_CIRCUIT: "nest two IFs, or write AND or OR, which work out both sides",
        Feature.PLAIN_ADDRESSES: "write '%' in front of the address",
        Feature.BRACKETED_INDICES: "write the index in parentheses: %MW(i)",
        Feature.CONST_SECTIONS: "write VAR CONSTANT name : TYPE := value; END_VAR",
        Feature.LABEL_SECTIONS: "leave it out, labels need no declaration",
        Feature.SET_ASSIGNMENTS: "write IF condition THEN x := TRUE; END_IF;",
        Feature.JUMPS: "write GOTO",
        Feature.ENUMERATIONS: "declare an INT and constants: named value data types are not read",
        Feature.SUBRANGES: "declare the whole type, and LIMIT what is assigned to it",
        Feature.UNIONS: "lay an AT view over the variable",
        Feature.OBJECTS: "write a FUNCTION_BLOCK or a FUNCTION for each",
        Feature.CLASSES: "write a FUNCTION_BLOCK",
        Feature.OUTER_NAMES: "write the global name without the point",
        Feature.LONG_TEXTS: "write the end of the line as $R$L",
        Feature.EXCEPTIONS: "check for the fault beforehand",
        Feature.NAMESPACES: "put its name into the names: those of software units are not read",
        Feature.PROGRAMS: "write an ORGANIZATION_BLOCK or a FUNCTION",
        Feature.CONFIGURATIONS: "tasks are set in the device configuration of the project",
    },
    reserved=COMMON
    | words(
        "DATA_BLOCK END_DATA_BLOCK ORGANIZATION_BLOCK END_ORGANIZATION_BLOCK BEGIN REGION "
        "END_REGION GOTO DIV DB_SPECIFIC S5TIME DTL VARIANT ANY POINTER VOID EN ENO REF_TO"
    ),
    indent="   ",
    identifier_length=125,
)
