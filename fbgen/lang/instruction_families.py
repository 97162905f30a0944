"""What the S7 CPU families lack: instructions, and the blocks that come with the controller.

An instruction is listed only where its absence is certain: what is not listed is let through.
Sources: TIA Portal help, the families named in the titles of the instructions ("(S7-1200,
S7-1500)"); STEP 7 V5, "System and Standard Functions" for SFCs, SFBs and the IEC library.
"""

import re
from collections.abc import Mapping
from types import MappingProxyType

from fbgen.lang.families import Cpu

_MOVES = {
    "MOVE_BLK": "use BLKMOV (SFC20)",
    "UMOVE_BLK": "use UBLKMOV (SFC81)",
    "FILL_BLK": "use FILL (SFC21)",
    "UFILL_BLK": "use FILL (SFC21)",
}
_ACCESS = ("PEEK", "PEEK_BOOL", "PEEK_WORD", "PEEK_DWORD", "PEEK_LWORD")
_POKES = ("POKE", "POKE_BOOL", "POKE_BLK")
_LATER = {
    **_MOVES,
    **dict.fromkeys((*_ACCESS, *_POKES), "use indexed addresses: DB100.DW[i]"),
    **dict.fromkeys(("NORM_X", "SCALE_X"), "use SCALE and UNSCALE (FC105, FC106), or calculate"),
    **dict.fromkeys(("R_TRIG", "F_TRIG"), "keep the last value in a static variable"),
    "TONR": "add up the time yourself",
    **dict.fromkeys(("RESET_TIMER", "PRESET_TIMER"), "call the timer with IN := FALSE"),
    **dict.fromkeys(
        (
            *("MOVE_BLK_VARIANT", "VARIANTGET", "VARIANTPUT", "SERIALIZE", "DESERIALIZE"),
            *("COUNTOFELEMENTS", "LOWER_BOUND", "UPPER_BOUND", "TYPEOF", "TYPEOFELEMENTS"),
            *("IS_ARRAY", "READ_LITTLE", "WRITE_LITTLE", "READ_BIG", "WRITE_BIG"),
        ),
        "use ANY and BLKMOV (SFC20)",
    ),
    **dict.fromkeys(
        ("STRG_VAL", "VAL_STRG", "STRG_TO_CHARS", "CHARS_TO_STRG", "MAX_LEN", "S_MOVE"),
        "use the conversions of the IEC library, or the characters one by one",
    ),
    **dict.fromkeys(
        ("SCATTER", "SCATTER_BLK", "GATHER", "GATHER_BLK"), "overlay the word with an array of BOOL"
    ),
    "DEMUX": "use CASE",
    "FRAC": "subtract the whole part",
    "RUNTIME": "use TIME_TCK (SFC64)",
    **dict.fromkeys(("GETERROR", "GETERRORID", "GET_ERROR", "GET_ERR_ID"), "use OB121 and OB122"),
    **dict.fromkeys(
        ("IEC_TIMER", "TON_TIME", "TOF_TIME", "TP_TIME", "TONR_TIME"), "use TON, TOF or TP"
    ),
    **dict.fromkeys(("IEC_COUNTER", "CTU_INT", "CTD_INT", "CTUD_INT"), "use CTU, CTD or CTUD"),
}
_OF_CP_34X = {
    **dict.fromkeys(("P_SND_RK", "P_SEND", "SEND_440"), "use Send_P2P, with a CM PtP or CM 1241"),
    **dict.fromkeys(("P_RCV_RK", "P_RCV", "RECV_440"), "use Receive_P2P, with a CM PtP or CM 1241"),
}
"""They work on the modules CP 340, 341 and 440, which plug into an S7-300 or S7-400 alone."""
_NARROW = ("SINT", "DINT", "USINT", "UINT", "UDINT")
_LONG = ("LINT", "ULINT")
_COUNTERS = {
    **dict.fromkeys(
        (f"{name}_{kind}" for name in ("CTU", "CTD", "CTUD") for kind in _NARROW),
        "use CTU, CTD or CTUD",
    ),
    **dict.fromkeys(
        ("IEC_SCOUNTER", "IEC_DCOUNTER", "IEC_USCOUNTER", "IEC_UCOUNTER", "IEC_UDCOUNTER"),
        "use CTU, CTD or CTUD",
    ),
}
_ONLY_1500 = {
    **dict.fromkeys(
        (f"{name}_{kind}" for name in ("CTU", "CTD", "CTUD") for kind in _LONG),
        "use a counter of 32 bits: CTUD_DINT",
    ),
    **dict.fromkeys(("IEC_LCOUNTER", "IEC_ULCOUNTER"), "use a counter of 32 bits: IEC_DCOUNTER"),
    **dict.fromkeys(
        (*("TON_LTIME", "TOF_LTIME", "TP_LTIME", "TONR_LTIME"), "IEC_LTIMER"),
        "use a timer of TIME",
    ),
}
_TIMERS = ("S_PULSE", "S_PEXT", "S_ODT", "S_ODTS", "S_OFFDT")
_NOT_ON_1200 = {
    **_ONLY_1500,
    **dict.fromkeys(_TIMERS, "use an IEC timer: TON, TOF or TP"),
    **dict.fromkeys(("S_CU", "S_CD", "S_CUD"), "use an IEC counter: CTU, CTD or CTUD"),
    "BLKMOV": "use MOVE_BLK, or an assignment",
    "UBLKMOV": "use UMOVE_BLK",
    "FILL": "use FILL_BLK",
    "TIME_TCK": "use RD_SYS_T, or RUNTIME",
    **dict.fromkeys(("SCALE", "UNSCALE"), "use NORM_X and SCALE_X"),
}
_OF_STEP7 = {
    **_OF_CP_34X,
    "READ_CLK": "use RD_SYS_T",
    "SET_CLK": "use WR_SYS_T",
    **dict.fromkeys(("AD_DT_TM", "SB_DT_TM"), "use T_ADD or T_SUB"),
    "SB_DT_DT": "use T_DIFF",
    "D_TOD_DT": "use CONCAT_DATE_TOD",
    **dict.fromkeys(("I_STRNG", "DI_STRNG", "R_STRNG"), "use a conversion: INT_TO_STRING"),
    **dict.fromkeys(("STRNG_I", "STRNG_DI", "STRNG_R"), "use a conversion: STRING_TO_INT"),
    **dict.fromkeys(("S5TI_TIM", "TIM_S5TI"), "use a conversion: S5TIME_TO_TIME"),
    **dict.fromkeys(
        (
            f"{name}_{suffix}"
            for name in ("EQ", "NE", "GT", "GE", "LT", "LE")
            for suffix in ("DT", "STRNG")
        ),
        "use a comparison: a < b",
    ),
}

MISSING_INSTRUCTIONS: Mapping[Cpu, Mapping[str, str]] = MappingProxyType(
    {
        Cpu.S7_300: {**_LATER, **_COUNTERS, **_ONLY_1500},
        Cpu.S7_400: {**_LATER, **_COUNTERS, **_ONLY_1500},
        Cpu.S7_1200: {**_NOT_ON_1200, **_OF_STEP7},
        Cpu.S7_1500: _OF_STEP7,
    }
)
"""By upper-case name: what to use instead."""

_NUMBERED = re.compile(r"SF[CB][0-9]+")


def instead_of(name: str, cpu: Cpu) -> str | None:
    """What to use where the family lacks an instruction; None if it has it, or nobody knows."""
    key = name.upper()
    if not cpu.is_classic and _NUMBERED.fullmatch(key):
        return "use the instruction by its name; SFCs and SFBs are of S7-300/400"
    return MISSING_INSTRUCTIONS[cpu].get(key)
