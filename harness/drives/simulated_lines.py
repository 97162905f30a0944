"""What of a series' communication the simulation has: one port, telegrams that end by length.

Anything else is refused, and an inverter that was told to speak MODBUS hears no Toshiba telegram.
"""

from fbgen.catalog import Drive, SerialPort
from fbgen.diagnostics import error
from harness.drives.registers import Registers


def check_line(series: Drive) -> None:
    """FB7104 for a series whose line the simulation does not have."""
    known = series.communication
    if known is None:
        return
    if len(known.ports) > 1:
        names = ", ".join(port.name for port in known.ports)
        what = f"it has several ports ({names})"
    elif known.toshiba is not None and known.toshiba.frame_end != "length":
        what = "its telegrams end by silence"
    else:
        return
    raise error(
        "FB7104",
        f"the series '{series.id}' cannot be simulated yet: {what}",
        known.span,
        "blocks can be generated for it; simulate a series with one port whose telegrams end by "
        "their length, such as vf-s11",
    )


def check_protocol(series: Drive, registers: Registers) -> None:
    """FB7104 for an inverter whose parameters ask for a protocol that is not simulated."""
    protocol = other_protocol(series, registers)
    if protocol is not None:
        raise error(
            "FB7104",
            f"an inverter of the series '{series.id}' cannot be simulated yet with the protocol "
            f"'{protocol}'",
            series.span,
            "leave the parameter that chooses the protocol at its default",
        )


def other_protocol(series: Drive, registers: Registers) -> str | None:
    """The protocol that the acting parameters ask for, None for the one that is simulated."""
    for port in _ports(series):
        if port.protocol is not None:
            protocol = port.protocols.get(registers.word(port.protocol), "")
            if protocol != series.protocol:
                return protocol
    return None


def _ports(series: Drive) -> tuple[SerialPort, ...]:
    return () if series.communication is None else series.communication.ports
