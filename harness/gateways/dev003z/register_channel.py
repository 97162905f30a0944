"""The parameter channel inside of instances 101 and 151, or 105 and 155.

A read is answered with the value as it is when the answer goes out. A write is carried out once,
when number, data or the write bit have changed; what it came to is shown until the next request.
An error shows the codes of the inverter's own protocol: our own, the text at hand does not say it.
"""

from fbgen.wire.toshiba import ErrorCode
from harness.gateways.dev003z.cells import Cells


class RegisterChannel:
    """One request at a time. `number` 0 asks for nothing, to be written neither."""

    __slots__ = ("_cells", "_error", "_request")

    def __init__(self, cells: Cells) -> None:
        self._cells = cells
        self.clear()

    def clear(self) -> None:
        """As after power-on."""
        self._request = (False, 0, 0)
        self._error: ErrorCode | None = None

    def ask(self, write: bool, number: int, data: int) -> None:
        """Take a request as it stands in the data of the master."""
        write = write and number != 0
        request = (write, number, data if write else 0)
        if request == self._request:
            return
        self._request = request
        self._error = self._cells.write(number, data) if write else None

    def answer(self) -> tuple[bool, bool, int, int]:
        """Whether it was a write, whether it failed, the number, and the data."""
        write, number, data = self._request
        if write:
            failed = self._error is not None
            return write, failed, number, data if self._error is None else int(self._error)
        if not number:
            return write, False, 0, 0
        value = self._cells.read(number)
        if value is None:
            return write, True, number, int(ErrorCode.COM_NO)
        return write, False, number, value
