"""A slave as the master sees it: addresses, parameters, images of its data, and how it gets going.

The master brings a slave into data exchange with one telegram a cycle: Slave_Diag, Set_Prm,
Chk_Cfg, Slave_Diag, then Data_Exchange (EN 50170 volume 2). A slave that does not answer has
failed; its inputs then read 0, as on S7 (recalled). A slave that refuses its parameters or its
configuration stays refused until something about it changes.
"""

from collections.abc import Callable
from enum import Enum
from functools import partial
from typing import NamedTuple, Protocol

from fbgen.dataclass import dataclass
from fbgen.diagnostics import error
from fbgen.wire.dp import DiagnosisStatus
from fbgen.wire.profibus import (
    IdentifierError,
    Slot,
    decode_identifiers,
    input_length,
    output_length,
    slot_table,
)
from harness.fieldbus.parameters import Parameters
from harness.fieldbus.slave import DpSlave

_FAULTS = DiagnosisStatus.CFG_FAULT | DiagnosisStatus.PRM_FAULT


class StationState(Enum):
    """How far the master has come with a slave."""

    DIAGNOSIS = "asking for diagnosis"
    PARAMETERS = "sending parameters"
    CONFIGURATION = "sending the configuration"
    CHECK = "asking whether all is well"
    EXCHANGE = "exchanging data"
    REFUSED = "parameters or configuration refused"
    FAILED = "no answer"


_EXCHANGE, _FAILED = StationState.EXCHANGE, StationState.FAILED
"""By names of their own: Python looks a member of an Enum up slowly, and polls are many."""


@dataclass(frozen=True, slots=True)
class StationSettings:
    """What the PLC's hardware configuration says about a slave. Addresses count bytes."""

    name: str
    address: int
    configuration: bytes
    parameters: Parameters
    output_address: int = 0
    input_address: int = 0


class Transfer(NamedTuple):
    """A poll that was carried out in data exchange, for traces."""

    time_ns: int
    station: "Station"
    outputs: bytes
    inputs: bytes


class StationMaster(Protocol):
    """What a station needs from its master."""

    @property
    def address(self) -> int:
        """The master's own station address."""
        ...

    @property
    def clearing(self) -> bool:
        """True in CLEAR: every slave gets zeros."""
        ...

    @property
    def cut(self) -> bool:
        """True while the bus is cut right behind the master."""
        ...

    @property
    def taps(self) -> list[Callable[[Transfer], None]]:
        """Who gets every simulated transfer."""
        ...

    @property
    def now_ns(self) -> int:
        """The instant of this cycle."""
        ...

    def request(self, station: "Station") -> None:
        """Poll this station in the next cycle: something is new."""
        ...

    def last_cycle_ns(self) -> int:
        """The instant of the latest cycle."""
        ...

    def report(self, station: "Station") -> None:
        """The station has failed, was refused, or exchanges data again."""
        ...


