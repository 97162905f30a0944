"""The types of random PLC programs, and the declarations in front of their statements."""

SIGNED = ("SINT", "INT", "DINT", "LINT")
UNSIGNED = ("USINT", "UINT", "UDINT", "ULINT")
BITS = ("BYTE", "WORD", "DWORD", "LWORD")
REALS = ("REAL", "LREAL")
WIDTHS = {
    **dict(zip(SIGNED, (8, 16, 32, 64), strict=True)),
    **dict(zip(UNSIGNED, (8, 16, 32, 64), strict=True)),
    **dict(zip(BITS, (8, 16, 32, 64), strict=True)),
}
TYPES = ("BOOL", *SIGNED, *UNSIGNED, *BITS, *REALS, "TIME", "STRING")
SPELLED = {"STRING": "STRING[6]"}
ARRAY_TYPES = ("BOOL", "INT", "DWORD", "REAL")

_IEC_TYPES = (
    "TYPE typeMode : (off, slow := 5, fast); END_TYPE\n"
    "TYPE typeLevel : INT (0..100) := 20; END_TYPE\n"
)
_S7_VARIABLES = (
    "    toInt : REF_TO INT;\n    other : REF_TO INT;\n"
    '    toFrame : REF_TO "typeFrame";\n    short : ARRAY[-1..0] OF INT;\n'
)
_S7_FUNCTIONS = (
    'FUNCTION "Through" : Void\n'
    "VAR_IN_OUT one : INT; END_VAR\nVAR_INPUT also : REF_TO INT; value : INT; END_VAR\nBEGIN\n"
    "    #one := #value;\n    IF #also <> NULL THEN\n        #also^ := #also^ + #one;\n"
    "    END_IF;\n    #one := #one + 1;\nEND_FUNCTION\n"
    'FUNCTION "Put" : INT\n'
    "VAR_IN_OUT list : ARRAY[*] OF INT; END_VAR\nVAR_INPUT at : INT; value : INT; END_VAR\n"
    "VAR_TEMP i : DINT; END_VAR\nBEGIN\n    #list[#at] := #value;\n    #Put := 0;\n"
    "    FOR #i := LOWER_BOUND(ARR := #list, DIM := 1) TO UPPER_BOUND(ARR := #list, DIM := 1) DO\n"
    "        #Put := #Put + #list[#i];\n    END_FOR;\nEND_FUNCTION\n"
)
_BASE = """\
FUNCTION_BLOCK Base
VAR_OUTPUT sum : INT; END_VAR
VAR factor : INT := 3; END_VAR
METHOD PROTECTED Scaled : INT
VAR_INPUT amount : INT; END_VAR
    Scaled := amount * factor;
END_METHOD
METHOD Bump : INT
VAR_INPUT amount : INT; END_VAR
VAR_IN_OUT place : INT; END_VAR
    sum := sum + Scaled(amount := amount);
    place := place + sum;
    Bump := place - factor;
END_METHOD
END_FUNCTION_BLOCK
"""
_INNER_MEMBERS = """\
METHOD PROTECTED Scaled : INT
VAR_INPUT amount : INT; END_VAR
VAR_INST times : INT; END_VAR
    times := times + 1;
    Scaled := SUPER^.Scaled(amount := amount) + times;
END_METHOD
PROPERTY Total : INT
GET
    Total := sum;
END_GET
SET
    sum := Total;
    factor := factor + 1;
END_SET
END_PROPERTY
ACTION Reset:
    IF sum < 5 THEN
        RETURN;
    END_IF;
    sum := 0;
END_ACTION
"""
_OUTER_MEMBERS = """\
METHOD Touch : INT
VAR_INPUT amount : INT; END_VAR
VAR_IN_OUT place : INT; END_VAR
    statInt := statInt + amount;
    place := place + 1;
    j := j + 1;
    outBool := NOT outBool;
    instInner.Total := place;
    Touch := statInt;
END_METHOD
"""


def declarations(mark: str) -> str:
    """Types, the inner block, the function, and the interface of the outer block."""
    quote = '"' if mark else ""
    begin = "BEGIN\n" if mark else ""
    names = {kind: kind[0].upper() + kind[1:].lower() for kind in TYPES}

    def section(prefix: str) -> str:
        return "".join(
            f"    {prefix}{name} : {SPELLED.get(kind, kind)};\n" for kind, name in names.items()
        )

    lists = "".join(f"    list{names[kind]} : ARRAY[1..3] OF {kind};\n" for kind in ARRAY_TYPES)
    frame = f"{quote}typeFrame{quote}"
    structure = "STRUCT\n    intPart : INT := 3;\n    realPart : REAL;\nEND_STRUCT;\nEND_TYPE\n"
    return (
        (f"TYPE {frame}\n" if mark else f"TYPE {frame} :\n") + structure
        + ("" if mark else _BASE)
        + f"FUNCTION {quote}Twice{quote} : INT\n"
        "VAR_INPUT value : INT; END_VAR\nVAR_IN_OUT total : DINT; END_VAR\n" + begin
        + f"    {mark}total := {mark}total + {mark}value;\n    {mark}Twice := {mark}value * 2;\n"
        + ("    IF #value > 100 THEN ENO := FALSE; END_IF;\n" if mark else "")
        + "END_FUNCTION\n"
        + (_S7_FUNCTIONS if mark else _IEC_TYPES)
        + ('FUNCTION_BLOCK "Inner"\n' if mark else "FUNCTION_BLOCK Inner EXTENDS Base\n")
        + "VAR_INPUT value : INT; END_VAR\n"
        + ("VAR_OUTPUT sum : INT; END_VAR\n" if mark else "")
        + "VAR_IN_OUT place : INT; END_VAR\nVAR calls : UINT; END_VAR\n"
        + ("" if mark else _INNER_MEMBERS) + begin
        + f"    {mark}calls := {mark}calls + 1;\n    {mark}place := {mark}place + {mark}value;\n"
        f"    {mark}sum := {mark}sum + {mark}place;\n"
        + ("    ENO := #sum MOD 3 <> 0;\n" if mark else "")
        + "END_FUNCTION_BLOCK\n"
        f"FUNCTION_BLOCK {quote}Outer{quote}\n"
        f"VAR_INPUT\n{section('in')}END_VAR\nVAR_OUTPUT\n{section('out')}END_VAR\n"
        f"VAR\n{section('stat')}{lists}    frame : {frame};\n"
        f"    frames : ARRAY[1..2] OF {frame};\n"
        "    i : INT;\n    j : DINT;\n    k : USINT;\n    guard : INT;\n"
        "    instOn : TON;\n    instOff : TOF;\n    instPulse : TP;\n    instRise : R_TRIG;\n"
        f"    instFall : F_TRIG;\n    instCount : CTU;\n    instInner : {quote}Inner{quote};\n"
        + (_S7_VARIABLES if mark else "    statMode : typeMode;\n    statLevel : typeLevel;\n")
        + "END_VAR\n" + ("" if mark else _OUTER_MEMBERS) + begin + f"    {mark}guard := 0;\n"
        + ("    #toInt := REF(#statInt);\n    #toFrame := REF(#frame);\n" if mark else "")
    )  # fmt: skip
