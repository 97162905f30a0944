"""What catalogue coverage does not ask for, because nothing that is documented brings it about.

`docs/reference/coverage.md` has it for users.
"""

from collections.abc import Mapping

from fbgen.catalog import Word
from fbgen.wire.devicenet import Status
from harness.plc.consistent_data import RetVal

NEVER_READ = frozenset((RetVal.WRITE_ACCESS_ERROR, RetVal.PREVIOUS_WRITE_PENDING))
"""RET_VALs that tell of a write: DPRD_DAT (SFC14) does not give them."""
NEVER_WRITTEN = frozenset((RetVal.READ_ACCESS_ERROR,))
"""RET_VALs that tell of a read: DPWR_DAT (SFC15) does not give them."""

UNUSED: Mapping[str, str] = {
    "tospbdp001.control.execute_command = 1": "there are no control codes in Generic Data Mode",
    "tospbdp001.status.data_valid = 1": "the gateway does not use the bit, it is always 0",
}
"""Values of the gateway's words for which its manual has no use, with the reason."""

NEVER_ANSWERED = frozenset((Status.SUCCESS, Status.VENDOR_SPECIFIC))
"""General status codes that are no refusal, or that the DEV003Z has no use for."""
NEVER_LIT: Mapping[str, str] = {
    "dev003z.module_status = red": "no document says which faults cannot be mended",
}
"""Lights of lamps that nothing brings about, with the reason."""
NEVER_SHOWN: Mapping[str, str] = {
    f"dev003z.{instance}.extended_status.drive_status = {state}": reason
    for instance in (71, 151)
    for state, reason in (
        (0, "the option has no state of the vendor's"),
        (1, "it is not on the network yet"),
        (2, "it has its supply from the inverter, which then is ready"),
    )
}
"""Values of words of assemblies that nothing brings about, with the reason."""


def is_counted(word: Word) -> bool:
    """False for a word whose bits no document names for this series."""
    return word.status != "unverified"
