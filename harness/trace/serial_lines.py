"""What is recorded of a serial line of the PLC: its communication module, and all frames."""

from typing import TYPE_CHECKING

from fbgen.plant import SerialLine
from harness.trace.frame_meanings import FrameMeanings
from harness.trace.frames import FrameWatch
from harness.trace.log import ChangeLog
from harness.trace.modbus_meanings import ModbusMeanings
from harness.trace.model import Channel

if TYPE_CHECKING:
    from harness.installation import Installation


class SerialLineWatch:
    """Looks at the module of one line behind each scan, and at what goes over the line."""

    def __init__(self, log: ChangeLog, plant: "Installation", entry: SerialLine) -> None:
        self._log = log
        self._kernel = plant.kernel
        self._module = plant.devices.modules[entry.name]
        name, path = entry.name, f"line.{entry.name}"
        self._available = log.add(
            Channel(f"{path}.available", "the module answers the CPU", "bool", "line", name)
        )
        self._lost = log.add(
            Channel(f"{path}.lost_messages", "messages without room", "integer", "line", name)
        )
        series = {item.inv_no: plant.catalog.drive(item.series) for item in entry.drives}
        meanings: FrameMeanings | ModbusMeanings = ModbusMeanings(series)
        if entry.family == "toshiba":
            meanings = FrameMeanings(series, plant.catalog, ("request", "reply"))
        ports = {plant.drives[item.name].communication.port: item.name for item in entry.drives}
        line, port = plant.lines[name], self._module.port
        self.frames = FrameWatch(line, name, port, ports, meanings)
        self.look()

    def look(self) -> None:
        """Note the module as it is now."""
        now_ns = self._kernel.now_ns
        self._log.note(self._available, now_ns, self._module.available)
        self._log.note(self._lost, now_ns, self._module.lost_messages)
