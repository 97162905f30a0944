"""A block for each instruction with several outputs; what it gives can be seen in its variables."""

from dataclasses import dataclass

from standard_function_cases import Kind

from fbgen.lang.types import (
    BOOL,
    DATE,
    DATE_AND_TIME,
    DINT,
    DWORD,
    INT,
    LDT,
    LREAL,
    LTIME_OF_DAY,
    REAL,
    S5TIME,
    TIME_OF_DAY,
    UINT,
    USINT,
    WORD,
    StringType,
)


@dataclass(frozen=True)
class RoutineCase:
    """The inputs of the block "Case", its other variables, and what it does."""

    inputs: dict[str, Kind]
    variables: str
    body: str

    @property
    def text(self) -> str:
        """The whole block."""
        inputs = "".join(f"  {name} : {kind.name};\n" for name, kind in self.inputs.items())
        return (
            f'FUNCTION_BLOCK "Case"\nVAR_INPUT\n{inputs}  unused : BOOL;\nEND_VAR\n'
            f"VAR\n{self.variables}\nEND_VAR\nBEGIN\n{self.body}\nEND_FUNCTION_BLOCK\n"
        )


_DAY = "YEAR => #year, MONTH => #month, DAY => #day"
_TIME = "HOUR => #hour, MINUTE => #minute, SECOND => #second, MILLISECOND => #ms"
_PARTS = "year : UINT; month : INT; day : SINT; hour, minute, second : USINT; ms : DINT;"
_TEXT = StringType(20)
_TIMER = """#value := {name}(T_NO := T5, S := #s, TV := #tv, R := #r, Q => #q, BI => #bi);"""
_COUNTER = (
    """#value := {name}(C_NO := C5, {edges}, S := #s, PV := #pv, R := #r, Q => #q, CV => #cv);"""
)
_TIMER_INPUTS: dict[str, Kind] = {"s": BOOL, "tv": S5TIME, "r": BOOL}
_COUNTER_INPUTS: dict[str, Kind] = {"cu": BOOL, "cd": BOOL, "s": BOOL, "pv": WORD, "r": BOOL}