class Station:
    """One slave of a master. `outputs` and `inputs` are what the CPU writes and reads.

    `failed` is True if the CPU cannot reach the data: the slave is silent or refuses. `reporting`
    is True while the slave, in data exchange, has a diagnosis of its own (Ext_Diag). `transfers`
    counts the simulated polls since data exchange began. `unsent` is True from a write until the
    next cycle.
    """

    __slots__ = (
        "_address",
        "_master",
        "_plugged",
        "failed",
        "inputs",
        "outputs",
        "queued",
        "reporting",
        "settings",
        "slave",
        "slots",
        "state",
        "transfers",
        "unsent",
    )

    def __init__(self, master: StationMaster, settings: StationSettings, slave: DpSlave) -> None:
        try:
            identifiers = decode_identifiers(settings.configuration)
        except IdentifierError as wrong:
            raise error(
                "FB7203",
                f"the configuration {settings.configuration.hex(' ').upper()} of station "
                f"'{settings.name}' cannot be read: {wrong}",
                None,
                "take the identifiers of a module in the slave's GSD file",
            ) from None
        self._address = settings.address
        self._master = master
        self._plugged = True
        self.settings = settings
        self.slave = slave
        self.slots: tuple[Slot, ...] = slot_table(
            identifiers, settings.output_address, settings.input_address
        )
        self.outputs = bytearray(output_length(identifiers))
        self.inputs = bytearray(input_length(identifiers))
        self.failed = self.reporting = False
        self.state = StationState.DIAGNOSIS
        self.queued = self.unsent = False
        self.transfers = 0
        slave.attach(partial(master.request, self))

    @property
    def exchanging(self) -> bool:
        """True while data go to and fro."""
        return self.state is _EXCHANGE

    @property
    def inputs_pending(self) -> bool:
        """True if the next cycle will bring other inputs than the master has now."""
        return self.exchanging and self.slave.inputs != self.inputs

    @property
    def reached(self) -> bool:
        """True if telegrams come through to a slave that has the station's address."""
        slave = self.slave
        return (
            self._plugged
            and slave.powered
            and slave.address == self._address
            and not self._master.cut
        )

    @property
    def plugged(self) -> bool:
        """False while the slave's bus plug is pulled."""
        return self._plugged

    @plugged.setter
    def plugged(self, plugged: bool) -> None:
        if plugged != self._plugged:
            self._plugged = plugged
            if not plugged:
                self.slave.polling_ended(self._master.last_cycle_ns())
            self._master.request(self)

    def write(self, offset: int, data: bytes) -> None:
        """The CPU writes outputs; they go out with the next cycle."""
        end = offset + len(data)
        if self.outputs[offset:end] != data:
            self.outputs[offset:end] = data
            self.unsent = True
            if not self.queued:
                self._master.request(self)

    def restart(self) -> None:
        """Begin again with Slave_Diag, as after the master was stopped."""
        self.failed = self.reporting = False
        self.state = StationState.DIAGNOSIS
        self.transfers = 0
        self.inputs[:] = bytes(len(self.inputs))

    def fail(self) -> None:
        """Its data cannot be reached any more: nobody asks for them."""
        if self.state is not _FAILED:
            self._drop(_FAILED)

    def poll(self) -> None:
        """The master's telegram of this cycle and the slave's answer."""
        self.unsent = False
        state = self.state
        if not self.reached:
            self.fail()
        elif state is _EXCHANGE:
            self._exchange()
        else:
            self._get_going(state)

    def _get_going(self, state: StationState) -> None:
        slave, settings = self.slave, self.settings
        match state:
            case StationState.DIAGNOSIS | StationState.FAILED | StationState.REFUSED:
                slave.slave_diag()
                self.failed = False
                self.state = StationState.PARAMETERS
            case StationState.PARAMETERS:
                slave.set_prm(settings.parameters, self._master.address)
                self.state = StationState.CONFIGURATION
            case StationState.CONFIGURATION:
                slave.chk_cfg(settings.configuration)
                self.state = StationState.CHECK
            case StationState.CHECK:
                if slave.slave_diag()[0] & _FAULTS:
                    self._drop(StationState.REFUSED)
                    return
                self.state = StationState.EXCHANGE
                self.transfers = 0
                self._master.request(self)
                return
        self._master.request(self)

    def _exchange(self) -> None:
        master = self._master
        outputs = bytes(len(self.outputs)) if master.clearing else bytes(self.outputs)
        answer = self.slave.data_exchange(outputs)
        if answer is None:
            self._drop(StationState.DIAGNOSIS)
            master.request(self)
            return
        if self.inputs != answer:
            self.inputs[:] = answer
        self.transfers += 1
        for tap in master.taps:
            tap(Transfer(master.now_ns, self, outputs, answer))
        reporting = self.slave.ext_diag  # told by the priority of the answer
        if self.transfers == 1 or reporting is not self.reporting:
            self.reporting = reporting
            self.slave.diagnosis_fetched()
            master.report(self)

    def _drop(self, state: StationState) -> None:
        self.state = state
        self.failed = state is not StationState.DIAGNOSIS
        self.reporting = False
        self.transfers = 0
        self.inputs[:] = bytes(len(self.inputs))
        self._master.report(self)
