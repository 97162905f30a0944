"""The instructions of the S7 CPUs by category, and what becomes of a call of each.

The categories and their order are those of the instructions in TIA Portal; what only STEP 7 has
stands in those where it would be. Sources: TIA Portal help, "Instructions (S7-1200, S7-1500)" and
"(S7-300, S7-400)"; STEP 7, System and Standard Functions.
"""

from enum import Enum

from fbgen.lang.checker.calls.bit_gathering import BIT_MOVES
from fbgen.lang.checker.calls.standard_calls import is_standard_function
from fbgen.lang.checker.calls.timer_control import TIMER_CONTROLS
from fbgen.lang.checker.calls.unmodelled import hardware_block
from fbgen.lang.checker.operands.memory_access import memory_access_named
from fbgen.lang.checker.operands.variants import is_variant_name
from fbgen.lang.checker.supplied.refused_instructions import NOT_SUPPORTED, WRITTEN_OTHERWISE
from fbgen.lang.checker.supplied.routines import is_modelled, routine_named
from fbgen.lang.checker.supplied.routines.point_to_point import POINT_TO_POINT
from fbgen.lang.checker.supplied.standard_blocks import standard_block
from fbgen.lang.checker.supplied.system_instructions import instruction_named


class Treatment(Enum):
    """What becomes of a call."""

    RUNS = "runs"
    IN_A_PLANT = "runs in a plant"
    STUBBED = "stub"
    REFUSED = "refused"
    WRITTEN = "written otherwise"


_IN_A_PLANT = ("DPNRM_DG", "DPRD_DAT", "DPWR_DAT", *POINT_TO_POINT)

