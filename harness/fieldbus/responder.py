"""A slave's answers to telegrams: the second way into the same slave, for a real master.

Which access point is which service, and who may use it: EN 50170 volume 2. Set_Prm and Chk_Cfg are
acknowledged when they have arrived, right or wrong (felser.ch, PROFIBUS Handbuch, Set Parameters);
Slave_Diag tells which. A telegram that is none, a reserved function and a telegram for another
station get silence; a service that is not there, or not now, or not for this master gets "no
service activated" (RS), as Acromag's Introduction to ProfiBus DP lists the causes (page 20). The
watchdog waits for any data traffic with the slave's own master (Beckhoff Information System,
TwinCAT 3 I/O, DP-Watchdog), so it runs anew with every request of that master here; that one
without data, such as Slave_Diag, counts as well is our reading.

Recalled, and found in no document: RS is also the answer to SDA, Ident and LSAP status; a request
of another station ends the memory for repeated ones.
"""

from typing import NamedTuple

from fbgen.wire.dp import MASTER_SAP, SlaveSap
from fbgen.wire.fdl import (
    BROADCAST,
    DataTelegram,
    ReplyFunction,
    RequestFunction,
    ShortAcknowledgement,
    Telegram,
)
from harness.fieldbus.parameters import decode_parameters
from harness.fieldbus.slave import DpSlave
from harness.kernel import Event, Kernel

_UNANSWERED = (RequestFunction.SDN_LOW, RequestFunction.SDN_HIGH)
_ANSWERED = (RequestFunction.SRD_LOW, RequestFunction.SRD_HIGH)
_NOT_OFFERED = (
    RequestFunction.SDA_LOW,
    RequestFunction.SDA_HIGH,
    RequestFunction.DIAGNOSIS,
    RequestFunction.IDENT,
    RequestFunction.LSAP_STATUS,
)
_CONTROL_BYTES = 2
_EMPTY_REQUESTS = (SlaveSap.SLAVE_DIAG, SlaveSap.GET_CFG, SlaveSap.RD_INP, SlaveSap.RD_OUTP)


class _Memory(NamedTuple):
    """The latest counted request of a station, and what it was answered."""

    source: int
    frame_count_bit: bool
    power_ons: int
    answer: Telegram


