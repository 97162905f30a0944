"""What a series can do on the wire: ports, protocols, telegrams, MODBUS accesses, drive to drive.

The protocols themselves are entries of their own; here stands what one series takes of them and
where it differs. Names are those of the series' ComNos, of the protocol's commands, functions and
exceptions. How long it takes to answer, to boot and to reset stands in `times`. A field that rests
on no document although its part does is named in `unverified`.
"""

import re
from collections.abc import Collection, Iterable, Iterator, Mapping
from types import MappingProxyType
from typing import Annotated, Literal

from pydantic import Field

from fbgen.catalog.located import Located
from fbgen.catalog.named import no_duplicates, unknown_name
from fbgen.catalog.protocols import Mode
from fbgen.catalog.scalars import (
    Count,
    EntryId,
    Flag,
    HexByte,
    HexWord,
    Number,
    Real,
    SnakeName,
    Text,
)
from fbgen.catalog.sourced import Sourced, unknown_fields
from fbgen.diagnostics import Diagnostic, Note

Parity = Literal["none", "even", "odd"]
TimeoutAction = Literal["nothing", "alarm", "trip"]
Cause = Literal[
    "unknown_function", "unknown_comno", "wrong_quantity", "wrong_data", "not_executable",
]  # fmt: skip
"""Why a MODBUS request is not served."""


class Part(Sourced):
    """A part of the communication. `unverified` lists fields that rest on no document."""

    unverified: tuple[SnakeName, ...] = ()
    remark: Text | None = None

    def problems(self) -> Iterable[Diagnostic]:
        """FB1103 no source; FB1105 an unverified field that is none."""
        yield from super().problems()
        yield from unknown_fields(self, self.unverified)


class SerialPort(Part):
    """A serial port, by the names of its ComNos.

    `wires`: 2 or 4; None where it is a port for a converter. `command` and `setpoint` are the
    ComNos that a master writes through this port, of which `setpoint` is also what drive to drive
    telegrams carry; `command_2` is the second command word. `timeout_actions`: value of the ComNo
    `timeout_action` -> what this port does when its time-out is over; without it it trips.
    `protocols`: value of the ComNo `protocol` -> id of the protocol; with one protocol only, there
    is no such ComNo.
    """

    name: SnakeName
    title: Text
    wires: Literal[2, 4] | None = None
    command: SnakeName
    setpoint: SnakeName
    baud_rate: SnakeName
    parity: SnakeName
    inv_no: SnakeName
    timeout: SnakeName
    command_2: SnakeName | None = None
    timeout_action: SnakeName | None = None
    timeout_actions: dict[Number, TimeoutAction] = Field(default_factory=dict)
    send_waiting_time: SnakeName | None = None
    inter_drive: SnakeName | None = None
    protocol: SnakeName | None = None
    protocols: dict[Number, EntryId]

    def problems(self) -> Iterable[Diagnostic]:
        """FB1103; FB1105; FB1115 several protocols, or actions, and nothing that chooses."""
        yield from super().problems()
        if len(self.protocols) != 1 and self.protocol is None:
            yield Diagnostic(
                "FB1115",
                f"the port '{self.name}' has {len(self.protocols) or 'no'} protocols and names no "
                "ComNo that chooses",
                self.span_of("protocols"),
                "add protocol: with the name of the ComNo, or leave one protocol",
            )
        if self.timeout_actions and self.timeout_action is None:
            yield Diagnostic(
                "FB1115",
                f"the port '{self.name}' has actions of a time-out and nothing that chooses",
                self.span_of("timeout_actions"),
                "add timeout_action: with the name of the ComNo",
            )


class Blocks(Part):
    """Block transfer: ComNos that say which words are written and read together, in their order.

    `write_choices` and `read_choices`: value of such a ComNo -> name of the ComNo that it stands
    for; 0 stands for none.
    """

    write: tuple[SnakeName, ...]
    read: tuple[SnakeName, ...]
    write_choices: dict[Number, SnakeName]
    read_choices: dict[Number, SnakeName]


