"""Instructions that work on hardware which the harness does not model: their names.

They can be called, and a stub of the user says what they do (`program.stub`). The functions take
parameters of any name; for the function blocks the outputs are listed, so that `inst.DONE` can be
read, and again parameters of any name can be given.
Source: TIA Portal help, "Extended instructions" and "Communication"; STEP 7 system functions
manual for the numbers.
"""

_OPEN = "INT(...)"
_INTERRUPTS = (
    *("ATTACH", "DETACH", "EN_IRT", "DIS_IRT", "SRT_DINT", "CAN_DINT", "QRY_DINT"),
    *("SET_CINT", "QRY_CINT", "SET_TINT", "SET_TINTL", "CAN_TINT", "ACT_TINT", "QRY_TINT"),
    *("DIS_AIRT", "EN_AIRT", "RT_INFO", "RD_SINFO", "WAIT", "SET_TIMEZONE", "SNC_RTCB", "RTM"),
)
_DIAGNOSTICS = (
    *("GET_DIAG", "LED", "DEVICESTATES", "MODULESTATES", "GET_NAME", "GET_STATION_INFO"),
    *("GETSTATIONINFO", "GEN_USRMSG", "GEO2LOG", "LOG2GEO", "IO2MOD", "RD_ADDR", "RD_LGADR"),
    *("GEO_LOG", "LOG_GEO", "GADR_LGC", "LGC_GADR", "DP_TOPOL", "DPNRM_DG", "DPSYC_FR", "D_ACT_DP"),
    *("RDSYSST", "WR_USMSG", "DP_PRAL", "RD_OBINF", "SYNC_PI", "SYNC_PO", "UPDAT_PI"),
    *("UPDAT_PO", "WR_PARM", "WR_DPARM", "PARM_MOD", "WR_REC", "RD_REC", "RD_DPAR", "RD_DPARM"),
    *("CREATE_DB", "DELETE_DB", "ATTR_DB", "READ_DBL", "WRIT_DBL"),
    *("CREAT_DB", "DEL_DB", "TEST_DB", "READ_ERR", "MSK_FLT", "DMSK_FLT", "REPL_VAL", "COMPRESS"),
    *("GET_IM_DATA", "ALARM_S", "ALARM_SQ"),
    *("ALARM_SC", "I_GET", "I_PUT", "X_SEND", "X_RCV", "X_GET", "X_PUT", "X_ABORT", "I_ABORT"),
    *("AG_SEND", "AG_RECV", "AG_LSEND", "AG_LRECV", "PROTECT"),
)
HARDWARE_FUNCTIONS: dict[str, str] = dict.fromkeys((*_INTERRUPTS, *_DIAGNOSTICS), _OPEN)
"""By upper-case name."""

HARDWARE_ALIASES = {
    "SFC5": "GADR_LGC",
    "SFC6": "RD_SINFO",
    "SFC11": "DPSYC_FR",
    "SFC12": "D_ACT_DP",
    "SFC13": "DPNRM_DG",
    "SFC22": "CREAT_DB",
    "SFC23": "DEL_DB",
    "SFC24": "TEST_DB",
    "SFC26": "UPDAT_PI",
    "SFC27": "UPDAT_PO",
    "SFC28": "SET_TINT",
    "SFC29": "CAN_TINT",
    "SFC30": "ACT_TINT",
    "SFC31": "QRY_TINT",
    "SFC32": "SRT_DINT",
    "SFC33": "CAN_DINT",
    "SFC34": "QRY_DINT",
    "SFC36": "MSK_FLT",
    "SFC37": "DMSK_FLT",
    "SFC38": "READ_ERR",
    "SFC39": "DIS_IRT",
    "SFC40": "EN_IRT",
    "SFC41": "DIS_AIRT",
    "SFC42": "EN_AIRT",
    "SFC44": "REPL_VAL",
    "SFC47": "WAIT",
    "SFC49": "LGC_GADR",
    "SFC50": "RD_LGADR",
    "SFC51": "RDSYSST",
    "SFC52": "WR_USMSG",
    "SFC58": "WR_REC",
    "SFC59": "RD_REC",
    "SFC70": "GEO_LOG",
    "SFC71": "LOG_GEO",
}
_JOB = "DONE => BOOL, BUSY => BOOL, ERROR => BOOL, STATUS => WORD"
_RECEIVE = "NDR => BOOL, BUSY => BOOL, ERROR => BOOL, STATUS => WORD"
_RECORD = "BUSY => BOOL, ERROR => BOOL, STATUS => DWORD"
_MOTION = "BUSY => BOOL, COMMANDABORTED => BOOL, ERROR => BOOL, ERRORID => WORD, ERRORINFO => WORD"

