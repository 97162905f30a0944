"""Entries of the catalogue as text for a person, for `fbgen catalog show`."""

from fbgen.catalog import (
    BranchStep,
    CheckStep,
    ComNo,
    Condition,
    Drive,
    Gateway,
    Manual,
    Protocol,
    ReadStep,
    RepeatStep,
    SettingsStep,
    Step,
    WaitStep,
    Word,
    WriteStep,
)
from fbgen.catalog import Sequence as CommandSequence
from fbgen.catalog.catalog import Entry
from fbgen.cli.entries.communication_text import communication_text
from fbgen.cli.entries.gateway_text import gateway_text, options_text, switches_text
from fbgen.cli.entries.protocol_text import protocol_text
from fbgen.cli.entries.word_tables import Sources, bits_text, source_list
from fbgen.cli.table import paragraph, table


def entry_text(entry: Entry) -> str:
    """Everything a person may want to know of an entry, with its sources at the end."""
    sources = Sources()
    head = f"{entry.id}: {entry.title} {sources.of(entry)}"
    parts = [head]
    if entry.description:
        parts.append(paragraph(entry.description))
    match entry:
        case Drive():
            parts += _drive(entry, sources)
        case Gateway():
            parts += gateway_text(entry, sources)
        case Protocol():
            parts += protocol_text(entry, sources)
        case CommandSequence():
            parts += _sequence(entry, sources)
        case Manual():
            parts += _findings(entry, sources)
    return "\n\n".join([*parts, source_list(sources.found)])


def part_text(path: str, part: Word | ComNo) -> str:
    """A word or a ComNo under the path by which it was asked for."""
    if isinstance(part, Word):
        return bits_text(path, part)
    sources = Sources()
    rows = [
        ["ComNo", f"{part.hex} {part.name}" + (f" ({part.display})" if part.display else "")],
        ["unit", f"{part.resolution:g} {part.unit} a count".replace("  ", " ")],
        ["range", _range(part)],
        ["default", "" if part.default is None else f"{part.default:g} {part.unit}".rstrip()],
        ["access", f"{_ACCESS[part.access]}, {part.storage.upper()}, {_EFFECT[part.effect]}"],
        ["remark", part.remark or ""],
        ["source", sources.of(part)],
        ["unverified", ", ".join(part.unverified)],
        *([f"value {value}", text] for value, text in part.values.items()),
    ]
    body = table(["field", part.title], [row for row in rows if row[1]])
    return f"{body}\n\n{source_list(sources.found)}"


_ACCESS = {"r": "read only", "w": "write only", "rw": "read and write"}
_EFFECT = {"at_once": "takes effect at once", "after_restart": "takes effect after a restart"}


def _drive(drive: Drive, sources: Sources) -> list[str]:
    times = [
        [name, f"{time.ms:g} ms", sources.of(time)]
        for name, time in (
            ("reply_max", drive.times.reply_max),
            ("boot", drive.times.boot),
            ("reset_silence", drive.times.reset_silence),
        )
    ]
    wire = communication_text(drive, sources)
    words = [[f"{drive.id}.{word.name}", sources.of(word), word.title] for word in drive.words]
    comnos = [
        [
            item.hex,
            item.name,
            item.display or "",
            item.access,
            item.storage,
            f"{item.resolution:g} {item.unit}".rstrip(),
            _range(item),
            sources.of(item),
            item.title,
        ]
        for item in drive.comnos
    ]
    trips = [
        [f"{trip.code:04X}", trip.display, sources.of(trip), trip.meaning] for trip in drive.trips
    ]
    headings = ["ComNo", "name", "panel", "access", "in", "count", "range", "source", "title"]
    return [
        table(["time", "value", "source"], times),
        *wire,
        table(["word", "source", "title"], words),
        table(headings, comnos),
        *_terminal_functions(drive, sources),
        table(["trip", "panel", "source", "meaning"], trips),
        *_settings(drive, sources),
        *switches_text(drive.switches, sources),
        *options_text(drive.options, sources),
    ]


