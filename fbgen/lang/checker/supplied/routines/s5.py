"""The timers T and counters C of the controller (S7-300/400, and S7-1500 for old programs).

The value of a timer function is the time that is left, as S5TIME; BI gives it in binary without the
time base. Source: STEP 7 V5, S7-SCL manual, chapters "Counters" and "Timers".
"""

_TIMER = "S5TIME(T_NO TIMER, S BOOL?, TV S5TIME?, R BOOL?, Q => BOOL?, BI => WORD?)"
_OUT = "R BOOL?, PV WORD?, Q => BOOL?, CV => WORD?"

S5 = {
    "S_PULSE": _TIMER,
    "S_PEXT": _TIMER,
    "S_ODT": _TIMER,
    "S_ODTS": _TIMER,
    "S_OFFDT": _TIMER,
    "S_CU": f"WORD(C_NO COUNTER, CU BOOL?, S BOOL?, {_OUT})",
    "S_CD": f"WORD(C_NO COUNTER, CD BOOL?, S BOOL?, {_OUT})",
    "S_CUD": f"WORD(C_NO COUNTER, CU BOOL?, CD BOOL?, S BOOL?, {_OUT})",
}
