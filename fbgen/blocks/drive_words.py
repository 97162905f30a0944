"""What the blocks are told of a series: words, ComNos and trips, and the protocol of its line."""

from fbgen.blocks.literals import SclText, byte, comno, milliseconds, source_text
from fbgen.blocks.trips import command_source, trip_literals
from fbgen.blocks.words import WordView
from fbgen.catalog import Catalog, Drive, SerialPort, origin
from fbgen.catalog.sourced import Duration


def drive_context(
    drive: Drive, catalog: Catalog, port: SerialPort | None = None
) -> dict[str, object]:
    """What the templates are told of a series; `port` is the one at the line, None the usual."""
    command, setpoint = drive.link.command, drive.link.setpoint
    if port is not None:
        command, setpoint = port.command, port.setpoint
    protocol = catalog.toshiba_protocol(drive.protocol)
    numbers = protocol.inv_numbers["binary"]
    ascii_numbers = protocol.inv_numbers["ascii"]
    read = protocol.command("read_padded")
    lower_case = (read.tripped_reply_code or 0) ^ (read.reply_code or 0)
    trip = drive.comno(drive.link.trip)
    status = drive.comno(drive.link.status)
    return {
        "protocol": {
            "broadcast": byte(int(numbers.broadcast, 16), origin("broadcast", numbers)),
            "inv_no_max": SclText(str(numbers.maximum), origin("inverter numbers", numbers)),
            "ascii_max": SclText(str(ascii_numbers.maximum), origin("inverter numbers", numbers)),
            "lower_case": byte(lower_case, origin("command G", read)),
            "upper_case": byte(0xFF ^ lower_case, origin("command G", read)),
            "error": byte(protocol.error_reply_code, origin("error reply", protocol)),
        },
        "command": {
            item.name: byte(item.code, origin(f"command {item.letter}", item, item.source or ""))
            for item in protocol.commands
        },
        "comno": {
            "trip": comno(trip),
            "status_word": comno(status),
            "setpoint": comno(drive.comno(setpoint)),
            "command_word": comno(drive.comno(command)),
            "output_frequency": comno(drive.comno(drive.link.output_frequency)),
            "output_current": comno(drive.comno(drive.link.output_current)),
            "trip_source": source_text(trip, trip.source),
            "command_source": command_source(drive),
        },
        "drive_command": WordView(drive.word(drive.comno(command).word or ""), drive.id),
        "drive_status": WordView(drive.word(drive.comno(drive.link.status).word or ""), drive.id),
        "reset_silence": duration_literal(drive.times.reset_silence, f"{drive.id} reset_silence"),
        "trips": [trip_literals(trip) for trip in drive.trips],
        "spacer": {
            "first": comno(trip),
            "second": comno(status),
            "third": comno(drive.comno(drive.link.output_frequency)),
        },
    }


def duration_literal(time: Duration, name: str) -> SclText:
    """A time of the catalogue."""
    return milliseconds(time.ms, origin(name, time, time.source or ""))
