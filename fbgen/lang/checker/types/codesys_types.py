"""The types that CODESYS and TwinCAT have without any library, and the commonest of Tc2_System.

They are written as the text of TYPEs, read when a program first names one; a pointer has 64 bits.
Sources: CODESYS help, "Data types", "ANY", "BIT", "__VARINFO", "XINT, UXINT, XWORD"; TwinCAT
3 help, "T_MaxString", "T_AmsNetId", "TIMESTRUCT", "__SYSTEM.ExceptionCode".
"""

from functools import cache

from fbgen.lang import ast
from fbgen.lang.parser import parse
from fbgen.lang.types import StructType, Type
from fbgen.source import Source

_DIALECTS = ("iec", "twincat")
_TYPE_CLASSES = (
    *("BOOL", "BIT", "BYTE", "WORD", "DWORD", "LWORD", "SINT", "INT", "DINT", "LINT", "USINT"),
    *(
        "UINT",
        "UDINT",
        "ULINT",
        "REAL",
        "LREAL",
        "STRING",
        "WSTRING",
        "TIME",
        "DATE",
        "DATEANDTIME",
    ),
    *("TIMEOFDAY", "POINTER", "REFERENCE", "SUBRANGE", "ENUM", "ARRAY", "PARAMS", "USERDEF"),
    *("NONE", "ANY", "ANYBIT", "ANYDATE", "ANYINT", "ANYNUM", "ANYREAL", "LAZY", "LTIME"),
    *("BITCONST", "INTERFACE"),
)
_EXCEPTIONS = """
    RTSEXCPT_UNKNOWN := 16#FFFF_FFFF, RTSEXCPT_NOEXCEPTION := 0, RTSEXCPT_WATCHDOG := 16#10,
    RTSEXCPT_HARDWAREWATCHDOG := 16#11, RTSEXCPT_IO_CONFIG_ERROR := 16#12,
    RTSEXCPT_PROGRAMCHECKSUM := 16#13, RTSEXCPT_FIELDBUS_ERROR := 16#14,
    RTSEXCPT_IOUPDATE_ERROR := 16#15, RTSEXCPT_CYCLE_TIME_EXCEED := 16#16,
    RTSEXCPT_ILLEGAL_INSTRUCTION := 16#50, RTSEXCPT_ACCESS_VIOLATION := 16#51,
    RTSEXCPT_PRIV_INSTRUCTION := 16#52, RTSEXCPT_IN_PAGE_ERROR := 16#53,
    RTSEXCPT_STACK_OVERFLOW := 16#54, RTSEXCPT_INVALID_DISPOSITION := 16#55,
    RTSEXCPT_INVALID_HANDLE := 16#56, RTSEXCPT_GUARD_PAGE := 16#57,
    RTSEXCPT_DOUBLE_FAULT := 16#58, RTSEXCPT_INVALID_OPCODE := 16#59,
    RTSEXCPT_MISALIGNMENT := 16#100, RTSEXCPT_ARRAYBOUNDS := 16#101,
    RTSEXCPT_DIVIDEBYZERO := 16#102, RTSEXCPT_OVERFLOW := 16#103,
    RTSEXCPT_NONCONTINUABLE := 16#104, RTSEXCPT_FPU_ERROR := 16#150,
    RTSEXCPT_FPU_DENORMALOPERAND := 16#151, RTSEXCPT_FPU_DIVIDEBYZERO := 16#152,
    RTSEXCPT_FPU_INEXACTRESULT := 16#153, RTSEXCPT_FPU_INVALIDOPERATION := 16#154,
    RTSEXCPT_FPU_OVERFLOW := 16#155, RTSEXCPT_FPU_STACK_CHECK := 16#156,
    RTSEXCPT_FPU_UNDERFLOW := 16#157
"""
_ANY = """STRUCT
    pValue : POINTER TO BYTE;
    diSize : DINT;
    TypeClass : __SYSTEM.TYPE_CLASS;
END_STRUCT"""
_ANY_NAMES = (
    *("ANY", "ANY_NUM", "ANY_INT", "ANY_REAL", "ANY_BIT", "ANY_DATE", "ANY_STRING"),
    *("ANY_ELEMENTARY", "ANY_MAGNITUDE"),
)
_TEXT = """
TYPE BIT : BOOL; END_TYPE
TYPE PVOID : POINTER TO BYTE; END_TYPE
TYPE XINT : LINT; END_TYPE
TYPE UXINT : ULINT; END_TYPE
TYPE XWORD : LWORD; END_TYPE
TYPE __XINT : LINT; END_TYPE
TYPE __UXINT : ULINT; END_TYPE
TYPE __XWORD : LWORD; END_TYPE
TYPE HRESULT : DINT; END_TYPE
TYPE T_MaxString : STRING[255]; END_TYPE
TYPE T_AmsNetId : STRING[23]; END_TYPE
TYPE T_AmsPort : UINT; END_TYPE
TYPE T_IPv4Addr : STRING[15]; END_TYPE
TYPE TIMESTRUCT : STRUCT
    wYear : WORD;
    wMonth : WORD;
    wDayOfWeek : WORD;
    wDay : WORD;
    wHour : WORD;
    wMinute : WORD;
    wSecond : WORD;
    wMilliseconds : WORD;
END_STRUCT
END_TYPE
"""
_SYSTEM_TEXT = f"""
TYPE TYPE_CLASS : ({", ".join(f"TYPE_{name}" for name in _TYPE_CLASSES)}); END_TYPE
TYPE ExceptionCode : ({_EXCEPTIONS}) UDINT; END_TYPE
TYPE VAR_INFO : STRUCT
    ByteAddress : DWORD;
    ByteOffset : DWORD;
    Area : DINT;
    BitNr : INT;
    BitSize : INT;
    BitAddress : UDINT;
    TypeClass : __SYSTEM.TYPE_CLASS;
    TypeName : STRING[79];
    NumElements : UDINT;
    BaseTypeClass : __SYSTEM.TYPE_CLASS;
    ElemBitSize : UDINT;
    MemoryArea : DWORD;
    Symbol : STRING[39];
    Comment : STRING[79];
END_STRUCT
END_TYPE
TYPE AnyType : {_ANY}
END_TYPE
"""
_SYSTEM = "__system."


def codesys_type(dialect: str, name: str) -> ast.TypeDeclaration | None:
    """The declaration of a type that is there without any file, whatever its case."""
    return _declarations().get(name.casefold()) if dialect in _DIALECTS else None


def is_any_value(kind: Type) -> bool:
    """True for ANY and its kin: what a parameter knows of a variable of any type."""
    return isinstance(kind, StructType) and kind.name.upper() in _ANY_NAMES


@cache
def _declarations() -> dict[str, ast.TypeDeclaration]:
    anything = "\n".join(f"TYPE {name} : {_ANY}\nEND_TYPE" for name in _ANY_NAMES)
    system = {_SYSTEM + key: one for key, one in _read(_SYSTEM_TEXT).items()}
    return _read(_TEXT + anything) | system


def _read(text: str) -> dict[str, ast.TypeDeclaration]:
    units = parse(Source("types of the controller", text), "twincat").units
    return {one.name.name.casefold(): one for one in units if isinstance(one, ast.TypeDeclaration)}
