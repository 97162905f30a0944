"""Looks for inverters at a port: over numbers, speeds and parities."""

from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING, NamedTuple

from fbgen.cli.ports.talk_requests import Talking, questions
from fbgen.diagnostics import DiagnosticError, error
from fbgen.wire import modbus, toshiba

if TYPE_CHECKING:
    from harness.line import Parity
    from harness.serial import LineSetting, Port

_TIMEOUT_NS = 50_000_000
"""The inverters answer within 20 ms, those with a send waiting time of up to 30 ms too."""


class Found(NamedTuple):
    """An inverter that has answered, and with which setting; `refused` if with an error."""

    inv_no: int
    baud: int
    parity: str
    reply: bytes


def scan(
    settings: "Sequence[LineSetting]",
    numbers: Sequence[int],
    talking: Talking,
    opened: "Callable[[LineSetting], Port]",
    step: Callable[[str], None],
) -> Iterator[Found]:
    """Ask each number with each setting for its status; whoever answers is found."""
    from harness.serial import Asking, protocol_of

    key = talking.series.comno(talking.series.link.status).hex
    for setting in settings:
        port = opened(setting)
        try:
            asking = Asking(port, protocol_of(setting), setting.from_master, _TIMEOUT_NS)
            for number in numbers:
                step(f"{setting.baud} bit/s, parity {setting.parity.name.lower()}, INV-NO {number}")
                (question,) = questions(["read", str(number), key], talking)
                reply = asking.ask(question.frame).reply
                if reply is not None:
                    yield Found(number, setting.baud, setting.parity.name.lower(), reply)
        finally:
            port.close()


def scan_settings(
    chosen: "LineSetting", talking: Talking, baud: int | None, parity: "Parity | None"
) -> "list[LineSetting]":
    """The settings to try: all that the series has, the most likely first, or those asked for."""
    from harness.line import Parity
    from harness.serial import LineSetting, serial_port_of

    port = serial_port_of(talking.series)
    rates = [baud] if baud else sorted(talking.series.baud_rates(port).values(), reverse=True)
    known = talking.series.parities(port).values()
    parities = [parity] if parity else [Parity[name.upper()] for name in known]
    tried = [LineSetting(chosen.protocol, rate, kind) for rate in rates for kind in parities]
    return sorted(tried, key=lambda item: item != chosen)


def scan_numbers(text: str | None, protocol: str) -> list[int]:
    """The numbers of `--numbers 1-5,11`; else all that there can be. FB9050 for what is none."""
    lowest = 1 if protocol == "modbus" else 0
    highest = modbus.HIGHEST_ADDRESS if protocol == "modbus" else toshiba.HIGHEST_BINARY_INV_NO
    if text is None:
        return list(range(lowest, min(highest, 63) + 1))
    found: list[int] = []
    for part in text.split(","):
        low, _, high = part.partition("-")
        try:
            numbers = range(int(low), int(high or low) + 1)
        except ValueError:
            numbers = range(0)
        if not numbers or numbers[0] < lowest or numbers[-1] > highest:
            raise _no_numbers(part, lowest, highest)
        found += numbers
    return found


def _no_numbers(part: str, lowest: int, highest: int) -> DiagnosticError:
    message = f"--numbers: '{part}' is no INV-NO"
    return error("FB9050", message, None, f"write 11 or 1-5,11, from {lowest} to {highest}")
