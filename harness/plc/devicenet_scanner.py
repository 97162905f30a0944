"""A DeviceNet scanner in the rack of a PLC: the bytes of its drives in the image of the CPU.

The bytes stand as they come from the network, low byte first. Inputs of a drive that does not
exchange data read 0. While the CPU does not run, the scanner is idle: it polls without data.
"""

from fbgen.dataclass import dataclass
from harness.fieldbus.devicenet import ScannedSlave, Scanner
from harness.plc.cpu import Cpu, CpuMode

_MACS = 64


@dataclass(frozen=True, slots=True)
class ImagePlace:
    """Where the bytes of a drive, or of the table, lie."""

    name: str
    input_address: int
    output_address: int = 0


class _NoBus:
    """What a module of the PLC itself has in place of a bus cycle."""

    slots = ()
    failed = False
    queued = True
    inputs_pending = False


class DriveImage(_NoBus):
    """The bytes of one drive."""

    def __init__(self, settings: ImagePlace, slave: ScannedSlave) -> None:
        self._slave = slave
        self.settings = settings
        self.outputs = bytearray(slave.entry.output_length)

    @property
    def inputs(self) -> bytearray:
        """As they came last; 0 without data exchange."""
        slave = self._slave
        if not slave.exchanging:
            return bytearray(slave.entry.input_length)
        return bytearray(slave.inputs)

    def write(self, offset: int, data: bytes) -> None:
        """They go out with the next scan."""
        self.outputs[offset : offset + len(data)] = data
        self._slave.outputs = bytes(self.outputs)


class ActiveTable(_NoBus):
    """Who exchanges data: a bit for each MAC ID."""

    outputs = bytearray()

    def __init__(self, settings: ImagePlace, scanner: Scanner) -> None:
        self._scanner = scanner
        self.settings = settings

    @property
    def inputs(self) -> bytearray:
        """Bit N % 8 of byte N / 8 for MAC ID N."""
        slaves = self._scanner.slaves.values()
        running = (slave.entry.mac for slave in slaves if slave.exchanging)
        return bytearray(sum(1 << mac for mac in running).to_bytes(_MACS // 8, "little"))

    def write(self, offset: int, data: bytes) -> None:
        """There are no outputs."""


def plug_scanner(
    cpu: Cpu, scanner: Scanner, drives: dict[int, ImagePlace], table: ImagePlace | None
) -> None:
    """Put a scanner beside a CPU; `drives` go by MAC ID, `table` is where its active table lies.

    Raises DiagnosticError FB7402 for addresses that are taken.
    """
    images = [DriveImage(place, scanner.slaves[mac]) for mac, place in drives.items()]
    for image in images:
        cpu.mount_module(image)
    if table is not None:
        cpu.mount_module(ActiveTable(table, scanner))
    scanner.idle = True

    def follow(mode: CpuMode) -> None:
        scanner.idle = mode is not CpuMode.RUN
        if mode is CpuMode.STOP:
            for image in images:
                image.write(0, bytes(len(image.outputs)))

    def supplied(there: bool) -> None:
        if there and not scanner.on:
            scanner.start()
        elif not there and scanner.on:
            scanner.stop()

    cpu.on_mode.append(follow)
    cpu.on_supply.append(supplied)
