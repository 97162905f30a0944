"""Scaling of analog values, and DEMUX.

Sources: STEP 7 help, FC105 (SCALE) and FC106 (UNSCALE); TIA Portal help, "DEMUX".
"""

ANALOG = {
    "SCALE": "WORD(IN INT, HI_LIM REAL, LO_LIM REAL, BIPOLAR BOOL, OUT => REAL)",
    "UNSCALE": "WORD(IN REAL, HI_LIM REAL, LO_LIM REAL, BIPOLAR BOOL, OUT => INT)",
    "DEMUX": "(K ANY_INT, IN SAME, OUT# => SAME, OUTELSE => SAME?)",
}
