"""DPRD_DAT and DPWR_DAT (SFC14 and SFC15): consistent data of one module, with their RET_VAL.

One call reaches one configuration identifier. A record of another length than the module's is
refused with 80B1 by an S7-300/400; an S7-1200/1500 refuses only one that is too short, and of a
longer one moves as much as the module has, with RET_VAL 0000. Codes: TIA Portal help, "DPRD_DAT",
"DPWR_DAT" (both families). Which of them a failing slave gives depends on where the master sits.
"""

from enum import IntEnum

from fbgen.lang.types import BOOL, BYTE, ArrayType, StringType, StructType, Type
from fbgen.wire.profibus import Slot
from harness.engine.environment import Area
from harness.fieldbus import Station
from harness.plc.link import MasterLink
from harness.plc.modules import ModuleTable
from harness.plc.settings import CpuFamily, CpuSettings, DpInterface


class RetVal(IntEnum):
    """RET_VAL as an unsigned word; as INT all but 0000 are negative."""

    OK = 0x0000
    NOT_CONFIGURED = 0x8090
    WRONG_TYPE = 0x8092
    NO_SUCH_MODULE = 0x8093
    READ_ACCESS_ERROR = 0x80A0
    WRITE_ACCESS_ERROR = 0x80A1
    SLAVE_FAILURE = 0x80B0
    WRONG_LENGTH = 0x80B1
    NOT_READ_YET = 0x80C0
    PREVIOUS_WRITE_PENDING = 0x80C1


class ConsistentData:
    """The two instructions on one CPU.

    `answer_with` makes the next calls give a RET_VAL that the model has no cause for, such as the
    system errors 80B2, 80B3, 80C2, 80Fx, 808x, 85xy, 87xy. As long as `refused_reading` or
    `refused_writing` is not 0, reads or writes do nothing and give that.
    """

    __slots__ = (
        *("_forced", "_image", "_link", "_modules", "_settings"),
        *("refused_reading", "refused_writing"),
    )

    def __init__(
        self, settings: CpuSettings, modules: ModuleTable, link: MasterLink, image: bytearray
    ) -> None:
        """`image` is the process image of the outputs, which a write brings up to date."""
        self._settings = settings
        self._modules = modules
        self._link = link
        self._image = image
        self._forced: list[int] = []
        self.refused_reading = 0
        self.refused_writing = 0

    def answer_with(self, ret_val: int, calls: int = 1) -> None:
        """Let the next calls do nothing and give `ret_val`."""
        self._forced += [ret_val] * calls

    def read(self, laddr: int, record: Area) -> int:
        """DPRD_DAT: inputs of the module at `laddr` into `record`. Gives RET_VAL."""
        if self._forced or self.refused_reading:
            return self._forced.pop(0) if self._forced else self.refused_reading
        module = self._modules.readable.get(laddr)
        if module is None:
            return self._missing(laddr, self._modules.writable)
        if not takes_area(record.type, self._settings):
            return RetVal.WRONG_TYPE
        station, slot = module
        length = slot.identifier.input_length
        if self._wrong_length(record.length, length):
            return RetVal.WRONG_LENGTH
        if not station.exchanging or not station.transfers:
            return self._unreachable(station, RetVal.READ_ACCESS_ERROR)
        data = self._link.read(station, slot.input_offset or 0, length)
        if self._settings.family is CpuFamily.S7_1500:
            data = data.ljust(record.length, b"\0")
        record.write(data)
        return RetVal.OK

    def write(self, laddr: int, record: Area) -> int:
        """DPWR_DAT: `record` to the outputs of the module at `laddr`. Gives RET_VAL."""
        if self._forced or self.refused_writing:
            return self._forced.pop(0) if self._forced else self.refused_writing
        module = self._modules.writable.get(laddr)
        if module is None:
            return self._missing(laddr, self._modules.readable)
        if not takes_area(record.type, self._settings):
            return RetVal.WRONG_TYPE
        station, slot = module
        length = slot.identifier.output_length
        if self._wrong_length(record.length, length):
            return RetVal.WRONG_LENGTH
        if not station.exchanging:
            return self._unreachable(station, RetVal.WRITE_ACCESS_ERROR)
        if station.unsent and self._settings.dp_interface is DpInterface.EXTERNAL:
            return RetVal.PREVIOUS_WRITE_PENDING
        data = record.read()[:length]
        self._link.write(station, slot.output_offset or 0, data)
        if station in self._modules.image:
            at = slot.output_address or 0
            self._image[at : at + length] = data
        return RetVal.OK

    def _missing(self, laddr: int, other: dict[int, tuple[Station, Slot]]) -> int:
        """The module has no data in this direction, or there is no module at all."""
        return RetVal.NO_SUCH_MODULE if laddr in other else RetVal.NOT_CONFIGURED

    def _wrong_length(self, record: int, module: int) -> bool:
        return record < module or (record > module and self._settings.family.classic)

    def _unreachable(self, station: Station, access_error: RetVal) -> int:
        if not station.failed:
            return RetVal.NOT_READ_YET
        if self._settings.dp_interface is DpInterface.EXTERNAL and self._settings.family.classic:
            return RetVal.SLAVE_FAILURE
        return access_error


def takes_area(kind: Type, settings: CpuSettings) -> bool:
    """Whether a variable of this type may be RECORD on this CPU."""
    if settings.family.classic:
        return (
            kind == BYTE
            or isinstance(kind, StructType)
            or (isinstance(kind, ArrayType) and kind.element == BYTE)
        )
    element = kind.element if isinstance(kind, ArrayType) else kind
    return element != BOOL and not isinstance(element, StringType)
