"""A protocol of the catalogue as text for a person."""

from fbgen.catalog import ModbusProtocol, Protocol, ToshibaProtocol
from fbgen.cli.entries.word_tables import Sources
from fbgen.cli.table import table


def protocol_text(protocol: Protocol, sources: Sources) -> list[str]:
    """The tables of a protocol, by its kind."""
    match protocol:
        case ToshibaProtocol():
            return _toshiba(protocol, sources)
        case ModbusProtocol():
            return _modbus(protocol, sources)
        case _:
            return []


def _toshiba(protocol: ToshibaProtocol, sources: Sources) -> list[str]:
    commands = [
        [f"{item.code:02X} '{item.letter}'", item.name, item.keeps, sources.of(item), item.title]
        for item in protocol.commands
    ]
    frames = [
        [item.name, item.mode, item.direction, sources.of(item), " ".join(item.fields)]
        for item in protocol.frames
    ]
    errors = [
        [f"{item.code:04X}", item.name, sources.of(item), item.title] for item in protocol.errors
    ]
    return [
        table(["command", "name", "keeps in", "source", "title"], commands),
        table(["frame", "mode", "direction", "source", "fields"], frames),
        table(["error", "name", "source", "title"], errors),
    ]


def _modbus(protocol: ModbusProtocol, sources: Sources) -> list[str]:
    functions = [
        [
            f"{item.code:02X}",
            item.name,
            str(item.most_read or "-"),
            str(item.most_written or "-"),
            "yes" if item.broadcast else "no",
            sources.of(item),
            item.title,
        ]
        for item in protocol.functions
    ]
    exceptions = [
        [f"{item.code:02X}", item.name, sources.of(item), item.title]
        for item in protocol.exceptions
    ]
    silences = [
        [
            name,
            f"{silence.characters:g}",
            f"{silence.fixed_us} us above {silence.fixed_above} bit/s",
            sources.of(silence),
        ]
        for name, silence in (
            ("between frames, at least", protocol.limits.frame_gap),
            ("within a frame, at most", protocol.limits.character_gap),
        )
    ]
    headings = ["function", "name", "reads", "writes", "broadcast", "source", "title"]
    return [
        table(headings, functions),
        table(["exception", "name", "source", "title"], exceptions),
        table(["silence", "characters", "but", "source"], silences),
    ]
