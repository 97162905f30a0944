"""What the running program reaches of its CPU: memory, hardware, system instructions.

An access to hardware in the middle of a scan has an instant of its own, and everything that happens
up to that instant happens first, so that PROFIBUS cycles fall between two accesses of one scan.
"""

from collections.abc import Callable, Mapping

from fbgen.diagnostics import DiagnosticError, error
from fbgen.lang.types import Scalar
from fbgen.source import Span
from harness.engine.environment import Area
from harness.engine.services import Services
from harness.fieldbus import DpMaster
from harness.kernel import Kernel
from harness.plc.consistent_data import ConsistentData
from harness.plc.error_events import ErrorEvent, access_event
from harness.plc.io_module import IoModule
from harness.plc.link import MasterLink
from harness.plc.modules import ModuleTable, Mounting
from harness.plc.serial.instructions import serial_instructions
from harness.plc.serial.ports import SerialPorts
from harness.plc.settings import CpuSettings
from harness.plc.several import Several, several_at
from harness.plc.slave_diagnosis import SlaveDiagnosis

Instruction = Callable[[Mapping[str, "Scalar | Area"], Span], Scalar]
"""What carries out a system instruction: arguments by name, where it is called, RET_VAL."""


class HardwareAccess:
    """The environment of an engine (`harness.engine.environment.Environment`) on one CPU.

    `now_ns` is the instant at which the scan began. `instructions` are the system instructions by
    name. `access_errors` counts direct accesses that nobody answered. Functions in `on_supply` are
    called when the supply of the rack is there, which they may know already, or is gone.
    """

    __slots__ = (
        "_image",
        "_inputs_at",
        "_instant_ns",
        "_kernel",
        "_modules",
        "_outputs_at",
        "_peripheral_ns",
        "_quiet_until_ns",
        "_reads",
        "_writes",
        "access_errors",
        "consistent_data",
        "inputs",
        "instructions",
        "link",
        "markers",
        "now_ns",
        "on_supply",
        "outputs",
        "serial_ports",
        "services",
        "settings",
        "slave_diagnosis",
    )

    def __init__(self, kernel: Kernel, settings: CpuSettings, master: DpMaster) -> None:
        self._kernel = kernel
        self._modules = ModuleTable()
        self._inputs_at = self._modules.inputs
        self._outputs_at = self._modules.outputs
        self._image = self._modules.image
        self._peripheral_ns = settings.peripheral_ns
        self._reads: dict[str, Several | None] = {}
        self._writes: dict[str, Several | None] = {}
        self.settings = settings
        self.services = Services()
        self.inputs = bytearray(settings.memory_bytes)
        self.outputs = bytearray(settings.memory_bytes)
        self.markers = bytearray(settings.memory_bytes)
        self.access_errors = 0
        self.link = MasterLink(master, kernel.random, settings.tear_probability)
        self.consistent_data = ConsistentData(settings, self._modules, self.link, self.outputs)
        self.slave_diagnosis = SlaveDiagnosis(kernel, settings, master)
        self.instructions: dict[str, Instruction] = {}
        if settings.family.consistent_instructions:
            for name in ("DPRD_DAT", "SFC14"):
                self.instructions[name] = self._dprd_dat
            for name in ("DPWR_DAT", "SFC15"):
                self.instructions[name] = self._dpwr_dat
            for name in ("DPNRM_DG", "SFC13"):
                self.instructions[name] = self._dpnrm_dg
        self.on_supply: list[Callable[[bool], None]] = []
        self.serial_ports = SerialPorts(kernel, self._reach_hardware, self._data_block)
        if settings.family.consistent_instructions:
            models = serial_instructions(self.serial_ports, classic=settings.family.classic)
            self.services.stubs.models.update(models)
        self._begin()

    @property
    def modules(self) -> ModuleTable:
        """What is mounted, by address."""
        return self._modules

    @property
    def classic(self) -> bool:
        """True for S7-300 and S7-400."""
        return self.settings.family.classic

    def mount(self, mounting: Mounting) -> None:
        """Tie a station of the master into the address space.

        Raises DiagnosticError FB7402 for addresses that are taken or lie outside of the memory.
        """
        self._modules.mount(mounting, self.settings)
        if mounting.diagnosis_address is not None:
            self.slave_diagnosis.stations[mounting.diagnosis_address] = mounting.station
        self._reads.clear()
        self._writes.clear()

    def mount_module(self, module: IoModule) -> None:
        """Tie a module of the PLC itself into the address space; it is in the process image.

        Raises DiagnosticError FB7402 as `mount`.
        """
        self._modules.place(module, self.settings, process_image=True)
        self._reads.clear()
        self._writes.clear()

    def _supply(self, *, there: bool) -> None:
        """The supply of the rack is there, or gone."""
        for module in self.serial_ports:
            if there:
                module.power_on()
            else:
                module.power_off()
        for observer in self.on_supply:
            observer(there)

    def _begin(self) -> None:
        """A scan, or a start-up, begins now."""
        self.now_ns = self._instant_ns = self._kernel.now_ns
        self._quiet_until_ns = self._kernel.quiet_until_ns()

    def read_peripheral(self, byte: int, count: int) -> int:
        """`count` bytes (1, 2, 4) straight from the master's image, big endian."""
        instant_ns = self._instant_ns = self._instant_ns + self._peripheral_ns
        if instant_ns >= self._quiet_until_ns:
            self._let_happen(instant_ns)
        try:
            station, offset = self._inputs_at[byte]
        except KeyError:
            return self._access_error(access_event(byte, count, reading=True))
        if station.failed:
            return self._access_error(access_event(byte, count, reading=True))
        inputs = station.inputs
        if count == 1:
            return inputs[offset]
        if offset + count > len(inputs):
            return self._access_error(access_event(byte, count, reading=True))
        if self.link.armed:
            self._let_happen(instant_ns)
            return int.from_bytes(self.link.read(station, offset, count), "big")
        if count == 2:
            return inputs[offset] << 8 | inputs[offset + 1]
        return int.from_bytes(inputs[offset : offset + count], "big")

    def read_several(self, places: str) -> tuple[int, ...] | None:
        """Several values by one call, or None if something may happen between the accesses."""
        try:
            reads = self._reads[places]
        except KeyError:
            reads = self._reads[places] = several_at(places, self._inputs_at, self._peripheral_ns)
        if reads is None:
            return None
        station = reads.station
        instant_ns = self._instant_ns + reads.took_ns
        if instant_ns >= self._quiet_until_ns or station.failed or self.link.armed:
            return None
        self._instant_ns = instant_ns
        values = reads.unpack(station.inputs, reads.first)
        return values if reads.in_order is None else reads.in_order(values)

    def write_peripheral(self, byte: int, count: int, value: int) -> None:
        """`count` bytes (1, 2, 4) straight to the master's image, big endian."""
        instant_ns = self._instant_ns = self._instant_ns + self._peripheral_ns
        if instant_ns >= self._quiet_until_ns:
            self._let_happen(instant_ns)
        try:
            station, offset = self._outputs_at[byte]
        except KeyError:
            self._access_error(access_event(byte, count, reading=False))
            return
        if station.failed:
            self._access_error(access_event(byte, count, reading=False))
            return
        outputs = station.outputs
        if offset + count > len(outputs):
            self._access_error(access_event(byte, count, reading=False))
            return
        if count == 1:
            is_new = outputs[offset] != value
        elif count == 2:
            is_new = outputs[offset] << 8 | outputs[offset + 1] != value
        else:
            is_new = True
        if is_new:
            if not station.queued or self.link.armed:
                # a bus cycle that is asked for now is looked for from this instant on
                self._let_happen(instant_ns)
            self.link.write(station, offset, value.to_bytes(count, "big"))
            self._quiet_until_ns = self._kernel.quiet_until_ns()
        if self._image and station in self._image:
            self.outputs[byte : byte + count] = value.to_bytes(count, "big")

    def write_several(self, places: str, values: tuple[int, ...]) -> bool:
        """Several values by one call; False if something could happen between the accesses.

        That could also be the bus cycle that the first of them asks for.
        """
        try:
            writes = self._writes[places]
        except KeyError:
            writes = self._writes[places] = self._several_writes(places)
        if writes is None:
            return False
        station, begin_ns = writes.station, self._instant_ns
        end_ns = begin_ns + writes.took_ns
        if end_ns >= self._quiet_until_ns or station.failed or self.link.armed:
            return False
        if not station.queued and self.link.next_cycle_ns(begin_ns) <= end_ns:
            return False
        self._instant_ns = end_ns
        present = writes.unpack(station.outputs, writes.first)
        if writes.in_order is not None:
            present = writes.in_order(present)
        if values != present:
            for number, value in enumerate(values):
                if value != present[number]:
                    offset, count, after_ns = writes.pieces[number]
                    if not station.queued:
                        # the bus cycle that is asked for now is looked for from this instant on
                        self._kernel.run_until(begin_ns + after_ns)
                    station.write(offset, value.to_bytes(count, "big"))
            self._quiet_until_ns = self._kernel.quiet_until_ns()
        return True

    def _several_writes(self, places: str) -> Several | None:
        writes = several_at(places, self._outputs_at, self._peripheral_ns)
        return None if writes is None or writes.station in self._image else writes

    def _let_happen(self, instant_ns: int) -> None:
        """Let the world go on up to an instant, and note how long nothing will happen then.

        Within a scan only the program's own accesses can arrange for something new.
        """
        self._quiet_until_ns = self._kernel.run_until(instant_ns)
        while self._instant_ns > instant_ns:  # an interrupt came in between and took its time
            instant_ns = self._instant_ns
            self._quiet_until_ns = self._kernel.run_until(instant_ns)

    def instruction(self, name: str, arguments: Mapping[str, Scalar | Area], span: Span) -> Scalar:
        """Carry out a system instruction and give its result.

        Raises DiagnosticError FB7406 for one that this CPU does not have.
        """
        carry_out = self.instructions.get(name)
        if carry_out is None:
            raise error(
                "FB7406",
                f"a CPU of the family {self.settings.family.value} has no instruction {name}",
                span,
                f"it has {', '.join(sorted(self.instructions)) or 'none'}",
            )
        return carry_out(arguments, span)

    def _dprd_dat(self, arguments: Mapping[str, Scalar | Area], span: Span) -> int:
        laddr, record = self._consistent_access(arguments, span)
        return _as_int(self.consistent_data.read(laddr, record))

    def _dpwr_dat(self, arguments: Mapping[str, Scalar | Area], span: Span) -> int:
        laddr, record = self._consistent_access(arguments, span)
        return _as_int(self.consistent_data.write(laddr, record))

    def _dpnrm_dg(self, arguments: Mapping[str, Scalar | Area], span: Span) -> int:
        laddr, record = self._consistent_access(arguments, span)
        ret_val, is_busy = self.slave_diagnosis.read(bool(arguments["REQ"]), laddr, record)
        busy = arguments["BUSY"]
        assert not isinstance(busy, bool | int | float | str), "an output is an area"
        busy.write(bytes((is_busy,)))
        return _as_int(ret_val)

    def _consistent_access(
        self, arguments: Mapping[str, Scalar | Area], span: Span
    ) -> tuple[int, Area]:
        self._reach_hardware()
        laddr, record = arguments["LADDR"], arguments["RECORD"]
        if not isinstance(laddr, int) or isinstance(record, bool | int | float | str):
            raise error(
                "FB7407",
                "LADDR must be a number and RECORD a variable",
                span,
                "give LADDR the module's address and RECORD an array of bytes",
            )
        return laddr, record

    def _reach_hardware(self) -> None:
        """An instruction comes to its module: up to then everything happens first."""
        self._instant_ns += self.settings.instruction_ns
        self._let_happen(self._instant_ns)
        self._quiet_until_ns = 0

    def _data_block(self, number: int) -> bytearray | None:
        """The bytes of a data block of the program; whoever knows the program gives them."""
        return None

    def _access_error(self, event: ErrorEvent) -> int:
        """Nobody is there: 0 is read, and whoever knows the program's blocks does more."""
        self.access_errors += 1
        return 0


def _as_int(ret_val: int) -> int:
    """RET_VAL as INT: 80xx is negative."""
    return ret_val - 0x10000 if ret_val & 0x8000 else ret_val


def missing_ob(number: int, why: str) -> DiagnosticError:
    """FB7408: what an S7-300/400 does without the organization block for an error."""
    return error(
        "FB7408",
        f"{why}, and the CPU stops because OB{number} is missing",
        None,
        f"add OB{number} to the project; it may be empty. fbgen generate writes it (error_obs)",
    )