ROUTINES: dict[str, RoutineCase] = {
    "SCALE": RoutineCase(
        {"raw": INT, "high": REAL, "low": REAL, "bipolar": BOOL},
        "status : WORD; value : REAL;",
        "#status := SCALE(IN := #raw, HI_LIM := #high, LO_LIM := #low, BIPOLAR := #bipolar,"
        " OUT => #value);",
    ),
    "UNSCALE": RoutineCase(
        {"value": REAL, "high": REAL, "low": REAL, "bipolar": BOOL},
        "status : WORD; raw : INT;",
        "#status := UNSCALE(IN := #value, HI_LIM := #high, LO_LIM := #low, BIPOLAR := #bipolar,"
        " OUT => #raw);",
    ),
    "DEMUX": RoutineCase(
        {"k": INT, "value": DINT},
        "a, b, other : DINT;",
        "DEMUX(K := #k, IN := #value, OUT0 => #a, OUT1 => #b);\n"
        "DEMUX(K := #k, IN := #value, OUT1 => #a, OUTELSE => #other);",
    ),
    "SPLIT": RoutineCase(
        {"d": DATE, "tod": TIME_OF_DAY, "ltod": LTIME_OF_DAY, "dt": DATE_AND_TIME, "ldt": LDT},
        f"{_PARTS} sum : DINT;",
        f"SPLIT_DATE(IN := #d, {_DAY});\n#sum := #sum * 3 + #year * 500 + #month * 40 + #day;\n"
        f"SPLIT_TOD(IN := #tod, {_TIME});\n#sum := #sum * 3 + #hour * 3600 + #minute * 60 + #ms;\n"
        f"SPLIT_LTOD(IN := #ltod, {_TIME});\n#sum := #sum * 3 + #second * 60 + #minute + #ms;\n"
        f"SPLIT_DT(IN := #dt, {_DAY}, {_TIME});\n#sum := #sum * 3 + #month * 31 + #day + #ms;\n"
        f"SPLIT_LDT(IN := #ldt, {_DAY}, {_TIME});",
    ),
    "STRG_VAL": RoutineCase(
        {"text": _TEXT, "format": USINT, "p": UINT},
        "i : INT; r : REAL; u : USINT; l : LREAL;",
        "STRG_VAL(IN := #text, FORMAT := USINT_TO_WORD(#format), P := #p, OUT => #i);\n"
        "STRG_VAL(IN := #text, FORMAT := 16#0, P := 1, OUT => #u);\n"
        "STRG_VAL(IN := #text, FORMAT := 16#2, P := 1, OUT => #l);\n"
        "STRG_VAL(IN := #text, FORMAT := 16#3, P := #p MOD 4, OUT => #r);",
    ),
    "VAL_STRG": RoutineCase(
        {
            "i": DINT,
            "r": REAL,
            "l": LREAL,
            "size": USINT,
            "prec": USINT,
            "format": USINT,
            "p": UINT,
        },
        "a, b, c : STRING[30]; w : WORD;",
        "#a := '0123456789abcdefghij'; #b := #a; #c := '';\n"
        "#w := USINT_TO_WORD(#format MOD 8); #prec := #prec MOD 8;\n"
        "VAL_STRG(IN := #i, SIZE := #size, PREC := #prec, FORMAT := #w, P := #p, OUT => #a);\n"
        "VAL_STRG(IN := #r, SIZE := 15, PREC := #prec, FORMAT := #w, P := 3, OUT => #b);\n"
        "VAL_STRG(IN := #l, SIZE := 25, PREC := #prec * 2, FORMAT := 6, P := 1, OUT => #c);",
    ),
    "CHARS": RoutineCase(
        {"text": _TEXT, "first": DINT, "count": USINT},
        "chars : ARRAY[1..8] OF CHAR; bytes : ARRAY[0..7] OF BYTE; n : UINT; back : STRING[10];",
        "Strg_TO_Chars(Strg := #text, pChars := #first, Cnt => #n, Chars := #chars);\n"
        "Strg_TO_Chars(Strg := #text, pChars := 2, Cnt => #n, Chars := #bytes);\n"
        "Chars_TO_Strg(Chars := #bytes, pChars := #first MOD 3, Cnt := USINT_TO_UINT(#count) MOD 6,"
        " Strg => #back);",
    ),
    "HEX": RoutineCase(
        {"text": _TEXT, "n": INT, "w": WORD},
        "status, word : WORD; data : ARRAY[0..4] OF BYTE; shown : STRING[6];",
        "#status := ATH(IN := #text, N := #n, OUT => #data);\n"
        "#status := ATH(IN := #text, N := #n MOD 7, OUT => #word);\n"
        "#status := HTA(IN := #w, N := 2, OUT => #shown);\n"
        "#status := #status OR HTA(IN := #data, N := INT_TO_UINT(ABS(#n) MOD 8), OUT => #shown);",
    ),
    "CLOCK": RoutineCase(
        {"set": BOOL, "stamp": LDT, "dt": DATE_AND_TIME},
        "now, local : LDT; clk : DATE_AND_TIME; ret : INT; tick : TIME; mem, run : LREAL;"
        " w : WORD; error : ErrorStruct;",
        "IF #set THEN #ret := WR_SYS_T(IN := #stamp); #ret := SET_CLK(PDT := #dt);\n"
        "ELSE #ret := WR_LOC_T(LOCTIME := #stamp, DST := FALSE); END_IF;\n"
        "#ret := RD_SYS_T(OUT => #now); #ret := RD_LOC_T(#local); #ret := READ_CLK(CDT => #clk);\n"
        "#tick := TIME_TCK(); #run := RUNTIME(#mem); RE_TRIGR(); #w := GetErrorID();\n"
        "GetError(#error);\n"
        "IF #now > LDT#2200-01-01-00:00:00 THEN STP(); END_IF;",
    ),
    "DIGITS": RoutineCase(
        {"w": WORD, "d": DWORD},
        "shown, complement : DWORD;",
        "SEG(IN := #w, OUT => #shown);\n#complement := BCDCPL(#d);",
    ),
    **{
        name: RoutineCase(
            _TIMER_INPUTS, "value : S5TIME; q : BOOL; bi : WORD;", _TIMER.format(name=name)
        )
        for name in ("S_PULSE", "S_PEXT", "S_ODT", "S_ODTS", "S_OFFDT")
    },
    **{
        name: RoutineCase(
            _COUNTER_INPUTS,
            "value, cv : WORD; q : BOOL;",
            _COUNTER.format(name=name, edges=edges),
        )
        for name, edges in (
            ("S_CU", "CU := #cu"),
            ("S_CD", "CD := #cd"),
            ("S_CUD", "CU := #cu, CD := #cd"),
        )
    },
}
