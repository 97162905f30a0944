"""A PROFIBUS DP-V0 slave: the states between power-on and data exchange.

    WAIT_PRM --Set_Prm, ident right--> WAIT_CFG --Chk_Cfg, identifiers equal--> DATA_EXCHANGE
       ^                                  |  wrong configuration                     |
       +----------------------------------+----- watchdog expired, unlocked ---------+

EN 50170 volume 2. The master calls the slave's services; a service that the slave does not offer in
its state, or not to that master, says so (None or False: "no service activated"). The simulated
master calls them itself, a real one through telegrams (`responder`). Nobody calls cycle by cycle:
as long as nothing is changed on either side a poll changes nothing either, so a poll that tells
nothing new is not simulated, and the master says when it stops polling (`polling_ended`). From
there the watchdog runs. With WD_On = 0 the slave never notices that it is alone.

A slave that loses its master, or gets Clear_Data, clears its outputs, and RD_Outp gives cleared
ones before the first Data_Exchange (profichip VPC3+S user manual, 2012, pages 53 and 54).

Recalled, and in none of the documents that were looked through (manuals of VPC3+ and SPC3 modules,
felser.ch, sources of open slaves): outputs of a wrong length end data exchange; RD_Inp and RD_Outp
are refused outside of data exchange. The chips do both by themselves.
"""

from collections.abc import Callable
from enum import Enum
from typing import Protocol

from fbgen.wire.dp import (
    DIAGNOSIS_BYTES,
    DIAGNOSIS_OVERFLOW,
    ControlCommand,
    DiagnosisMode,
    DiagnosisStatus,
)
from fbgen.wire.profibus import decode_identifiers, output_length
from harness.fieldbus.parameters import Lock, Parameters, SlaveType
from harness.kernel import Event, Kernel


class SlaveState(Enum):
    """Where a slave stands."""

    WAIT_PRM = "waiting for parameters"
    WAIT_CFG = "waiting for the configuration"
    DATA_EXCHANGE = "data exchange"


_DATA_EXCHANGE = SlaveState.DATA_EXCHANGE
"""By a name of its own: Python looks a member of an Enum up slowly, and polls are many."""


class DpDevice(Protocol):
    """What stands behind a slave: the gateway itself."""

    def exchange_started(self) -> None:
        """The first outputs have come: the fieldbus is online. `outputs_received` follows."""
        ...

    def exchange_lost(self) -> None:
        """The slave has left data exchange: the fieldbus is offline."""
        ...

    def outputs_received(self, outputs: bytes) -> None:
        """The outputs are other than before, or the first ones since the fieldbus is online."""
        ...


NO_MASTER = 0xFF


