"""IEC 61131-3 Structured Text, read as the third edition has it and as CODESYS extends it.

What fbgen itself writes is the core of the second edition that MATIEC and OpenPLC take: the
lowering sees to it. Source: IEC 61131-3 second edition, annexes B and C, and third edition; CODESYS
help for `S=`, POINTER TO, UNION and JMP. The operators of IL and the qualifiers of SFC (LD, S, R, N
...) are words of those languages only, so names may be spelled like them; the words of the third
edition are reserved only where they begin something.
"""

from fbgen.lang.dialects.dialect import Dialect, Feature
from fbgen.lang.dialects.words import COMMON, words

IEC = Dialect(
    name="iec",
    title="IEC 61131-3 ST",
    features=frozenset(
        {
            Feature.PROGRAMS,
            Feature.CONFIGURATIONS,
            Feature.BIT_MEMBERS,
            Feature.SLICES,
            Feature.SHORT_CIRCUIT,
            Feature.SET_ASSIGNMENTS,
            Feature.CHAINED_ASSIGNMENTS,
            Feature.JUMPS,
            Feature.EXCEPTIONS,
            Feature.LONG_TEXTS,
            Feature.ENUMERATIONS,
            Feature.OUTER_NAMES,
            Feature.SUBRANGES,
            Feature.UNIONS,
            Feature.BARE_ENDS,
            Feature.BARE_ARRAYS,
            Feature.OBJECTS,
            Feature.CLASSES,
            Feature.NAMESPACES,
            Feature.REFERENCES,
            Feature.ASSIGNMENT_ATTEMPTS,
            Feature.MARKED_ADDRESSES,
            Feature.VAR_CONSTANT,
            Feature.EMPTY_ARGUMENTS,
        }
    ),
    advice={
        Feature.LOCAL_MARKS: "write the name without '#'",
        Feature.QUOTED_NAMES: "write the name without quotes",
        Feature.REGIONS: "write the title as a comment: (* ... *)",
        Feature.COMPOUND_ASSIGNMENTS: "write the variable again: x := x + 1;",
        Feature.PLAIN_ADDRESSES: "declare a variable AT the address: x AT %MW4 : WORD;",
        Feature.BRACKETED_INDICES: "declare an array AT the address and index that",
        Feature.CONST_SECTIONS: "write VAR CONSTANT name : TYPE := value; END_VAR",
        Feature.LABEL_SECTIONS: "use IF, CASE, loops with EXIT, or RETURN",
        Feature.GOTO: "use IF, CASE, loops with EXIT, or RETURN",
        Feature.PERIPHERAL: "declare a variable AT the address, without ':P'",
        Feature.DB_ADDRESSES: "declare a variable and use its name",
        Feature.DATA_BLOCKS: "declare a variable in VAR_GLOBAL",
        Feature.ORGANIZATION_BLOCKS: "write a PROGRAM and give it a TASK",
        Feature.HEADERS: "write a comment above the block",
        Feature.DIV_OPERATOR: "write '/', which cuts the fraction off for integers",
    },
    reserved=COMMON
    | words(
        "PROGRAM END_PROGRAM CONFIGURATION END_CONFIGURATION RESOURCE END_RESOURCE TASK ON WITH "
        "VAR_GLOBAL VAR_EXTERNAL VAR_ACCESS VAR_CONFIG ACTION END_ACTION STEP END_STEP "
        "INITIAL_STEP TRANSITION END_TRANSITION FROM EN ENO R_EDGE F_EDGE READ_WRITE READ_ONLY "
        "ANY ANY_BIT ANY_DATE ANY_DERIVED ANY_ELEMENTARY ANY_INT ANY_MAGNITUDE ANY_NUM ANY_REAL "
        "ANY_STRING"
    ),
    indent="    ",
    identifier_length=64,
)