class ToshibaService(Part):
    """What a series takes of the Toshiba inverter protocol.

    `frame_end`: a telegram ends with the bytes that its command wants, or by silence of
    `silence_characters`. `reception_timeout_ms`: after that an unfinished telegram is dropped.
    `groups`: ASCII telegrams reach several inverters by one digit (`*2`, `1*`).
    """

    forms: tuple[Mode, ...]
    commands: tuple[SnakeName, ...]
    frame_end: Literal["length", "silence"]
    silence_characters: Annotated[Real, Field(gt=0)] | None = None
    reception_timeout_ms: Count | None = None
    max_frame_bytes: Count | None = None
    groups: Flag

    def problems(self) -> Iterable[Diagnostic]:
        """FB1103; FB1105; FB1115 an end by silence of unknown length, or the reverse."""
        yield from super().problems()
        if (self.frame_end == "silence") is (self.silence_characters is None):
            yield Diagnostic(
                "FB1115",
                "the silence that ends a telegram is not given"
                if self.silence_characters is None
                else "a telegram that ends by its length ends by no silence",
                self.span_of("frame_end"),
                "frame_end: silence goes with silence_characters:, frame_end: length without",
            )


class ModbusAccess(Part):
    """One use of a MODBUS function.

    `way`: `direct` for the ComNos that the request names; `indirect` for those that the ComNos of
    `blocks` stand for; `identification` for texts. The quantities are words. `starts` are the only
    start addresses, where not every one will do. `keeps` says where what is written stays. With an
    `option` of the drive, the use is there only if that is set.
    """

    function: SnakeName
    way: Literal["direct", "indirect", "identification"]
    least_read: Count = 0
    most_read: Count = 0
    least_written: Count = 0
    most_written: Count = 0
    starts: tuple[HexWord, ...] = ()
    keeps: Literal["ram", "eeprom", "nothing"] = "nothing"
    option: SnakeName | None = None

    def problems(self) -> Iterable[Diagnostic]:
        """FB1103; FB1105; FB1114 quantities that contradict each other or the way."""
        yield from super().problems()
        least, most = self.least_read + self.least_written, self.most_read + self.most_written
        if self.least_read > self.most_read or self.least_written > self.most_written:
            message = "the least number of words is greater than the greatest"
        elif (self.way == "identification") is not (most == 0):
            message = f"an access with the way '{self.way}' cannot have {most} words"
        elif most and not least:
            message = "an access of no words is none"
        elif (self.most_written > 0) is (self.keeps == "nothing"):
            message = "what is written must stay somewhere, and only that"
        else:
            return
        yield Diagnostic(
            "FB1114", f"'{self.function}': {message}", self.span, "mend the quantities or keeps:"
        )

    def told(self) -> str:
        """What tells it from the others of its function."""
        return f"{self.function} {self.way} from {self.least_read + self.least_written} words on"


class Identification(Part):
    """The texts of the identification, basic level, with the conformity level of its reply."""

    conformity: HexByte
    vendor: Text
    product: Text
    revision: Text


class ModbusService(Part):
    """What a series takes of MODBUS-RTU.

    `exceptions`: cause -> name of the exception. `missing_reads_as`: what a ComNo that is not there
    gives within a block; None where that is an error.
    """

    accesses: tuple[ModbusAccess, ...]
    exceptions: dict[Cause, SnakeName]
    missing_reads_as: HexWord | None = None
    identification: Identification | None = None

    def problems(self) -> Iterable[Diagnostic]:
        """FB1102 one use of a function twice; FB1103; FB1105; FB1114 texts that nobody reads."""
        yield from super().problems()
        uses = self.accesses
        yield from no_duplicates(uses, "function", ModbusAccess.told, "access")
        asked = any(use.way == "identification" for use in uses)
        if asked is (self.identification is None):
            message = "texts of an identification go with an access to them"
            yield Diagnostic("FB1114", message, self.span, "give both or none")


