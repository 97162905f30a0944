"""The types that TIA Portal has for identifiers: of hardware, events, OBs and connections."""

from fbgen.lang.types import DWORD, INT, UINT, WORD, Elementary

HARDWARE_TYPES: dict[str, Elementary] = {
    **dict.fromkeys(
        (
            *("HW_ANY", "HW_DEVICE", "HW_DPMASTER", "HW_DPSLAVE", "HW_IO", "HW_IOSYSTEM"),
            *("HW_SUBMODULE", "HW_MODULE", "HW_INTERFACE", "HW_IEPORT", "HW_HSC", "HW_PWM"),
            *("HW_PTO", "PORT", "RTM", "PIP", "DB_WWW", "DB_DYN"),
        ),
        UINT,
    ),
    **dict.fromkeys(
        (
            *("OB_ANY", "OB_DELAY", "OB_TOD", "OB_CYCLIC", "OB_ATT", "OB_PCYCLE", "OB_HWINT"),
            *("OB_DIAG", "OB_TIMEERROR", "OB_STARTUP"),
        ),
        INT,
    ),
    **dict.fromkeys(("CONN_ANY", "CONN_PRG", "CONN_OUC"), WORD),
    **dict.fromkeys(("AOM_IDENT", "EVENT_ANY", "EVENT_ATT", "EVENT_HWINT", "CONN_R_ID"), DWORD),
}
"""TIA's names for identifiers of hardware, events, OBs, connections and some data blocks: the types
that they are (TIA Portal help, "Hardware data types")."""
