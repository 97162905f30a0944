"""All numbers that a master can read and write: the cells of the inverter and the option's own."""

from fbgen.wire.toshiba import ErrorCode
from harness.gateways.dev003z.host import Host
from harness.gateways.dev003z.own_parameters import OwnParameters


class Cells:
    """Reads and writes by communication number, in the EEPROM too if `eeprom` says so."""

    __slots__ = ("_eeprom", "_host", "_own")

    def __init__(self, host: Host, own: OwnParameters, *, eeprom: bool) -> None:
        self._host = host
        self._own = own
        self._eeprom = eeprom

    def read(self, number: int) -> int | None:
        """The word, None if there is none or the inverter has no supply."""
        if not self._host.powered:
            return None
        own = self._own.read(number)
        return self._host.read(number) if own is None else own

    def writable(self, number: int) -> bool:
        """Whether a number is there and not for reading alone."""
        return self._own.read(number) is not None or self._host.writable(number)

    def write(self, number: int, word: int) -> ErrorCode | None:
        """Write a word; why it is refused, or None."""
        if not self._host.powered:
            return ErrorCode.CANNOT_EXECUTE
        if self._own.read(number) is not None:
            return self._own.write(number, word)
        write = self._host.write_eeprom if self._eeprom else self._host.write_ram
        return write(number, word)
