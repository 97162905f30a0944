"""Service access points and bits of the telegrams of PROFIBUS DP-V0 (EN 50170 volume 2, part 8).

Every service of DP-V0 goes from the master's access point 62 to one of the slave's, except
Data_Exchange, which has none on either side. Which bit of Set_Prm means what: Festo P.BE-CTEU-PB
(1208NH) table A/5, Norgren FD67 section 5.4.1.1.
"""

from enum import IntEnum, IntFlag

MASTER_SAP = 62
"""Where a master sends its requests from."""


class SlaveSap(IntEnum):
    """A slave's access point for each service. Set_Slave_Add is not offered by our slaves."""

    SET_SLAVE_ADD = 55
    RD_INP = 56
    RD_OUTP = 57
    GLOBAL_CONTROL = 58
    GET_CFG = 59
    SLAVE_DIAG = 60
    SET_PRM = 61
    CHK_CFG = 62


class PrmStatus(IntFlag):
    """Bits of the first byte of Set_Prm. With Unlock, Lock does not count."""

    WD_ON = 0x08
    FREEZE_REQ = 0x10
    SYNC_REQ = 0x20
    UNLOCK_REQ = 0x40
    LOCK_REQ = 0x80


class DiagnosisStatus(IntFlag):
    """Bits of the first byte of Slave_Diag that a slave sets."""

    NOT_READY = 0x02
    CFG_FAULT = 0x04
    EXT_DIAG = 0x08
    NOT_SUPPORTED = 0x10
    PRM_FAULT = 0x40


class DiagnosisMode(IntFlag):
    """Bits of the second byte of Slave_Diag that a slave sets."""

    PRM_REQ = 0x01
    ALWAYS_1 = 0x04
    WD_ON = 0x08
    FREEZE_MODE = 0x10
    SYNC_MODE = 0x20


DIAGNOSIS_BYTES = 6
"""Length of Slave_Diag without what the device itself has to say."""
DIAGNOSIS_OVERFLOW = 0x80
"""In the third byte of Slave_Diag: the device has more to say than the telegram takes."""


class ControlCommand(IntFlag):
    """Bits of the first byte of Global_Control. Unsync and Unfreeze win over Sync and Freeze."""

    CLEAR_DATA = 0x02
    UNFREEZE = 0x04
    FREEZE = 0x08
    UNSYNC = 0x10
    SYNC = 0x20