HARDWARE_BLOCKS: dict[str, str] = {
    **dict.fromkeys(("TCON", "TDISCON", "TSEND", "TSEND_C", "TUSEND", "TMAIL_C"), _JOB),
    **dict.fromkeys(("TRCV", "TURCV"), f"{_RECEIVE}, RCVD_LEN => UDINT"),
    "TRCV_C": "DONE => BOOL, BUSY => BOOL, ERROR => BOOL, STATUS => WORD, RCVD_LEN => UDINT",
    "T_RESET": _JOB,
    "T_DIAG": _JOB,
    "T_CONFIG": f"{_JOB}, ERR_LOC => DWORD",
    "MB_CLIENT": _JOB,
    "MB_SERVER": "NDR => BOOL, DR => BOOL, ERROR => BOOL, STATUS => WORD",
    "MB_COMM_LOAD": "DONE => BOOL, ERROR => BOOL, STATUS => WORD",
    "MODBUS_COMM_LOAD": "DONE => BOOL, ERROR => BOOL, STATUS => WORD",
    "MB_MASTER": _JOB,
    "MODBUS_MASTER": _JOB,
    "MB_SLAVE": "NDR => BOOL, DR => BOOL, ERROR => BOOL, STATUS => WORD",
    "MODBUS_SLAVE": "NDR => BOOL, DR => BOOL, ERROR => BOOL, STATUS => WORD",
    "RDREC": f"VALID => BOOL, {_RECORD}, LEN => UINT",
    "WRREC": f"DONE => BOOL, {_RECORD}",
    "RALRM": "NEW => BOOL, STATUS => DWORD, ID => UINT, LEN => UINT",
    "DPV1_RALRM": "NEW => BOOL, STATUS => DWORD, ID => UINT, LEN => UINT",
    "GETIO": "STATUS => DWORD, LEN => INT",
    "SETIO": "STATUS => DWORD",
    "GETIO_PART": "STATUS => DWORD, ERROR => BOOL",
    "SETIO_PART": "STATUS => DWORD, ERROR => BOOL",
    "GET": "NDR => BOOL, ERROR => BOOL, STATUS => WORD",
    "PUT": "DONE => BOOL, ERROR => BOOL, STATUS => WORD",
    "USEND": "DONE => BOOL, ERROR => BOOL, STATUS => WORD",
    "URCV": "NDR => BOOL, ERROR => BOOL, STATUS => WORD",
    "BSEND": "DONE => BOOL, ERROR => BOOL, STATUS => WORD",
    "BRCV": "NDR => BOOL, ERROR => BOOL, STATUS => WORD",
    **dict.fromkeys(
        ("SEND_CONFIG", "PORT_CONFIG", "RCV_CONFIG", "RCV_RST", "P3964_CONFIG", "SGN_SET"),
        "DONE => BOOL, ERROR => BOOL, STATUS => WORD",
    ),
    **dict.fromkeys(
        ("SEND_P2P", "SEND_PTP", "P_SEND", "PORT_CFG", "SEND_CFG", "RCV_CFG"),
        "DONE => BOOL, ERROR => BOOL, STATUS => WORD",
    ),
    **dict.fromkeys(
        ("RECEIVE_P2P", "RCV_PTP", "RECEIVE_PTP", "P_RCV", "S_RCV", "S_SEND"),
        "NDR => BOOL, ERROR => BOOL, STATUS => WORD, LENGTH => UINT",
    ),
    "SGN_GET": (
        "NDR => BOOL, ERROR => BOOL, STATUS => WORD, DTR => BOOL, DSR => BOOL, RTS => BOOL,"
        " CTS => BOOL, DCD => BOOL, RING => BOOL"
    ),
    **dict.fromkeys(
        ("DATALOGCREATE", "DATALOGOPEN", "DATALOGWRITE", "DATALOGCLOSE", "DATALOGNEWFILE"), _JOB
    ),
    **dict.fromkeys(("FILEREADC", "FILEWRITEC", "FILEDELETE"), _JOB),
    "PROGRAM_ALARM": "ERROR => BOOL, STATUS => WORD",
    "GET_ALARMSTATE": "ALARMSTATE => BYTE, ERROR => BOOL, STATUS => WORD",
    **dict.fromkeys(("ALARM", "ALARM_8", "ALARM_8P", "NOTIFY"), "DONE => BOOL, ERROR => BOOL"),
    **dict.fromkeys(("CTRL_HSC", "CTRL_PWM", "CTRL_PTO", "CTRL_HSC_EXT"), _JOB),
    "HIGH_SPEED_COUNTER": "ERROR => BOOL, ERRORID => WORD",
    **dict.fromkeys(
        (
            *("MC_POWER", "MC_RESET", "MC_HOME", "MC_HALT", "MC_MOVEABSOLUTE", "MC_MOVERELATIVE"),
            *("MC_MOVEVELOCITY", "MC_MOVEJOG", "MC_CHANGEDYNAMIC", "MC_STOP", "MC_GEARIN"),
        ),
        f"STATUS => BOOL, DONE => BOOL, {_MOTION}",
    ),
    "PID_COMPACT": (
        "SCALEDINPUT => REAL, OUTPUT => REAL, OUTPUT_PER => INT, OUTPUT_PWM => BOOL,"
        " SETPOINTLIMIT_H => BOOL, SETPOINTLIMIT_L => BOOL, INPUTWARNING_H => BOOL,"
        " INPUTWARNING_L => BOOL, STATE => INT, ERROR => BOOL, ERRORBITS => DWORD"
    ),
}
"""Function blocks by upper-case name, with their outputs."""

BLOCK_ALIASES = {
    "SFB8": "USEND",
    "SFB9": "URCV",
    "SFB12": "BSEND",
    "SFB13": "BRCV",
    "SFB14": "GET",
    "SFB15": "PUT",
    "SFB52": "RDREC",
    "SFB53": "WRREC",
    "SFB54": "RALRM",
    "FB63": "TSEND",
    "FB64": "TRCV",
    "FB65": "TCON",
    "FB66": "TDISCON",
}
