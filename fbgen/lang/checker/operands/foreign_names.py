"""What to say about a name that no file has: which library it is of, or how to add it.

The names are those that published projects use most, by the libraries that declare them. Sources:
TwinCAT 3 help, "TwinCAT 3 PLC libraries"; CODESYS help, "Libraries"; oscat.de, "Basic library".
"""

import re
from collections.abc import Iterable, Mapping
from functools import cache

from fbgen.nearest import near_names, nearest

_ADD = "check its file too, or declare it in a file of your own"

_NAMES = {
    "Tc2_MC2": "axis_ref|mc_\\w+|e_jogmode|e_superpositionmode|nctoplc_\\w+|plctonc_\\w+|"
    "st_axisstatus|homingmode|e_homingmode|_?tcmc_\\w+|e_positiontype",
    "Tc2_NcDrive": "fb_soe\\w+|fb_ncdrive\\w*",
    "Tc2_System": "t_amsnetid\\w*|t_amsport|t_ipv4addr|ads(read|write|rdwrt)\\w*|adslog\\w+|"
    "fb_(file|eof|createdir|removedir|iterate|simpleads|setled|cxsim|cxprofiler|basspower)\\w*|"
    "f_get\\w+taskindex|getcurtaskindex\\w*|f_(splitpathname|checkmemoryarea|getversiontcsystem|"
    "getmappin\\w*|getmappartner|bigtype|cmplibversion|scanamsnetids|createamsnetid|"
    "createipv4addr)|e_openpath|"
    "st_libversion|fopen\\w*|plctaskinfo\\w*|plcappinfo\\w*|plctasksysteminfo|systeminfotype|"
    "systemtaskinfotype|mem(cpy|set|cmp|move)|t_u?hugeinteger|testandset|setbit32|csetbit32",
    "Tc2_Utilities": "t_arg|t_fix16|f_(string|dint|lreal|int|real|bool|byte|word|dword|udint|"
    "uint|lint|ulint|sint|usint|long\\w*|bigtype|hugeint\\w*|wstring)|fb_(localsystemtime|"
    "formatstring2?|enum\\w+|getadaptersbyip\\w*|getlocalamsnetid|"
    "csvmem\\w+|memring\\w+|memstack\\w+|stringringbuffer|basicpid|writepersistentdata|"
    "translate\\w+|gettimezone\\w*|settimezone\\w*|fileringbuffer|amslogger|hashtable\\w*|"
    "linkedlist\\w*|reg(query|set)\\w*|scope\\w*|timezone\\w*|getroute\\w*|addroute\\w*|"
    "getdevice\\w*|dbgout\\w*|dbgoutputctrl|connectscopeserver)|"
    "nt_\\w+|rtc(_ex2?)?|timestruct|t_filetime\\w*|st_(timezone\\w*|amsrouterinfo\\w*)|"
    "systemtime_to_\\w+|filetime\\w*_to_\\w+|dt_to_(systemtime|filetime\\w*)|"
    "(dint|dword|byte|word|lword|lint|ulint|udint|lreal|dcf77)_to_(dec|hex|oct|bin|fmt)str|"
    "(dec|hex|bin)?str\\w*_to_(systemtime|dcf\\w*)|concat2|find2|insert2|replace2|delete2|"
    "f_(toucase|tolcase|ltrim|rtrim|getdayofweek|getdayofmonth\\w*|getdayofyear|yearisleapyear|"
    "formatargtostr|swapreal\\w*|createhashtablehnd|createlinkedlisthnd|checksum16|crc16\\w*|"
    "getmaxmonthdays|getmonthofdoy|getweekofthe\\w*)|plc_(start|stop|reset)|tc_(config|restart|"
    "stop|cpuusage|syslatency)|profiler|maxstring|e_(enum|timezone|routetransport)\\w*|"
    "guid_to_\\w+|guidsequalbyval|string_to_guid|regstring_to_guid",
    "Tc2_EtherCAT": "fb_ec\\w+|st_ec\\w+|e_ec\\w+|f_(get|set)?(actual)?dctime\\w*|dctime\\w*|"
    "ec\\w+_to_\\w+|f_convdc\\w*|t_dctime\\w*|tcecat\\w*",
    "Tc2_ModbusSrv": "fb_mb\\w+",
    "Tc2_SerialCom": "serialline\\w*|send(string|byte|data)\\d*|receive(string|byte|data)\\d*|"
    "comserialconfig|combuffer|el6in\\w+|el6out\\w+|clearcombuffer",
    "Tc2_TcpIp": "fb_socket\\w+|fb_client\\w*connection|fb_serverclientconnection|t_hsocket|"
    "t_hserver|st_sockaddr",
    "Tc2_ControllerToolbox": "fb_ctrl\\w+|st_ctrl\\w+|e_ctrl\\w+",
    "Tc2_IoFunctions": "iof_\\w+|fb_dp\\w+|st_dp\\w+",
    "Tc2_SUPS": "fb_s_ups\\w*|e_s_ups\\w*",
    "Tc2_Math": "modabs|modturns|lmod|frac",
    "Tc2_DataExchange": "fb_(write|read)ads\\w+",
    "Tc3_EventLogger": "fb_tc(message|alarm|event\\w*|eventlogger|sourceinfo|clear\\w*|"
    "listener\\w*)|i_tc(message|sourceinfo|event\\w*|alarm)|tceventseverity|tcevententry|"
    "tceventseverityfilter|fb_listenerbase2?|i_listener2?|i_tcargument\\w*|tceventargument\\w*|"
    "tceventconfirmationstate|tc_events",
    "Tc3_Module": "itc\\w+|tcbaseinterface\\w*|guid|iid_\\w+|objecthandle|otcid",
    "Tc3_JsonXml": "fb_json\\w+|fb_xmldom\\w+|sjson\\w+|sxml\\w+",
    "Tc3_IotBase": "fb_iot\\w+|st_iot\\w+",
    "Tc3_IPCDiag": "fb_ipcdiag\\w*|e_ipcdiag\\w*",
    "Tc3_DynamicMemory": "fb_(dynmem\\w*)|__tcdynmem\\w*",
    "Tc2_Drive": "fb_drive\\w+",
    "TcUnit": "fb_testsuite|assert(equals|true|false|arrayequals|array2dequals|array3dequals)"
    "\\w*|test_finished\\w*|tcunit|test_ordered",
    "Util": "blink|gen|hysteresis|limitalarm|pd|pid(_fixcycle)?|derivative|integral|"
    "statistics_\\w+|variance|charcurve|ramp_(int|real)|pack|unpack|extract|putbit|freq_measure|"
    "word_as_(string|bit)|byte_as_bit|dword_as_bit|bit_as_\\w+|bcd_to_\\w+|\\w+_to_bcd|gen_mode",
    "SysTime, SysTimeCore and SysTimeRtc": "systime\\w*|rts_systime\\w*",
    "SysFile, SysDir": "sysfile\\w*|sysdir\\w*",
    "SysMem": "sysmem\\w+",
    "SysTypes": "rts_i\\w*|rts_ui\\w*",
    "SysSocket": "syssock\\w*|sockaddress",
    "SysCom": "syscom\\w*",
    "CAA Types, CAA File, CAA Memory": "caa\\w*",
    "SM3_Basic": "axis_ref_(virtual_)?sm3|smc_\\w+|smc3_\\w+",
    "CmpApp and the other Cmp libraries": "cmp[a-z]\\w+|app(get|reset|start|stop)\\w+|"
    "iec_(task|bacnet)\\w*",
    "OSCAT Basic": "t_plc_(ms|us)|run_?time_plc|oscat_\\w+|esr_\\w+|calibrate|ft_\\w+|ctrl_p\\w*|"
    "dcf77|sdt|calendar|real2|constants_\\w+|complex|vector_3|timer_event|holiday_data|"
    "sun_(time|midday)|time_to_timestructure",
}
_LIBRARY = re.compile(
    r"tc[23]_\w+|standard|standard64|util|visu\w*|cmp\w+|sys[a-z]\w*|caa|sm3_\w+", re.IGNORECASE
)


def library_of(name: str) -> str | None:
    """The library that declares a name; None for a name that may be of anybody."""
    return next((key for key, one in _patterns().items() if one.fullmatch(name)), None)


@cache
def _patterns() -> Mapping[str, re.Pattern[str]]:
    """Only made for a program with names that nobody has declared."""
    flags = re.ASCII | re.IGNORECASE
    return {library: re.compile(pattern, flags) for library, pattern in _NAMES.items()}


def is_library(name: str) -> bool:
    """True for what can stand in front of a name to say which library it is of."""
    return _LIBRARY.fullmatch(name) is not None


def library_help(name: str, known: Iterable[str]) -> str:
    """How to mend an unknown name: a library, a slip of the pen, or a file that is missing."""
    library = library_of(name)
    if library is not None:
        return f"it comes from the library {library}: {_ADD}"
    if _LIBRARY.fullmatch(name):
        return f"this looks like a library, which is in none of these files: {_ADD}"
    return nearest(name, known) if near_names(name, known) else _ADD
