"""What has to be set at an inverter on a serial line: rate, parity and protocol are the line's."""

from collections.abc import Iterator, Mapping

from fbgen.artefacts.view import PlantLists
from fbgen.blocks.serial_times import serial_times
from fbgen.catalog import Drive, Setting
from fbgen.plant import SerialLine, port_of


def serial_settings(lists: PlantLists, line: SerialLine, series: Drive) -> Iterator[Setting]:
    """The settings of a series on such a line; those of the port come from the plant file."""
    port = port_of(line, series)
    assert port is not None, "checked when the plant was read"
    as_line = lists.in_words(
        "as the line; takes effect after power off until the display is dark",
        "wie die Linie; wirkt, wenn die Versorgung aus war, bis die Anzeige dunkel war",
    )
    own = [
        (port.baud_rate, _code(series.baud_rates(port), line.baud), as_line),
        (port.parity, _code(series.parities(port), line.parity), as_line),
    ]
    heard = serial_times(lists.plant, line, lists.catalog).drive_timeout_s
    as_polled = lists.in_words(
        "longer than the line takes to ask all drives; a shorter one trips them",
        "länger, als die Linie braucht, alle Antriebe zu fragen; eine kürzere schaltet sie ab",
    )
    own.append((port.timeout, float(heard), as_polled))
    if port.protocol is not None:
        chosen = _code(dict(port.protocols), line.family)
        own.append((port.protocol, chosen, as_line))
    for name, value, why in own:
        yield Setting.model_construct(comno=name, value=value, why=why, source=port.source)
    of_port = {name for name, _, _ in own} | {"baud_rate", "parity", series.link.timeout}
    for setting in series.settings:
        if setting.comno not in of_port:
            yield setting


def _code(values: Mapping[int, object], wanted: object) -> float:
    return float(next(code for code, value in values.items() if value == wanted))
