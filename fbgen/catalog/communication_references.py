"""What a series says of its communication against the protocols: is there so much?"""

from collections.abc import Collection, Iterator
from typing import TYPE_CHECKING

from fbgen.catalog.communication import Communication, ModbusAccess, ModbusService, ToshibaService
from fbgen.catalog.drives import Drive
from fbgen.catalog.modbus_protocol import ModbusProtocol
from fbgen.catalog.named import named_in
from fbgen.catalog.protocols import ToshibaProtocol
from fbgen.diagnostics import Diagnostic

if TYPE_CHECKING:
    from fbgen.catalog.catalog import Catalog


def unresolved_communication(
    drive: Drive, communication: Communication, catalog: "Catalog", protocols: Collection[str]
) -> Iterator[Diagnostic]:
    """FB1105 for names that nothing has; FB1113, FB1114 and FB1115 for what cannot be.

    `protocols` are the ids that are known, those of files that could not be read included.
    """
    spoken = set[str]()
    for port in communication.ports:
        rates = set(drive.baud_rates(port).values())
        for name in port.protocols.values():
            yield from named_in(port, "protocols", name, protocols, "protocol")
            spoken.add(name)
            known = catalog.protocols.get(name)
            if known is not None and (strange := sorted(rates.difference(known.baud_rates))):
                yield Diagnostic(
                    "FB1113",
                    f"the protocol '{name}' knows no {', '.join(map(str, strange))} bit/s, which "
                    f"'{port.baud_rate}' of '{drive.id}' has",
                    port.span_of("baud_rate"),
                    "add the rate to baud_rates: of the protocol, or mend the values of the ComNo",
                )
    for name in spoken:
        protocol = catalog.protocols.get(name)
        if isinstance(protocol, ToshibaProtocol):
            yield from _service(drive, communication.toshiba, "toshiba", name)
            if communication.toshiba is not None:
                yield from _toshiba(communication.toshiba, protocol)
        elif isinstance(protocol, ModbusProtocol):
            yield from _service(drive, communication.modbus, "modbus", name)
            if communication.modbus is not None:
                yield from _modbus(communication.modbus, protocol)


def _service(
    drive: Drive, service: ToshibaService | ModbusService | None, part: str, protocol: str
) -> Iterator[Diagnostic]:
    if service is None:
        message = f"a port of '{drive.id}' speaks '{protocol}', and nothing says what it can do"
        place = drive.communication.span if drive.communication is not None else drive.span
        yield Diagnostic("FB1115", message, place, f"add {part}: to communication:")


def _toshiba(service: ToshibaService, protocol: ToshibaProtocol) -> Iterator[Diagnostic]:
    known = {command.name: command for command in protocol.commands}
    for name in service.commands:
        yield from named_in(service, "commands", name, known, "command")
        command = known.get(name)
        if command is not None and not set(command.modes) & set(service.forms):
            yield Diagnostic(
                "FB1115",
                f"the command '{name}' has only the form {' and '.join(command.modes)}, which this "
                "series does not read",
                service.span_of("forms"),
                "add the form, or leave out the command",
            )


def _modbus(service: ModbusService, protocol: ModbusProtocol) -> Iterator[Diagnostic]:
    known = {function.name for function in protocol.functions}
    for use in service.accesses:
        yield from named_in(use, "function", use.function, known, "function")
        if use.function in known:
            yield from _quantities(use, protocol)
    exceptions = {item.name for item in protocol.exceptions}
    for name in service.exceptions.values():
        yield from named_in(service, "exceptions", name, exceptions, "exception")


def _quantities(use: ModbusAccess, protocol: ModbusProtocol) -> Iterator[Diagnostic]:
    function = protocol.function(use.function)
    for field, asked, most in (
        ("most_read", use.most_read, function.most_read),
        ("most_written", use.most_written, function.most_written),
    ):
        if asked > most:
            yield Diagnostic(
                "FB1114",
                f"the function {function.code:02X} '{function.name}' carries {most} words at most, "
                f"not {asked}",
                use.span_of(field),
                "give a number of words that a frame can hold",
            )