def _terminal_functions(drive: Drive, sources: Sources) -> list[str]:
    rows = [
        [
            str(item.number),
            "" if item.inverted is None else str(item.inverted),
            item.name,
            sources.of(item),
            item.title,
        ]
        for item in drive.terminal_functions
    ]
    headings = ["terminal function", "inverted", "name", "source", "title"]
    return [table(headings, rows)] if rows else []


def _settings(drive: Drive, sources: Sources) -> list[str]:
    rows = [
        [
            drive.comno(item.comno).display or drive.comno(item.comno).hex,
            item.plant or ("-" if item.value is None else f"{item.value:g}"),
            sources.of(item),
            f"if {item.when}: {item.why}" if item.when else item.why,
        ]
        for item in drive.settings
    ]
    return [table(["set", "to", "source", "why"], rows)] if rows else []


def _sequence(sequence: CommandSequence, sources: Sources) -> list[str]:
    interface = [
        *(["input", item.name, item.type, item.unit, item.title] for item in sequence.parameters),
        *(["output", item.name, item.type, item.unit, item.title] for item in sequence.results),
    ]
    steps = [[str(number), *_step(step)] for number, step in enumerate(sequence.steps, start=1)]
    telegrams = [
        [str(item.step), item.output, item.input, sources.of(item)] for item in sequence.telegrams
    ]
    parts = [paragraph(sequence.does_not_protect), f"Series: {', '.join(sequence.series)}"]
    if interface:
        parts.append(table(["", "name", "type", "unit", "title"], interface))
    parts.append(table(["step", "does", "title"], steps))
    if telegrams:
        parts.append(table(["step", "from the PLC", "to the PLC", "source"], telegrams))
    return parts


def _findings(manual: Manual, sources: Sources) -> list[str]:
    parts = [f"About: {', '.join(manual.devices)}"]
    for item in manual.findings:
        head = f"{item.name} ({item.kind.replace('_', ' ')}) {sources.of(item)}"
        rows = [f"says:  {item.says}", f"taken: {item.taken}", f"why:   {item.why}"]
        parts.append("\n".join([head, *(paragraph(row) for row in rows)]))
    return parts


def _step(step: Step) -> tuple[str, str]:
    title = step.title or ""
    if isinstance(step, ReadStep):
        return f"read {step.read} into {step.into}", title
    if isinstance(step, WriteStep):
        if step.literal is not None:
            return f"write {step.write} = {step.literal:04X}", title
        if step.parameter is not None:
            return f"write {step.write} = {step.parameter}", title
        bits = [*(step.bits or ()), *(f"{bit}={name}" for bit, name in step.bits_from.items())]
        return f"write {step.write} = {' '.join(bits) or '0000'}", title
    if isinstance(step, CheckStep):
        wanted = "as its sheet says" if step.equals is None else f"{step.equals:g}"
        return f"check that {step.check} is {wanted}", title
    if isinstance(step, SettingsStep):
        return "check everything that the parameter sheet says", title
    if isinstance(step, WaitStep):
        return f"read {step.wait} until {_condition(step.until)}, {step.limit_ms} ms at most", title
    if isinstance(step, BranchStep):
        return f"if {step.branch} is {_condition(step.when)} go to {step.to}", title
    if isinstance(step, RepeatStep):
        return f"go back to {step.repeat}, {step.times} times in all", title
    delay = step.delay
    return f"wait {f'{delay.ms} ms' if delay.ms else delay.drive_time or delay.parameter}", title


def _condition(condition: Condition) -> str:
    numbers = [f"{name.replace('_', ' ')} {value:g}" for name, value in condition.numbers.items()]
    return " and ".join([*numbers, *(f"{bit}={value}" for bit, value in condition.bits.items())])


def _range(comno: ComNo) -> str:
    if comno.minimum is None and comno.maximum is None:
        return ""
    low = comno.to_value(comno.minimum_word)
    high = comno.to_value(comno.maximum_word)
    return f"{low:g}..{high:g}" + (f" (at most {comno.limited_by})" if comno.limited_by else "")
