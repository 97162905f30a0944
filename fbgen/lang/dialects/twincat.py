"""Structured Text of TwinCAT 3 and CODESYS 3.5, with what these add to the standard.

Source: Beckhoff Information System, "TwinCAT 3 PLC", programming reference; CODESYS online help,
"Programming reference". CLASS, NAMESPACE and USING of the standard's third edition are unknown
there, namespaces are those of libraries. Tasks stand in files and exports of their own; as text
they are a CONFIGURATION, which the tools themselves do not read.
"""

from fbgen.lang.dialects.dialect import Dialect, Feature
from fbgen.lang.dialects.words import COMMON, words

TWINCAT = Dialect(
    name="twincat",
    title="TwinCAT 3 and CODESYS ST",
    features=frozenset(
        {
            Feature.PROGRAMS,
            Feature.LINE_COMMENTS,
            Feature.BIT_MEMBERS,
            Feature.SET_ASSIGNMENTS,
            Feature.JUMPS,
            Feature.EXCEPTIONS,
            Feature.LONG_TEXTS,
            Feature.ENUMERATIONS,
            Feature.OUTER_NAMES,
            Feature.BASE_BEHIND,
            Feature.SUBRANGES,
            Feature.UNIONS,
            Feature.ROUND_LENGTHS,
            Feature.BARE_ENDS,
            Feature.BARE_ARRAYS,
            Feature.REFERENCES,
            Feature.SHORT_CIRCUIT,
            Feature.CHAINED_ASSIGNMENTS,
            Feature.ASSIGNMENT_ATTEMPTS,
            Feature.MARKED_ADDRESSES,
            Feature.VAR_CONSTANT,
            Feature.EMPTY_ARGUMENTS,
            Feature.OBJECTS,
            Feature.CONFIGURATIONS,
        }
    ),
    advice={
        Feature.LOCAL_MARKS: "write the name without '#'",
        Feature.QUOTED_NAMES: "write the name without quotes",
        Feature.REGIONS: "write {region 'title'} and {endregion}",
        Feature.SLICES: "write a bit as w.3; shift and mask for wider parts, or use a UNION",
        Feature.COMPOUND_ASSIGNMENTS: "write the variable again: x := x + 1;",
        Feature.PLAIN_ADDRESSES: "declare a variable AT the address: x AT %MW4 : WORD;",
        Feature.BRACKETED_INDICES: "declare an array AT the address and index that",
        Feature.CONST_SECTIONS: "write VAR CONSTANT name : TYPE := value; END_VAR",
        Feature.LABEL_SECTIONS: "leave it out, labels need no declaration",
        Feature.CLASSES: "write a FUNCTION_BLOCK",
        Feature.NAMESPACES: "put the blocks into a library; its name is their namespace",
        Feature.GOTO: "write JMP",
        Feature.PERIPHERAL: "declare a variable AT the address, without ':P'",
        Feature.DB_ADDRESSES: "declare a variable and use its name",
        Feature.DATA_BLOCKS: "declare a variable in VAR_GLOBAL",
        Feature.ORGANIZATION_BLOCKS: "write a PROGRAM and call it from a task",
        Feature.HEADERS: "write a comment above the block",
        Feature.DIV_OPERATOR: "write '/', which cuts the fraction off for integers",
    },
    reserved=COMMON
    | words(
        "PROGRAM END_PROGRAM VAR_GLOBAL VAR_EXTERNAL VAR_STAT VAR_INST VAR_CONFIG ACTION "
        "END_ACTION METHOD END_METHOD PROPERTY END_PROPERTY INTERFACE END_INTERFACE EXTENDS "
        "IMPLEMENTS ABSTRACT FINAL PUBLIC PRIVATE PROTECTED INTERNAL POINTER REFERENCE REF_TO "
        "UNION END_UNION THIS SUPER PERSISTENT READ_ONLY READ_WRITE R_EDGE F_EDGE JMP ADR SIZEOF "
        "BITADR INDEXOF BIT PVOID UXINT XINT XWORD ANY ANY_BIT ANY_DATE ANY_INT ANY_NUM ANY_REAL "
        "ANY_STRING AND_THEN OR_ELSE"
    ),
    indent="    ",
    identifier_length=255,
)
