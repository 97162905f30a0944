"""A page for each protocol on the inverters' line: frames, commands, errors."""

from collections.abc import Iterator

from fbgen.catalog import ModbusProtocol, Protocol, ToshibaProtocol
from fbgen.docs.document import Facts, Page, Phrase, Row, Section, Table
from fbgen.docs.page_names import protocol_page
from fbgen.docs.sources import Sources
from fbgen.docs.subject import Subject
from fbgen.docs.texts import code

GROUP = "Protocols"
_COMMAND_COLUMNS = (
    *("Code", "Letter", "What it does", "Forms", "Broadcast"),
    *("Reply", "Reply while tripped", "Source"),
)


def protocol_pages(subject: Subject) -> Iterator[Page]:
    """One page each."""
    for protocol in subject.protocols.values():
        sources = Sources()
        sections = [Section("Characters", (_characters(protocol, sources),), "characters")]
        if isinstance(protocol, ToshibaProtocol):
            sections += _toshiba(protocol, sources)
        elif isinstance(protocol, ModbusProtocol):
            sections += _modbus(protocol, sources)
        lead: Phrase = (protocol.description or protocol.title,)
        title = protocol.title
        sections += sources.sections()
        yield Page(protocol_page(protocol.id), title, GROUP, lead, tuple(sections), title)


def _characters(protocol: Protocol, sources: Sources) -> Facts:
    character = protocol.character
    parities = ", ".join(character.parities)
    return Facts(
        (
            ("Data bits", (str(character.data_bits),)),
            ("Parity", (f"{parities}; usual: {character.default_parity}",)),
            ("Stop bits", (_stop_bits(protocol),)),
            ("Bit/s", (", ".join(map(str, protocol.baud_rates)),)),
            ("Source", sources.of(character.source, character.status)),
        )
    )


def _stop_bits(protocol: Protocol) -> str:
    character = protocol.character
    return f"the inverter wants {character.received_stop_bits} and sends {character.sent_stop_bits}"


def _toshiba(protocol: ToshibaProtocol, sources: Sources) -> Iterator[Section]:
    frames = tuple(
        Row(
            (
                (frame.title,),
                (frame.mode,),
                (frame.direction,),
                (
                    " ".join(
                        f"[{item}]" if item in frame.optional else item for item in frame.fields
                    ),
                ),
                (", ".join(map(str, frame.lengths)),),
                sources.of(frame.source, frame.status),
            ),
            f"frame-{frame.name}",
            f"{protocol.id} frame {frame.name} {frame.title}",
        )
        for frame in protocol.frames
    )
    columns = ("Frame", "Form", "Direction", "Fields, optional ones in brackets", "Bytes", "Source")
    yield Section("Frames", (Table(columns, frames),), "frames")
    commands = tuple(
        Row(
            (
                code(f"{command.code:02X}"),
                code(command.letter),
                (command.title,),
                (", ".join(command.modes),),
                ("yes" if command.broadcast else "no",),
                code(f"{command.reply_code:02X}") if command.reply_code is not None else ("none",),
                code(f"{command.tripped_reply_code:02X}")
                if command.tripped_reply_code is not None
                else (),
                sources.of(command.source, command.status),
            ),
            f"command-{command.name}",
            f"{protocol.id} command {command.letter} {command.code:02X} {command.title}",
        )
        for command in protocol.commands
    )
    yield Section("Commands", (Table(_COMMAND_COLUMNS, commands),), "commands")
    errors = tuple(
        Row(
            (
                code(f"{item.code:04X}"),
                (item.title,),
                (", ".join(item.modes),),
                sources.of(item.source, item.status),
            ),
            f"error-{item.name}",
            f"{protocol.id} error {item.code:04X} {item.title}",
        )
        for item in protocol.errors
    )
    yield Section("Errors", (Table(("Code", "Meaning", "Forms", "Source"), errors),), "errors")


def _modbus(protocol: ModbusProtocol, sources: Sources) -> Iterator[Section]:
    functions = tuple(
        Row(
            (
                code(f"{item.code:02X}"),
                (item.title,),
                (str(item.most_read or ""),),
                (str(item.most_written or ""),),
                ("yes" if item.broadcast else "no",),
                sources.of(item.source, item.status),
            ),
            f"function-{item.name}",
            f"{protocol.id} function {item.code:02X} {item.title}",
        )
        for item in protocol.functions
    )
    columns = ("Code", "Function", "Most words read", "Most words written", "Broadcast", "Source")
    yield Section("Functions", (Table(columns, functions),), "functions")
    exceptions = tuple(
        Row(
            (code(f"{item.code:02X}"), (item.title,), sources.of(item.source, item.status)),
            f"exception-{item.name}",
            f"{protocol.id} exception {item.code:02X} {item.title}",
        )
        for item in protocol.exceptions
    )
    yield Section("Exceptions", (Table(("Code", "Meaning", "Source"), exceptions),), "exceptions")