class Role(Located):
    """What an inverter does on the line of its own accord: send as a master, or follow one."""

    role: Literal["master", "slave"]
    title: Text
    sends: SnakeName | None = None
    on_master_trip: Literal["zero", "keep", "trip"] | None = None

    def problems(self) -> Iterable[Diagnostic]:
        """FB1115: a master that sends nothing, a slave that does."""
        if (self.role == "master") is (self.sends is None) or (
            (self.role == "slave") is (self.on_master_trip is None)
        ):
            yield Diagnostic(
                "FB1115",
                f"this is no complete {self.role}",
                self.span_of("role"),
                "a master has sends:, a slave has on_master_trip:",
            )


class InterDrive(Part):
    """Drive to drive: value of a port's ComNo `inter_drive` -> what the inverter then does.

    A master sends the command S, s while it is tripped, again and again; a slave takes its value as
    parts of `full_scale` of its maximum frequency, through the points of F811 to F814.
    """

    roles: dict[Number, Role]
    full_scale: Count


class Communication(Located):
    """What a series can do on the wire."""

    ports: tuple[SerialPort, ...] = ()
    blocks: Blocks | None = None
    toshiba: ToshibaService | None = None
    modbus: ModbusService | None = None
    inter_drive: InterDrive | None = None

    def problems(self) -> Iterable[Diagnostic]:
        """FB1102 a port twice; FB1115 two ports with one command word, blocks that are missing."""
        yield from no_duplicates(self.ports, "name", lambda item: item.name, "port")
        first: dict[str, SerialPort] = {}
        for port in self.ports:
            other = first.setdefault(port.command, port)
            if other is not port:
                yield Diagnostic(
                    "FB1115",
                    f"the ports '{other.name}' and '{port.name}' have one command word",
                    port.span_of("command"),
                    "give each port the ComNo that is written through it",
                    (Note("first here", other.span_of("command")),),
                )
        if self.blocks is None and self.modbus is not None:
            for use in self.modbus.accesses:
                if use.way == "indirect":
                    message = "an indirect access needs the ComNos that choose the words"
                    yield Diagnostic("FB1115", message, use.span_of("way"), "add blocks:")

    def port(self, name: str) -> SerialPort | None:
        """The port of a name, None if there is none."""
        return next((port for port in self.ports if port.name == name), None)

    def unknown_options(self, ids: Collection[str]) -> Iterator[Diagnostic]:
        """FB1105 for every option that the series does not have."""
        for use in () if self.modbus is None else self.modbus.accesses:
            yield from unknown_name(use, "option", use.option, ids, "option")

    def unknown_comnos(self, names: Collection[str]) -> Iterator[Diagnostic]:
        """FB1105 for every name that is no ComNo of the series."""
        for port in self.ports:
            for field in _PORT_COMNOS:
                yield from unknown_name(port, field, getattr(port, field), names, "ComNo")
        if self.blocks is not None:
            for field in ("write", "read"):
                for name in getattr(self.blocks, field):
                    yield from unknown_name(self.blocks, field, name, names, "ComNo")
                for name in getattr(self.blocks, f"{field}_choices").values():
                    yield from unknown_name(self.blocks, f"{field}_choices", name, names, "ComNo")
        if self.inter_drive is not None:
            for role in self.inter_drive.roles.values():
                yield from unknown_name(role, "sends", role.sends, names, "ComNo")


_PORT_COMNOS = (
    *("command", "setpoint", "baud_rate", "parity", "inv_no", "timeout", "timeout_action"),
    *("send_waiting_time", "inter_drive", "protocol", "command_2"),
)

_PARITIES: Mapping[str, Parity] = MappingProxyType({"none": "none", "even": "even", "odd": "odd"})
_RATE = re.compile(r"([0-9]{3,6}) bit/s")


def baud_rate_of(text: str) -> int | None:
    """The rate that a value of a ComNo means, written as `19200 bit/s`; None for another text."""
    match = _RATE.fullmatch(text)
    return int(match[1]) if match else None


def parity_of(text: str) -> Parity | None:
    """The parity that a value of a ComNo means; None for another text."""
    return _PARITIES.get(text)
