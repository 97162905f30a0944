"""What a series can do on the wire as text for a person."""

from collections.abc import Iterator, Mapping

from fbgen.catalog import (
    Blocks,
    Communication,
    Drive,
    InterDrive,
    ModbusAccess,
    ModbusService,
    SerialPort,
    ToshibaService,
)
from fbgen.catalog.communication import Part
from fbgen.cli.entries.word_tables import Sources
from fbgen.cli.table import table


def communication_text(drive: Drive, sources: Sources) -> list[str]:
    """The tables of the communication of a series; none if its file says nothing."""
    known = drive.communication
    return [] if known is None else list(_tables(drive, known, sources))


def _tables(drive: Drive, known: Communication, sources: Sources) -> Iterator[str]:
    for port in known.ports:
        yield _facts(f"port {port.name}", port, _port(drive, port), sources)
    if known.toshiba is not None:
        yield _facts("Toshiba inverter protocol", known.toshiba, _toshiba(known.toshiba), sources)
    if known.modbus is not None:
        yield _facts("MODBUS-RTU", known.modbus, _modbus(known.modbus), sources)
        rows = [_access(access, sources) for access in known.modbus.accesses]
        headings = ["MODBUS function", "way", "reads", "writes", "keeps in", "starts"]
        yield table([*headings, "with", "source"], rows)
    if known.blocks is not None:
        yield _facts("block transfer", known.blocks, _blocks(known.blocks), sources)
    if known.inter_drive is not None:
        yield _facts("drive to drive", known.inter_drive, _roles(known.inter_drive), sources)


def _facts(title: str, part: Part, facts: dict[str, str], sources: Sources) -> str:
    rows = [[name, text] for name, text in facts.items() if text]
    rows += [["remark", part.remark]] if part.remark else []
    rows += [["unverified", ", ".join(part.unverified)]] if part.unverified else []
    return table([title, ""], [*rows, ["source", sources.of(part)]])


def _port(drive: Drive, port: SerialPort) -> dict[str, str]:
    choice = port.protocol
    protocols = [
        name if choice is None else f"{value} = {name}" for value, name in port.protocols.items()
    ]
    return {
        "title": port.title,
        "wires": "" if port.wires is None else str(port.wires),
        "command": " ".join([_comno(drive, port.command), _comno(drive, port.command_2)]).strip(),
        "set-point": _comno(drive, port.setpoint),
        "INV-NO": _comno(drive, port.inv_no),
        "rates": _codes(drive, port.baud_rate, drive.baud_rates(port)),
        "parities": _codes(drive, port.parity, drive.parities(port)),
        "time-out": _comno(drive, port.timeout),
        "at the time-out": " ".join([_comno(drive, port.timeout_action), _actions(port)]).strip(),
        "send waiting time": _comno(drive, port.send_waiting_time),
        "drive to drive": _comno(drive, port.inter_drive),
        "protocol": " ".join([_comno(drive, choice), ", ".join(protocols)]).strip(),
    }


def _actions(port: SerialPort) -> str:
    return ", ".join(f"{value} = {action}" for value, action in port.timeout_actions.items())


def _comno(drive: Drive, name: str | None) -> str:
    if name is None:
        return ""
    comno = drive.comno(name)
    return comno.display or comno.hex


def _codes(drive: Drive, name: str, meanings: Mapping[int, object]) -> str:
    values = ", ".join(f"{value} = {meaning}" for value, meaning in meanings.items())
    return f"{_comno(drive, name)} {values}"


def _toshiba(service: ToshibaService) -> dict[str, str]:
    by_silence = (
        f"by silence of {service.silence_characters:g} characters"
        if (service.silence_characters is not None)
        else "by the length that its command wants"
    )
    return {
        "forms": ", ".join(service.forms),
        "commands": ", ".join(service.commands),
        "a telegram ends": by_silence,
        "unfinished for": f"{service.reception_timeout_ms} ms"
        if service.reception_timeout_ms
        else "",
        "longest telegram": f"{service.max_frame_bytes} bytes" if service.max_frame_bytes else "",
        "groups": "yes" if service.groups else "no",
    }


def _modbus(service: ModbusService) -> dict[str, str]:
    missing, texts = service.missing_reads_as, service.identification
    return {
        "exceptions": ", ".join(f"{cause}: {name}" for cause, name in service.exceptions.items()),
        "missing ComNo": "" if missing is None else f"reads as {missing:04X} in a block",
        "identification": ""
        if texts is None
        else f"{texts.vendor} / {texts.product} / {texts.revision}",
    }


def _access(access: ModbusAccess, sources: Sources) -> list[str]:
    return [
        access.function,
        access.way,
        _quantity(access.least_read, access.most_read),
        _quantity(access.least_written, access.most_written),
        "" if access.keeps == "nothing" else access.keeps,
        " ".join(f"{start:04X}" for start in access.starts),
        access.option or "",
        sources.of(access),
    ]


def _quantity(least: int, most: int) -> str:
    if most == 0:
        return ""
    return str(most) if least == most else f"{least}..{most}"


def _blocks(blocks: Blocks) -> dict[str, str]:
    def choices(names: dict[int, str]) -> str:
        return ", ".join(f"{value} = {name}" for value, name in names.items())

    return {
        "writes what these name": ", ".join(blocks.write),
        "words to write": choices(blocks.write_choices),
        "reads what these name": ", ".join(blocks.read),
        "words to read": choices(blocks.read_choices),
    }


def _roles(inter_drive: InterDrive) -> dict[str, str]:
    return {str(value): role.title for value, role in inter_drive.roles.items()}
