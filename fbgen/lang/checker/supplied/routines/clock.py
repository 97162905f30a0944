"""The calendar clock, the system time, and what works on the running scan.

Sources: TIA Portal help, "RD_SYS_T", "WR_SYS_T", "RD_LOC_T", "WR_LOC_T", "TIME_TCK", "RUNTIME",
"RE_TRIGR", "STP", "GetErrorID"; STEP 7 system functions manual, SFC0, SFC1, SFC43, SFC46, SFC64.
"""

CLOCK = {
    "RD_SYS_T": "INT(OUT => DT|LDT|DTL)",
    "WR_SYS_T": "INT(IN DT|LDT|DTL)",
    "RD_LOC_T": "INT(OUT => DT|LDT|DTL)",
    "WR_LOC_T": "INT(LOCTIME DT|LDT|DTL, DST BOOL?)",
    "READ_CLK": "INT(CDT => DT)",
    "SET_CLK": "INT(PDT DT)",
    "TIME_TCK": "TIME()",
    "RUNTIME": "LREAL(MEM <> LREAL)",
    "RE_TRIGR": "()",
    "STP": "()",
    "GETERRORID": "WORD(ID => WORD?)",
    "GETERROR": "(ERROR => ERRORSTRUCT)",
}

CLOCK_ALIASES = {
    "SFC0": "SET_CLK",
    "SFC1": "READ_CLK",
    "SFC43": "RE_TRIGR",
    "SFC46": "STP",
    "SFC64": "TIME_TCK",
    "GET_ERR_ID": "GETERRORID",
    "GET_ERROR": "GETERROR",
}
