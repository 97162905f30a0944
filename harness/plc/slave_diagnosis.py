"""DPNRM_DG (SFC13): the diagnosis of one DP slave, read over several calls.

Siemens, "System Software for S7-300/400 System and Standard Functions" (A5E00709327-01), 16.4: REQ
starts a job, which LADDR tells from others; RET_VAL is 7001 and BUSY 1 at first, 7002 and 1 while
it goes on, whatever REQ is then, and in the last call the length of the data. They are dropped, and
an error code comes, if RECORD is too short. The same order of values stands in the operation list
of VIPA SPEED7 (HB00 OPL_SP7, 14.1.11). That an S7-1500 reads a DP slave's diagnosis with it says
the manual of the CP 1542-5 (C79000-G8976-C326-03, 6.3).

Recalled: which code is for what (the manual refers to those of RD_REC), and 7000 where there is
nothing to do. Our own: a job takes two bus cycles, the telegram and its way to the CPU.
"""

from enum import IntEnum

from harness.engine.environment import Area
from harness.fieldbus import DpMaster, Station
from harness.kernel import Kernel
from harness.plc.consistent_data import takes_area
from harness.plc.settings import CpuSettings


class DiagnosisResult(IntEnum):
    """RET_VAL as an unsigned word, where it is no length."""

    NO_JOB = 0x7000
    STARTED = 0x7001
    UNDER_WAY = 0x7002
    NO_SUCH_SLAVE = 0x8090
    WRONG_TYPE = 0x8092
    TOO_SHORT = 0x80B1
    NO_ANSWER = 0x80C5


class SlaveDiagnosis:
    """The instruction on one CPU. `stations` go by LADDR."""

    __slots__ = ("_due_ns", "_kernel", "_master", "_settings", "stations")

    def __init__(self, kernel: Kernel, settings: CpuSettings, master: DpMaster) -> None:
        self._kernel = kernel
        self._settings = settings
        self._master = master
        self._due_ns: dict[int, int] = {}
        self.stations: dict[int, Station] = {}

    def forget(self) -> None:
        """The CPU starts: no job is under way."""
        self._due_ns.clear()

    def read(self, requested: bool, laddr: int, record: Area) -> tuple[int, bool]:
        """One call: RET_VAL, and whether the job goes on."""
        due_ns = self._due_ns.get(laddr)
        if due_ns is None:
            return self._begun(laddr, record) if requested else (DiagnosisResult.NO_JOB, False)
        if self._kernel.now_ns < due_ns:
            return DiagnosisResult.UNDER_WAY, True
        del self._due_ns[laddr]
        return self._answer(self.stations[laddr], record), False

    def _begun(self, laddr: int, record: Area) -> tuple[int, bool]:
        if laddr not in self.stations:
            return DiagnosisResult.NO_SUCH_SLAVE, False
        if not takes_area(record.type, self._settings):
            return DiagnosisResult.WRONG_TYPE, False
        first_ns = self._master.next_cycle_ns(self._kernel.now_ns)
        self._due_ns[laddr] = self._master.next_cycle_ns(first_ns)
        return DiagnosisResult.STARTED, True

    def _answer(self, station: Station, record: Area) -> int:
        if station.failed or not station.reached or self._master.halted:
            return DiagnosisResult.NO_ANSWER
        data = station.slave.slave_diag()
        if record.length < len(data):
            return DiagnosisResult.TOO_SHORT
        record.write(data)
        return len(data)
