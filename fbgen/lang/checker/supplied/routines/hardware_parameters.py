"""The names of the parameters of functions that work on hardware, where they are known.

The functions take parameters of any name, because their tables here are not complete; a name that
is not in them is a warning. RET_VAL goes without saying.
Source: STEP 7 system functions manual and TIA Portal help, the tables of parameters.
"""

_INTERRUPT = "OB_NR STATUS"
_RECORD = "REQ IOID LADDR RECNUM RECORD BUSY"
_PART = "PART FLADDR"

HARDWARE_PARAMETERS: dict[str, frozenset[str]] = {
    name: frozenset(names.split())
    for name, names in {
        # the clock and the hours
        "SET_RTM": "NR PV",
        "CTRL_RTM": "NR S",
        "READ_RTM": "NR CQ CV",
        "RTM": "NR MODE PV CQ CV",
        "SET_CLKS": "MODE PDT CORR SUMMER ANN_1",
        "SNC_RTCB": "",
        "WAIT": "WT",
        # interrupts
        "RD_SINFO": "TOP_SI START_UP_SI",
        "SRT_DINT": "OB_NR DTIME SIGN",
        "CAN_DINT": "OB_NR",
        "QRY_DINT": _INTERRUPT,
        "SET_TINT": "OB_NR SDT PERIOD",
        "SET_TINTL": "OB_NR SDT LOCAL PERIOD ACTIVATE",
        "CAN_TINT": "OB_NR",
        "ACT_TINT": "OB_NR",
        "QRY_TINT": _INTERRUPT,
        "SET_CINT": "OB_NR CYCLE PHASE",
        "QRY_CINT": "OB_NR CYCLE PHASE STATUS",
        "ATTACH": "OB_NR EVENT ADD",
        "DETACH": "OB_NR EVENT",
        "DIS_IRT": "MODE OB_NR",
        "EN_IRT": "MODE OB_NR",
        "DIS_AIRT": "",
        "EN_AIRT": "",
        "REPL_VAL": "VAL",
        # diagnostics and addresses
        "RDSYSST": "REQ SZL_ID INDEX BUSY SZL_HEADER DR",
        "GET_DIAG": "MODE LADDR CNT_DIAG DIAG DETAIL DETAILS",
        "LED": "LADDR LED",
        "DEVICESTATES": "LADDR MODE STATE",
        "MODULESTATES": "LADDR MODE STATE",
        "GADR_LGC": "SUBNETID RACK SLOT SUBSLOT SUBADDR IOID LADDR",
        "LGC_GADR": "IOID LADDR AREA RACK SLOT SUBADDR",
        "RD_LGADR": "IOID LADDR PEADDR PECOUNT PAADDR PACOUNT",
        # distributed I/O, records, process image
        "D_ACT_DP": "REQ MODE LADDR BUSY",
        "DPSYC_FR": "REQ LADDR GROUP MODE BUSY",
        "WR_REC": _RECORD,
        "RD_REC": _RECORD,
        "WR_PARM": _RECORD,
        "WR_DPARM": "REQ IOID LADDR RECNUM BUSY",
        "PARM_MOD": "REQ IOID LADDR BUSY",
        "UPDAT_PI": _PART,
        "UPDAT_PO": _PART,
        "SYNC_PI": _PART,
        "SYNC_PO": _PART,
        # data blocks and communication
        "CREAT_DB": "LOW_LIMIT UP_LIMIT COUNT DB_NUMBER",
        "DEL_DB": "DB_NUMBER",
        "TEST_DB": "DB_NUMBER DB_LENGTH WRITE_PROT",
        "AG_SEND": "ACT ID LADDR SEND LEN DONE ERROR STATUS",
        "AG_RECV": "ID LADDR RECV NDR ERROR STATUS LEN",
    }.items()
}
"""By the upper-case name of the function."""
