"""A PROFIBUS DP-V0 slave: the states between power-on and data exchange.

    WAIT_PRM --Set_Prm, ident right--> WAIT_CFG --Chk_Cfg, identifiers equal--> DATA_EXCHANGE
       ^                                  |  wrong configuration                     |
       +----------------------------------+----------- watchdog expired -------------+

EN 50170 volume 2. The master calls the slave's services; nobody calls it cycle by cycle. As long as
nothing is changed on either side a poll changes nothing either, so a poll that tells nothing new is
not simulated, and the master says when it stops polling (`polling_ended`). From there the watchdog
runs. With WD_On = 0 the slave never notices that it is alone.
"""

from collections.abc import Callable
from enum import Enum, IntFlag
from typing import Protocol

from harness.fieldbus.parameters import Parameters, SlaveType
from harness.kernel import Event, Kernel


class SlaveState(Enum):
    """Where a slave stands."""

    WAIT_PRM = "waiting for parameters"
    WAIT_CFG = "waiting for the configuration"
    DATA_EXCHANGE = "data exchange"


_DATA_EXCHANGE = SlaveState.DATA_EXCHANGE
"""By a name of its own: Python looks a member of an Enum up slowly, and polls are many."""


class ControlCommand(IntFlag):
    """Bits of the first byte of Global_Control. Unsync and Unfreeze win over Sync and Freeze."""

    CLEAR_DATA = 0x02
    UNFREEZE = 0x04
    FREEZE = 0x08
    UNSYNC = 0x10
    SYNC = 0x20


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
_NOT_READY, _CFG_FAULT, _EXT_DIAG, _PRM_FAULT = 0x02, 0x04, 0x08, 0x40
_PRM_REQ, _ALWAYS_1, _WD_ON, _FREEZE_MODE, _SYNC_MODE = 0x01, 0x04, 0x08, 0x10, 0x20


class DpSlave:
    """The PROFIBUS side of a device. Inputs and outputs are seen from the PLC."""

    __slots__ = (
        "_attention",
        "_device",
        "_held",
        "_inputs",
        "_kernel",
        "_watchdog",
        "_zeros",
        "address",
        "cfg_fault",
        "ext_diag",
        "freeze",
        "inputs",
        "master_address",
        "online",
        "outputs",
        "parameters",
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
        """`sizes` are the bytes of outputs and inputs that the configuration carries."""
        self._kernel = kernel
        self._device = device
        self._attention: Callable[[], None] | None = None
        self._watchdog: Event | None = None
        self._zeros = bytes(sizes[0])
        self.type = type
        self.address = address
        self.powered = self.online = self.ext_diag = False
        self._inputs = self.inputs = bytes(sizes[1])
        self._forget()

    def _forget(self) -> None:
        self.state = SlaveState.WAIT_PRM
        self.parameters: Parameters | None = None
        self.master_address = NO_MASTER
        self.prm_fault = self.cfg_fault = False
        self.sync = self.freeze = False
        self.outputs = self._held = self._zeros

    # --- the device's side ------------------------------------------------------------------

    def attach(self, attention: Callable[[], None]) -> None:
        """`attention` is called whenever the next poll would bring the master something new."""
        self._attention = attention

    def power_on(self, address: int) -> None:
        """Supply comes; the address switches are read now and not again."""
        self.address = address
        self.powered = True
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

    def set_ext_diag(self, reported: bool) -> None:
        """Report a diagnosis of the device, or that it is over."""
        if reported is not self.ext_diag:
            self.ext_diag = reported
            self._notify()

    # --- the bus's side ---------------------------------------------------------------------

    def slave_diag(self) -> bytes:
        """The six standard bytes of Slave_Diag."""
        exchanging = self.state is SlaveState.DATA_EXCHANGE
        first = (
            (0 if exchanging else _NOT_READY)
            | (_CFG_FAULT if self.cfg_fault else 0)
            | (_EXT_DIAG if self.ext_diag else 0)
            | (_PRM_FAULT if self.prm_fault else 0)
        )
        watched = self.parameters is not None and self.parameters.watchdog_factors is not None
        second = (
            _ALWAYS_1
            | (_PRM_REQ if self.state is SlaveState.WAIT_PRM else 0)
            | (_WD_ON if watched else 0)
            | (_FREEZE_MODE if self.freeze else 0)
            | (_SYNC_MODE if self.sync else 0)
        )
        ident = self.type.ident_number.to_bytes(2, "big")
        return bytes((first, second, 0, self.master_address)) + ident

    def set_prm(self, parameters: Parameters, master_address: int) -> None:
        """Set_Prm: from every state; a wrong ident number or user data leave the slave waiting."""
        self._leave_exchange()
        self._forget()
        if (
            parameters.ident_number != self.type.ident_number
            or len(parameters.user_data) != self.type.user_parameter_bytes
        ):
            self.prm_fault = True
            return
        self.parameters = parameters
        self.master_address = master_address
        self.state = SlaveState.WAIT_CFG

    def chk_cfg(self, configuration: bytes) -> None:
        """Chk_Cfg: the identifiers must be the slave's own, byte by byte."""
        if self.state is not SlaveState.WAIT_CFG:
            return
        if configuration != self.type.configuration:
            self._forget()
            self.cfg_fault = True
            return
        self.state = SlaveState.DATA_EXCHANGE

    def data_exchange(self, outputs: bytes) -> bytes | None:
        """Take outputs and give the inputs; None (service not activated) in another state."""
        if self.state is not _DATA_EXCHANGE:
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
        elif command & ControlCommand.SYNC:
            self.sync = True
            self._apply(self._held)
        if command & (ControlCommand.UNFREEZE | ControlCommand.FREEZE):
            self.freeze = not command & ControlCommand.UNFREEZE
            if self.inputs != self._inputs:
                self.inputs = self._inputs
                self._notify()

    def polling_ended(self, last_poll_ns: int) -> None:
        """The last telegram for this slave was at `last_poll_ns`; the next is not in sight."""
        watchdog_ns = self.parameters.watchdog_ns if self.parameters else None
        if watchdog_ns is not None and self._watchdog is None:
            self._watchdog = self._kernel.at(last_poll_ns + watchdog_ns, self._watchdog_expired)

    # --- inside -----------------------------------------------------------------------------

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
