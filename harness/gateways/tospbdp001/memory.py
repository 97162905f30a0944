"""What is in a TOSPBDP001 that had its supply all the time while the PLC was started anew."""

from fbgen.dataclass import dataclass


@dataclass(frozen=True, slots=True)
class Memory:
    """The trigger that it has seen last, its status word, and the six bytes of the last reply."""

    trigger: int = 0x00
    status: int = 0x9F00
    reply: bytes = bytes(6)
