"""What is recorded of the CPU and of its DP master: modes and scans."""

from harness.kernel import Kernel
from harness.plc import Cpu
from harness.trace.log import ChangeLog
from harness.trace.model import Channel


class CpuWatch:
    """Notes the operating mode, the number of scans, and what the master sends.

    A scan counts from the instant at which its program is through.
    """

    def __init__(self, log: ChangeLog, kernel: Kernel, cpu: Cpu) -> None:
        self._log = log
        self._kernel = kernel
        self._cpu = cpu
        self._master = cpu.master
        self._mode = log.add(Channel("cpu.mode", "operating mode", "text", "cpu"))
        self._scans = log.add(Channel("cpu.scans", "scans since the start", "integer", "cpu"))
        self._sends = log.add(Channel("bus.mode", "what the master sends", "text", "bus"))
        cpu.on_mode.append(lambda _: self.look())
        cpu.master.on_mode.append(self.look)
        self.look()

    def look(self) -> None:
        """Note the modes as they are now."""
        now_ns = self._kernel.now_ns
        self._log.note(self._mode, now_ns, self._cpu.mode.name)
        self._log.note(self._scans, now_ns, self._cpu.scans)
        self._log.note(self._sends, now_ns, self._master.mode.name)

    def scanned(self) -> None:
        """The program of a scan is through."""
        self._log.note(self._scans, self._kernel.now_ns, self._cpu.scans)