class Responder:
    """The data link side of one slave."""

    __slots__ = ("_heard_ns", "_kernel", "_look", "_memory", "slave")

    def __init__(self, kernel: Kernel, slave: DpSlave) -> None:
        self._kernel = kernel
        self._memory: _Memory | None = None
        self._heard_ns = 0
        self._look: Event | None = None
        self.slave = slave

    def answer(self, telegram: Telegram) -> Telegram | None:
        """What the slave sends, right now, to a telegram on its bus; None for silence."""
        if (
            not isinstance(telegram, DataTelegram)
            or not telegram.is_request
            or not self.slave.powered
        ):
            return None
        if telegram.function in _UNANSWERED:
            if telegram.destination in (BROADCAST, self.slave.address):
                self._global_control(telegram)
            return None
        if telegram.destination != self.slave.address:
            return None
        if telegram.function == RequestFunction.FDL_STATUS:
            return _reply(telegram, ReplyFunction.OK)
        if telegram.function in _NOT_OFFERED:
            return _reply(telegram, ReplyFunction.NO_SERVICE)
        if telegram.function not in _ANSWERED:
            return None
        return self._repeated(telegram) or self._serve(telegram)

    # --- requests ---------------------------------------------------------------------------

    def _repeated(self, telegram: DataTelegram) -> Telegram | None:
        memory = self._memory
        if (
            memory is None
            or not telegram.frame_count_valid
            or memory.source != telegram.source
            or memory.frame_count_bit is not telegram.frame_count_bit
            or memory.power_ons != self.slave.power_ons
        ):
            return None
        self._heard(telegram.source)
        return memory.answer

    def _serve(self, telegram: DataTelegram) -> Telegram:
        answer = self._service(telegram)
        counted = telegram.frame_count_valid or telegram.frame_count_bit
        self._memory = (
            _Memory(telegram.source, telegram.frame_count_bit, self.slave.power_ons, answer)
            if counted
            else None
        )
        self._heard(telegram.source)
        return answer

    def _service(self, telegram: DataTelegram) -> Telegram:
        data: bytes | None = None
        if telegram.destination_sap is None and telegram.source_sap is None:
            return self._data_exchange(telegram)
        if telegram.source_sap == MASTER_SAP:
            match telegram.destination_sap:
                case SlaveSap.SET_PRM:
                    parameters = decode_parameters(telegram.data)
                    taken = self.slave.set_prm(parameters, telegram.source)
                    return _acknowledged(telegram, taken)
                case SlaveSap.CHK_CFG:
                    taken = self._own(telegram.source) and self.slave.chk_cfg(telegram.data)
                    return _acknowledged(telegram, taken)
                case sap if sap in _EMPTY_REQUESTS and not telegram.data:
                    data = self._read(telegram)
        if data is None:
            return _reply(telegram, ReplyFunction.NO_SERVICE)
        return _reply(telegram, ReplyFunction.DATA_LOW, data)

    def _read(self, telegram: DataTelegram) -> bytes | None:
        slave = self.slave
        match telegram.destination_sap:
            case SlaveSap.SLAVE_DIAG:
                if self._own(telegram.source):
                    slave.diagnosis_fetched()
                return slave.slave_diag()
            case SlaveSap.GET_CFG:
                return slave.get_cfg()
            case SlaveSap.RD_INP:
                return slave.rd_inp()
            case _:
                return slave.rd_outp()

    def _data_exchange(self, telegram: DataTelegram) -> Telegram:
        slave = self.slave
        inputs = slave.data_exchange(telegram.data) if self._own(telegram.source) else None
        if inputs is None:
            return _reply(telegram, ReplyFunction.NO_SERVICE)
        if slave.diagnosis_waiting:
            return _reply(telegram, ReplyFunction.DATA_HIGH, inputs)
        if not inputs:
            return ShortAcknowledgement()
        return _reply(telegram, ReplyFunction.DATA_LOW, inputs)

    def _global_control(self, telegram: DataTelegram) -> None:
        if (
            telegram.destination_sap == SlaveSap.GLOBAL_CONTROL
            and telegram.source_sap == MASTER_SAP
            and len(telegram.data) == _CONTROL_BYTES
            and self._own(telegram.source)
        ):
            command, groups = telegram.data
            self.slave.global_control(command, groups)

    def _own(self, source: int) -> bool:
        return source == self.slave.master_address

    # --- watchdog ---------------------------------------------------------------------------

    def _heard(self, source: int) -> None:
        """The slave's master is there. One event watches, however often it is heard."""
        parameters = self.slave.parameters
        if parameters is None or parameters.watchdog_ns is None or not self._own(source):
            return
        self._heard_ns = self._kernel.now_ns
        self._look_at(self._heard_ns + parameters.watchdog_ns)

    def _look_at(self, due_ns: int) -> None:
        if self._look is not None:
            if self._look[0] <= due_ns:
                return
            self._kernel.cancel(self._look)
        self._look = self._kernel.at(due_ns, self._watch)

    def _watch(self) -> None:
        self._look = None
        parameters = self.slave.parameters
        if parameters is None or parameters.watchdog_ns is None:
            return
        due_ns = self._heard_ns + parameters.watchdog_ns
        if due_ns > self._kernel.now_ns:
            self._look_at(due_ns)
        else:
            self.slave.polling_ended(self._heard_ns)


def _acknowledged(request: DataTelegram, taken: bool) -> Telegram:
    return ShortAcknowledgement() if taken else _reply(request, ReplyFunction.NO_SERVICE)


def _reply(request: DataTelegram, function: ReplyFunction, data: bytes | None = None) -> Telegram:
    """The access points of the request, the other way round, if there are data."""
    if data is None:
        return DataTelegram(request.source, request.destination, function)
    return DataTelegram(
        request.source,
        request.destination,
        function,
        data,
        request.source_sap,
        request.destination_sap,
    )
