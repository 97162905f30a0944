"""Which byte address and which LADDR leads to which module of which slave."""

from fbgen.dataclass import dataclass
from fbgen.diagnostics import error
from fbgen.wire.profibus import Slot
from harness.fieldbus import Station
from harness.plc.io_module import IoModule
from harness.plc.settings import CpuSettings


@dataclass(frozen=True, slots=True)
class Mounting:
    """How a station is tied into the CPU.

    With `process_image` the system exchanges its data with the process image once a cycle.
    `hardware_identifier` is that of its first module on an S7-1200/1500, the others follow; with
    None a module's LADDR is its start address, as always on an S7-300/400. `diagnosis_address` is
    the LADDR of the station itself, under which its diagnosis is read; None where nobody reads it.
    """

    station: Station
    process_image: bool
    hardware_identifier: int | None = None
    diagnosis_address: int | None = None


class ModuleTable:
    """All modules of a CPU by address and by LADDR.

    `inputs` and `outputs` lead from a byte address to the module and the offset in its data,
    `readable` and `writable` from a LADDR to the station and its module.
    """

    __slots__ = ("image", "inputs", "outputs", "readable", "writable")

    def __init__(self) -> None:
        self.inputs: dict[int, tuple[IoModule, int]] = {}
        self.outputs: dict[int, tuple[IoModule, int]] = {}
        self.readable: dict[int, tuple[Station, Slot]] = {}
        self.writable: dict[int, tuple[Station, Slot]] = {}
        self.image: list[IoModule] = []

    def mount(self, mounting: Mounting, cpu: CpuSettings) -> None:
        """Enter a station.

        Raises DiagnosticError FB7402 for an address that is taken or lies outside of the memory.
        """
        station = mounting.station
        self.place(station, cpu, process_image=mounting.process_image)
        first = None if cpu.family.classic else mounting.hardware_identifier
        for slot in station.slots:
            by_identifier = None if first is None else first + slot.number - 1
            if slot.input_address is not None:
                laddr = slot.input_address if by_identifier is None else by_identifier
                self.readable[laddr] = (station, slot)
            if slot.output_address is not None:
                laddr = slot.output_address if by_identifier is None else by_identifier
                self.writable[laddr] = (station, slot)

    def place(self, module: IoModule, cpu: CpuSettings, *, process_image: bool) -> None:
        """Enter the bytes of a module, without a LADDR. Raises DiagnosticError as `mount`."""
        settings = module.settings
        ranges = (
            (self.inputs, settings.input_address, len(module.inputs), "input"),
            (self.outputs, settings.output_address, len(module.outputs), "output"),
        )
        for table, address, length, what in ranges:
            if process_image and not 0 <= address <= cpu.memory_bytes - length:
                raise error(
                    "FB7402",
                    f"the {what} bytes {address}..{address + length - 1} of "
                    f"'{settings.name}' lie outside of the process image",
                    None,
                    f"the process image has the bytes 0..{cpu.memory_bytes - 1}",
                )
            self._enter(table, module, address, length, what)
        if process_image:
            self.image.append(module)

    def _enter(
        self,
        table: dict[int, tuple[IoModule, int]],
        station: IoModule,
        address: int,
        length: int,
        what: str,
    ) -> None:
        for offset in range(length):
            taken = table.get(address + offset)
            if taken is not None:
                raise error(
                    "FB7402",
                    f"the {what} byte {address + offset} belongs to both "
                    f"'{taken[0].settings.name}' and '{station.settings.name}'",
                    None,
                    f"choose {what} addresses that do not overlap",
                )
            table[address + offset] = (station, offset)