CATEGORIES: dict[str, tuple[str, ...]] = {
    "Bit logic": ("R_TRIG", "F_TRIG"),
    "Timers": (
        *("TP", "TON", "TOF", "TONR", "RESET_TIMER", "PRESET_TIMER"),
        *("S_PULSE", "S_PEXT", "S_ODT", "S_ODTS", "S_OFFDT"),
    ),
    "Counters": ("CTU", "CTD", "CTUD", "S_CU", "S_CD", "S_CUD"),
    "Mathematics": (
        *("ABS", "MIN", "MAX", "LIMIT", "SQR", "SQRT", "LN", "EXP", "LOG", "SIN", "COS", "TAN"),
        *("ASIN", "ACOS", "ATAN", "FRAC"),
    ),
    "Move": (
        *("MOVE_BLK", "MOVE_BLK_VARIANT", "UMOVE_BLK", "FILL_BLK", "UFILL_BLK", "Serialize"),
        *("Deserialize", "SCATTER", "SCATTER_BLK", "GATHER", "GATHER_BLK", "SWAP"),
        *("ReadFromArrayDB", "WriteToArrayDB", "ReadFromArrayDBL", "WriteToArrayDBL"),
        *("PEEK", "PEEK_BOOL", "POKE", "POKE_BOOL", "POKE_BLK"),
        *("READ_LITTLE", "WRITE_LITTLE", "READ_BIG", "WRITE_BIG"),
        *("VariantGet", "VariantPut", "CountOfElements", "LOWER_BOUND", "UPPER_BOUND"),
        *("BLKMOV", "UBLKMOV", "FILL", "ResolveSymbols", "MoveFromResolvedSymbol"),
        *("MoveToResolvedSymbol", "MoveResolvedSymbolsToBuffer", "MoveResolvedSymbolsFromBuffer"),
        "GetSymbolForReference",
    ),
    "Conversion": (
        *("CONVERT", "ROUND", "CEIL", "FLOOR", "TRUNC", "SCALE_X", "NORM_X", "REF", "TypeOf"),
        *("TypeOfElements", "TypeOfDB", "IS_ARRAY", "VARIANT_TO_DB_ANY", "DB_ANY_TO_VARIANT"),
        *("SCALE", "UNSCALE"),
    ),
    "Program control": (
        *("RE_TRIGR", "STP", "GET_ERROR", "GET_ERR_ID", "RUNTIME", "ENDIS_PW", "SHUT_DOWN"),
        *("INIT_RD", "WAIT"),
    ),
    "Word logic": (
        *("DECO", "ENCO", "SEL", "MUX", "DEMUX", "BITSUM", "SEG", "BCDCPL"),
        *("DRUM", "DCAT", "MCAT", "IMC", "SMC", "LEAD_LAG"),
    ),
    "Shift and rotate": ("SHL", "SHR", "ROL", "ROR"),
    "Date and time": (
        *("T_CONV", "T_ADD", "T_SUB", "T_DIFF", "T_COMBINE", "T_COMP", "RD_SYS_T", "WR_SYS_T"),
        *("RD_LOC_T", "WR_LOC_T", "TIME_TCK", "READ_CLK", "SET_CLK", "AD_DT_TM", "SB_DT_TM"),
        *("SB_DT_DT", "D_TOD_DT", "SET_TIMEZONE", "SNC_RTCB", "RTM", "SET_CLKS"),
    ),
    "Strings": (
        *("LEN", "MAX_LEN", "CONCAT", "LEFT", "RIGHT", "MID", "DELETE", "INSERT", "REPLACE"),
        *("FIND", "S_MOVE", "S_CONV", "S_COMP", "STRG_VAL", "VAL_STRG", "Strg_TO_Chars"),
        *("Chars_TO_Strg", "ATH", "HTA", "I_STRNG", "DI_STRNG", "R_STRNG", "STRNG_I", "STRNG_DI"),
        *("STRNG_R", "JOIN", "SPLIT", "GetSymbolName", "GetSymbolPath", "GetInstanceName"),
        *("GetInstancePath", "GetBlockName"),
    ),
    "Process image and distributed I/O": (
        *("DPRD_DAT", "DPWR_DAT", "UPDAT_PI", "UPDAT_PO", "SYNC_PI", "SYNC_PO", "RDREC", "WRREC"),
        *("GETIO", "SETIO", "GETIO_PART", "SETIO_PART", "RALRM", "SALRM", "D_ACT_DP", "RCVREC"),
        *("PRVREC", "DPSYC_FR", "DPNRM_DG", "DP_TOPOL", "DP_PRAL", "ASI_CTRL", "PN_IN", "PN_OUT"),
        *("PN_DP", "RD_REC", "WR_REC", "WR_PARM", "WR_DPARM", "PARM_MOD", "RD_DPAR", "RD_DPARA"),
        *("RD_DPARM", "PE_START_END", "PE_CMD", "PE_WOL", "PE_DS3_Write_ET200S"),
    ),
    "Interrupts": (
        *("ATTACH", "DETACH", "SET_CINT", "QRY_CINT", "SET_TINT", "SET_TINTL", "CAN_TINT"),
        *("ACT_TINT", "QRY_TINT", "SRT_DINT", "CAN_DINT", "QRY_DINT", "DIS_AIRT", "EN_AIRT"),
        *("DIS_IRT", "EN_IRT", "MSK_FLT", "DMSK_FLT", "READ_ERR", "REPL_VAL"),
    ),
    "Alarms": (
        *("Program_Alarm", "Get_AlarmState", "Get_AlarmResources", "Gen_UsrMsg", "GEN_DIAG"),
        *("ACK_FCT_WARN", "ALARM", "ALARM_8", "ALARM_8P", "NOTIFY", "NOTIFY_8P", "AR_SEND"),
        *("ALARM_S", "ALARM_SQ", "ALARM_SC", "ALARM_D", "ALARM_DQ", "WR_USMSG"),
    ),
    "Diagnostics": (
        *("RD_SINFO", "RT_INFO", "LED", "Get_IM_Data", "GET_NAME", "GetStationInfo"),
        *("DeviceStates", "ModuleStates", "GET_DIAG", "RDSYSST", "OB_RT", "C_DIAG"),
    ),
    "Pulses, recipes, files and data blocks": (
        *("CTRL_PWM", "CTRL_PTO", "CTRL_HSC", "RecipeExport", "RecipeImport", "DataLogCreate"),
        *("DataLogOpen", "DataLogTypedOpen", "DataLogWrite", "DataLogClear", "DataLogClose"),
        *("DataLogDelete", "DataLogNewFile", "FileReadC", "FileWriteC", "FileDelete"),
        *("CREATE_DB", "READ_DBL", "WRIT_DBL", "ATTR_DB", "DELETE_DB", "CREAT_DB", "DEL_DB"),
        *("TEST_DB", "CREA_DBL", "CREA_DB", "COMPRESS"),
    ),
    "Addresses": (
        *("GEO2LOG", "LOG2GEO", "LOG2MOD", "IO2MOD", "RD_ADDR", "GEO_LOG", "LOG_GEO", "RD_LGADR"),
        *("GADR_LGC", "LGC_GADR"),
    ),
    "Communication": (
        *("GET", "PUT", "USEND", "URCV", "BSEND", "BRCV", "PRINT", "START", "STOP", "RESUME"),
        *("STATUS", "USTATUS", "TCON", "TDISCON", "TSEND", "TRCV", "TUSEND", "TURCV", "TSEND_C"),
        *("TRCV_C", "TMAIL_C", "T_RESET", "T_DIAG", "T_CONFIG", "FTP_CMD", "MB_CLIENT"),
        *("MB_SERVER", "Modbus_Comm_Load", "Modbus_Master", "Modbus_Slave", "AG_SEND", "AG_RECV"),
        *("X_SEND", "X_RCV", "X_GET", "X_PUT", "X_ABORT", "I_GET", "I_PUT", "I_ABORT"),
        *("Port_Config", "Send_Config", "Receive_Config", "P3964_Config", "Send_P2P"),
        *("Receive_P2P", "Receive_Reset", "SEND_PTP", "RCV_PTP"),
        *("P_SND_RK", "P_RCV_RK", "P_SEND", "P_RCV", "SEND_440", "RECV_440"),
    ),
    "Technology": (
        *("PID_Compact", "PID_3Step", "PID_Temp", "CONT_C", "CONT_S", "PULSEGEN", "TCONT_CP"),
        *("TCONT_S", "Filter_PT1", "Filter_PT2", "Filter_DT1", "High_Speed_Counter"),
        *("SSI_Absolute_Encoder", "MC_Power", "MC_Reset", "MC_Home", "MC_Halt"),
        *("MC_MoveAbsolute", "MC_MoveRelative", "MC_MoveVelocity", "MC_MoveJog", "MC_GearIn"),
        *("MC_CommandTable", "MC_ChangeDynamic", "MC_WriteParam", "MC_ReadParam", "MC_Stop"),
    ),
}
"""As Siemens writes the names."""


def treatment_of(name: str) -> Treatment | None:
    """What becomes of a call; None for a name that nobody knows."""
    key = name.upper()
    if key in _IN_A_PLANT:
        return Treatment.IN_A_PLANT
    if _runs(key):
        return Treatment.RUNS
    if routine_named(key) is not None or hardware_block(key) is not None:
        return Treatment.STUBBED
    if key in NOT_SUPPORTED:
        return Treatment.REFUSED
    return Treatment.WRITTEN if key in WRITTEN_OTHERWISE else None


def _runs(key: str) -> bool:
    return (
        is_standard_function(key)
        or standard_block(key) is not None
        or instruction_named(key) is not None
        or memory_access_named(key) is not None
        or is_modelled(key)
        or is_variant_name(key)
        or key in TIMER_CONTROLS
        or key in BIT_MOVES
    )
