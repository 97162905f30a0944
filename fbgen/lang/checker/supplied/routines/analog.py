"""Scaling of analog values, DEMUX, and patterns of digits.

Sources: STEP 7 help, FC105 (SCALE) and FC106 (UNSCALE), FC93 (SEG), FC89 (BCDCPL); TIA Portal help,
"DEMUX", "SEG", "BCDCPL".
"""

ANALOG = {
    "SCALE": "WORD(IN INT, HI_LIM REAL, LO_LIM REAL, BIPOLAR BOOL, OUT => REAL)",
    "UNSCALE": "WORD(IN REAL, HI_LIM REAL, LO_LIM REAL, BIPOLAR BOOL, OUT => INT)",
    "SEG": "(IN WORD, OUT => DWORD)",
    "BCDCPL": "DWORD(IN DWORD)",
    "DEMUX": "(K ANY_INT, IN SAME, OUT# => SAME, OUTELSE => SAME?)",
}
