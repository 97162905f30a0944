"""How one inverter of a plant is set up."""

from collections.abc import Mapping
from dataclasses import field
from typing import Literal

from fbgen.catalog import Drive
from fbgen.catalog.communication import Parity as CatalogParity
from fbgen.dataclass import dataclass
from fbgen.diagnostics import error
from harness.drives.load import Load, Motor, Rating
from harness.kernel import NS_PER_MS

TimeoutRestart = Literal["any_answered", "writes"]


@dataclass(frozen=True, slots=True)
class ReplyTime:
    """Time from the end of a request to the begin of the reply, drawn evenly between the two.

    The default minimum follows from the 30 to 40 ms that the TOSPBDP001 manual, section 9, gives
    for the whole way, of which the line and the gateway take 20 ms.
    """

    minimum_ns: int = 10 * NS_PER_MS
    maximum_ns: int = 20 * NS_PER_MS


@dataclass(frozen=True, slots=True)
class InverterSettings:
    """What differs from a new inverter.

    `parameters` are physical values by ComNo or name of the catalogue, stored in the EEPROM before
    the plant starts. `rotary_switch` is SW5 of the RS4003Z board: unless it is 0 it gives the
    INV-NO instead of F802. `port` is the one at the line, by its name in the catalogue; None is the
    first. `timeout_restart` is an option of the catalogue, `options` are those that are flags and
    set, such as broadcast_reads.
    """

    name: str = "drive"
    parameters: Mapping[str, float] = field(default_factory=dict)
    motor: Motor = field(default_factory=Motor)
    load: Load = field(default_factory=Load)
    rating: Rating = field(default_factory=Rating)
    reply_time: ReplyTime = field(default_factory=ReplyTime)
    rotary_switch: int = 0
    port: str | None = None
    timeout_restart: TimeoutRestart = "any_answered"
    options: frozenset[str] = frozenset()


def set_for_line(
    series: Drive, port: str | None, baud: int, parity: CatalogParity
) -> dict[str, float]:
    """Parameters that set a port to a speed and parity; None is the first port.

    DiagnosticError FB7104 for a port or a speed that the series does not have.
    """
    known = series.communication
    ports = () if known is None else known.ports
    facts = next((item for item in ports if port in (None, item.name)), None)
    if facts is None:
        names = ", ".join(item.name for item in ports)
        raise error(
            "FB7104",
            f"the series '{series.id}' has no " + (f"port '{port}'" if port else "serial port"),
            series.span,
            f"its ports: {names or 'none'}",
        )
    rates = {rate: code for code, rate in series.baud_rates(facts).items()}
    parities = {meaning: code for code, meaning in series.parities(facts).items()}
    if baud not in rates or parity not in parities:
        raise error(
            "FB7104",
            f"the port '{facts.name}' of the series '{series.id}' has no {baud} bit/s with parity "
            f"{parity}",
            facts.span,
            "its rates: " + ", ".join(map(str, rates)) + "; parities: " + ", ".join(parities),
        )
    return {
        facts.baud_rate: series.comno(facts.baud_rate).to_value(rates[baud]),
        facts.parity: series.comno(facts.parity).to_value(parities[parity]),
    }
