"""Instructions for serial lines that the harness carries out in a plant: all their parameters.

`AREA` is a variable of any type but BOOL, handed over as its bytes; `.` marks what is a static
variable of the instance, which the program can set (`inst.RETRIES := 1`).
Sources: TIA Portal Information System, "Freeport communication" (Send_P2P, Receive_P2P,
Receive_Reset, Port_Config, Send_Config, Receive_Config), "PtP data link CP 341" (P_SND_RK,
P_RCV_RK), "... CP 340" (P_SEND, P_RCV), "... CP 440" (SEND_440, RECV_440), "MODBUS (RTU)"
(Modbus_Comm_Load, Modbus_Master). Recalled: that MB_DB is one word; it ties the master to its port
and means nothing else.
"""

_DONE = "DONE => BOOL, ERROR => BOOL, STATUS => WORD"
_NEW = "NDR => BOOL, ERROR => BOOL, STATUS => WORD"
_PORT = "REQ BOOL, PORT UINT"
_BLOCK = "R BOOL, LADDR INT, DB_NO INT, DBB_NO INT"
_REMOTE = "R_CPU_NO INT, R_TYP CHAR, R_NO INT, R_OFFSET INT, R_CF_BYT INT, R_CF_BIT INT"
_LOCAL = "L_TYP => CHAR, L_NO => INT, L_OFFSET => INT, L_CF_BYT => INT, L_CF_BIT => INT, LEN => INT"

TIE = "MB_DB"
"""The static variable of a MODBUS master that the call of its load writes."""

POINT_TO_POINT: dict[str, str] = {
    "SEND_P2P": f"{_PORT}, BUFFER <> AREA, LENGTH UINT, {_DONE}",
    "RECEIVE_P2P": f"PORT UINT, BUFFER <> AREA, {_NEW}, LENGTH => UINT",
    "RECEIVE_RESET": f"{_PORT}, {_DONE}",
    "PORT_CONFIG": (
        f"{_PORT}, PROTOCOL UINT, BAUD UINT, PARITY UINT, DATABITS UINT, STOPBITS UINT,"
        " FLOWCTRL UINT, XONCHAR CHAR, XOFFCHAR CHAR, WAITIME UINT, MODE USINT, LINE_PRE USINT,"
        f" BRK_DET USINT, {_DONE}"
    ),
    "SEND_CONFIG": (
        f"{_PORT}, RTSONDLY UINT, RTSOFFDLY UINT, BREAK UINT, IDLELINE UINT, USR_END STRING,"
        f" APP_END STRING, {_DONE}"
    ),
    "RECEIVE_CONFIG": f"{_PORT}, RECEIVE_CONDITIONS <> AREA, {_DONE}",
    "P_SND_RK": f"SF CHAR, REQ BOOL, {_BLOCK}, LEN INT, {_REMOTE}, {_DONE}",
    "P_RCV_RK": f"EN_R BOOL, {_BLOCK}, {_NEW}, {_LOCAL}",
    **dict.fromkeys(("P_SEND", "SEND_440"), f"REQ BOOL, {_BLOCK}, LEN INT, {_DONE}"),
    **dict.fromkeys(("P_RCV", "RECV_440"), f"EN_R BOOL, {_BLOCK}, {_NEW}, LEN => INT"),
    **dict.fromkeys(
        ("MB_COMM_LOAD", "MODBUS_COMM_LOAD"),
        "REQ BOOL, PORT UINT, BAUD UDINT, PARITY UINT, FLOW_CTRL UINT, RTS_ON_DLY UINT,"
        f" RTS_OFF_DLY UINT, RESP_TO UINT, MB_DB <> AREA, {_DONE}, ICHAR_GAP . WORD,"
        " RETRIES . WORD, MODE . USINT, LINE_PRE . USINT, STOP_BITS . USINT",
    ),
    **dict.fromkeys(
        ("MB_MASTER", "MODBUS_MASTER"),
        "REQ BOOL, MB_ADDR UINT, MODE USINT, DATA_ADDR UDINT, DATA_LEN UINT, DATA_PTR <> AREA,"
        " DONE => BOOL, BUSY => BOOL, ERROR => BOOL, STATUS => WORD, MB_DB . WORD",
    ),
}
"""By upper-case name: inputs, in-outs, outputs, static variables."""
