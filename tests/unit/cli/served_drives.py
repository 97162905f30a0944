"""Three inverters at a pseudo terminal, served by a thread while a test runs commands."""

from collections.abc import Iterator
from contextlib import contextmanager
from threading import Event, Thread

from harness.drives import Inverter
from harness.serial import DriveServer, LineSetting, PseudoTerminal, ServedDrives, serve_drives
from tests.unit.serial.virtual_port import SETTING, drives


class Serving:
    """The name of the port, and the inverters by their names vf1 to vf3."""

    def __init__(self, port: str, served: ServedDrives) -> None:
        self.port = port
        self.served = served

    @property
    def drives(self) -> dict[str, Inverter]:
        return dict(self.served.drives)


@contextmanager
def serving(setting: LineSetting = SETTING, series: str = "vf-s11") -> Iterator[Serving]:
    """Served until the end."""
    port, over = PseudoTerminal(), Event()
    served = serve_drives(drives(1, 2, 3, series=series), setting, port, byte_times=True)
    server = DriveServer(served, port)
    thread = Thread(target=lambda: server.serve(lambda idle_s: not over.is_set()))
    thread.start()
    try:
        yield Serving(port.name, served)
    finally:
        over.set()
        thread.join()
        port.close()