class DpSlave:
    """The PROFIBUS side of a device. Inputs and outputs are seen from the PLC.

    `configuration` is what the master has chosen of what the slave accepts. `diagnosis_waiting` is
    True while the slave asks its master to fetch Slave_Diag. `power_ons` counts.
    """

    __slots__ = (
        "_attention",
        "_device",
        "_extended",
        "_held",
        "_inputs",
        "_kernel",
        "_watchdog",
        "_zeros",
        "address",
        "cfg_fault",
        "configuration",
        "diagnosis_waiting",
        "ext_diag",
        "freeze",
        "inputs",
        "master_address",
        "online",
        "outputs",
        "parameters",
        "power_ons",
        "powered",
        "prm_fault",
        "state",
        "sync",
        "type",
    )

    def __init__(
        self,
        kernel: Kernel,
        device: DpDevice,
        type: SlaveType,  # noqa: A002 - the field's term
        address: int,
        sizes: tuple[int, int],
    ) -> None:
        """`sizes` are the bytes of outputs and inputs that the type's configuration carries."""
        self._kernel = kernel
        self._device = device
        self._attention: Callable[[], None] | None = None
        self._watchdog: Event | None = None
        self._zeros = bytes(sizes[0])
        self.type = type
        self.address = address
        self.powered = self.online = self.ext_diag = self.diagnosis_waiting = False
        self.power_ons = 0
        self.configuration = type.configuration
        self._extended = b""
        self._inputs = self.inputs = bytes(sizes[1])
        self._forget()

    def _forget(self) -> None:
        self.state = SlaveState.WAIT_PRM
        self.parameters: Parameters | None = None
        self.master_address = NO_MASTER
        self.prm_fault = self.cfg_fault = False
        self._end_holding()
        self.outputs = self._held = self._zeros

    # --- the device's side ------------------------------------------------------------------

    def attach(self, attention: Callable[[], None]) -> None:
        """`attention` is called whenever the next poll would bring the master something new."""
        self._attention = attention

    def power_on(self, address: int) -> None:
        """Supply comes; the address switches are read now and not again."""
        self.address = address
        self.powered = True
        self.power_ons += 1
        self._notify()

    def power_off(self) -> None:
        """Supply goes; the slave is silent and forgets everything."""
        self.powered = False
        self._leave_exchange()
        self._forget()
        self._notify()

    def become(self, type: SlaveType) -> None:  # noqa: A002 - the field's term
        """Stand there as a slave of another type, as after the device was exchanged."""
        self.type = type
        self._leave_exchange()
        self._choose(type.configuration)
        self._forget()
        self._notify()

    def let_watchdog_expire(self) -> None:
        """No telegram came for longer than the watchdog time, though the master has sent some."""
        if self.online and self.parameters and self.parameters.watchdog_factors is not None:
            self._watchdog_expired()
            self._notify()

    def set_inputs(self, inputs: bytes) -> None:
        """New input data, all bytes of one moment."""
        if inputs != self._inputs:
            self._inputs = inputs
            if not self.freeze:
                self.inputs = inputs
                if self._attention is not None:
                    self._attention()

    def set_ext_diag(self, reported: bool, extended: bytes = b"") -> None:
        """Report a diagnosis of the device, or that it is over.

        `extended` are the bytes behind the six standard ones, with their header.
        """
        if reported is not self.ext_diag or extended != self._extended:
            self.ext_diag = reported
            self._extended = extended
            self.diagnosis_waiting = True
            self._notify()

    # --- the bus's side ---------------------------------------------------------------------

    def slave_diag(self) -> bytes:
        """Slave_Diag: the six standard bytes, and those of the device behind them."""
        status, mode = DiagnosisStatus(0), DiagnosisMode.ALWAYS_1
        if self.state is not SlaveState.DATA_EXCHANGE:
            status |= DiagnosisStatus.NOT_READY
        if self.state is SlaveState.WAIT_PRM:
            mode |= DiagnosisMode.PRM_REQ
        if self.cfg_fault:
            status |= DiagnosisStatus.CFG_FAULT
        if self.prm_fault:
            status |= DiagnosisStatus.PRM_FAULT
        if self.ext_diag:
            status |= DiagnosisStatus.EXT_DIAG
        if self.parameters is not None and self.parameters.watchdog_factors is not None:
            mode |= DiagnosisMode.WD_ON
        if self.freeze:
            mode |= DiagnosisMode.FREEZE_MODE
        if self.sync:
            mode |= DiagnosisMode.SYNC_MODE
        extended = self._extended[: self.type.max_diagnosis_bytes - DIAGNOSIS_BYTES]
        overflow = DIAGNOSIS_OVERFLOW if extended != self._extended else 0
        head = bytes((status, mode, overflow, self.master_address))
        return head + self.type.ident_number.to_bytes(2, "big") + extended

    def diagnosis_fetched(self) -> None:
        """The master of this slave has Slave_Diag as it is now: nothing more to ask for."""
        self.diagnosis_waiting = False

    def set_prm(self, parameters: Parameters | None, master_address: int) -> bool:
        """Set_Prm: from every state; a wrong ident number or user data leave the slave waiting.

        None are contents that cannot be read. False: the slave belongs to another master.
        """
        if not self.open_to(master_address):
            return False
        if parameters is not None and parameters.lock is Lock.NEITHER:
            return True  # only the delay of answers may change, which nothing here depends on
        self._leave_exchange()
        self._forget()
        if parameters is None or not self._suits(parameters):
            self.prm_fault = True
        elif parameters.lock is Lock.LOCK:
            self.parameters = parameters
            self.master_address = master_address
            self.state = SlaveState.WAIT_CFG
        return True

    def chk_cfg(self, configuration: bytes) -> bool:
        """Chk_Cfg: the identifiers must be the slave's own, byte by byte.

        False: the slave has no parameters yet.
        """
        if self.state is SlaveState.WAIT_PRM:
            return False
        if not self.type.accepts(configuration):
            self._leave_exchange()
            self._forget()
            self.cfg_fault = True
            return True
        if configuration != self.configuration:
            self._leave_exchange()
            self._choose(configuration)
        self.state = SlaveState.DATA_EXCHANGE
        return True

    def get_cfg(self) -> bytes:
        """Get_Cfg: the identifiers as they are, in every state, for every master."""
        return self.configuration

    def rd_inp(self) -> bytes | None:
        """RD_Inp: the inputs as the slave's own master gets them, for every master."""
        return self.inputs if self.state is _DATA_EXCHANGE else None

    def rd_outp(self) -> bytes | None:
        """RD_Outp: the outputs as they are put out, for every master."""
        return self.outputs if self.state is _DATA_EXCHANGE else None

    def open_to(self, master_address: int) -> bool:
        """Whether this master may give parameters: it has done so before, or nobody has."""
        return self.master_address in (NO_MASTER, master_address)

    def data_exchange(self, outputs: bytes) -> bytes | None:
        """Take outputs and give the inputs; None (service not activated) in another state."""
        if self.state is not _DATA_EXCHANGE:
            return None
        if len(outputs) != len(self._zeros):
            self._leave_exchange()
            self._forget()
            return None
        if self._watchdog is not None:
            self._stop_watchdog()
        self._held = outputs
        if not self.online:
            self.online = True
            self.outputs = outputs
            self._device.exchange_started()
            self._device.outputs_received(outputs)
        elif not self.sync and outputs != self.outputs:
            self.outputs = outputs
            self._device.outputs_received(outputs)
        return self.inputs

    def global_control(self, command: int, groups: int) -> None:
        """Global_Control; `groups` 00 means all slaves."""
        if self.state is not SlaveState.DATA_EXCHANGE or self.parameters is None:
            return
        if groups and not groups & self.parameters.group:
            return
        if command & ControlCommand.CLEAR_DATA:
            self._held = self._zeros
            self._apply(self._zeros)
        if command & ControlCommand.UNSYNC:
            self.sync = False
            self._apply(self._held)
        elif command & ControlCommand.SYNC and self.parameters.sync:
            self.sync = True
            self._apply(self._held)
        unfreeze = command & ControlCommand.UNFREEZE
        if unfreeze or (command & ControlCommand.FREEZE and self.parameters.freeze):
            self.freeze = not unfreeze
            if self.inputs != self._inputs:
                self.inputs = self._inputs
                self._notify()

    def polling_ended(self, last_poll_ns: int) -> None:
        """The last telegram for this slave was at `last_poll_ns`; the next is not in sight."""
        watchdog_ns = self.parameters.watchdog_ns if self.parameters else None
        if watchdog_ns is not None and self._watchdog is None:
            self._watchdog = self._kernel.at(last_poll_ns + watchdog_ns, self._watchdog_expired)

    # --- inside -----------------------------------------------------------------------------

    def _end_holding(self) -> None:
        self.sync = self.freeze = False
        self.inputs = self._inputs

    def _choose(self, configuration: bytes) -> None:
        if configuration != self.configuration:
            self.configuration = configuration
            self._zeros = bytes(output_length(decode_identifiers(configuration)))
            self._end_holding()
            self.outputs = self._held = self._zeros

    def _suits(self, parameters: Parameters) -> bool:
        factors = parameters.watchdog_factors
        return (
            parameters.ident_number == self.type.ident_number
            and len(parameters.user_data) == self.type.user_parameter_bytes
            and (factors is None or 0 not in factors)
        )

    def _apply(self, outputs: bytes) -> None:
        if outputs != self.outputs:
            self.outputs = outputs
            self._device.outputs_received(outputs)

    def _watchdog_expired(self) -> None:
        self._watchdog = None
        self._leave_exchange()
        self._forget()

    def _leave_exchange(self) -> None:
        self._stop_watchdog()
        self.state = SlaveState.WAIT_PRM
        if self.online:
            self.online = False
            self._device.exchange_lost()

    def _stop_watchdog(self) -> None:
        if self._watchdog is not None:
            self._kernel.cancel(self._watchdog)
            self._watchdog = None

    def _notify(self) -> None:
        if self._attention is not None:
            self._attention()
