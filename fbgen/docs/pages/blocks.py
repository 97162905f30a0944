"""A page for each block: interface, behaviour, states, status codes, what it uses, its call."""

from collections.abc import Iterator, Sequence

from fbgen.blocks.status_codes import STATUS_CODES
from fbgen.catalog import ProcessDataGateway, TelegramGateway
from fbgen.dataclass import dataclass
from fbgen.docs.blocks.calls import callable_blocks, example_calls
from fbgen.docs.blocks.reading import BlockText, read_block
from fbgen.docs.blocks.state_picture import state_picture
from fbgen.docs.blocks.states import StateMachine, state_machine
from fbgen.docs.document import (
    Block,
    Bullets,
    Code,
    Facts,
    Figure,
    Link,
    Page,
    Paragraph,
    Phrase,
    Row,
    Sample,
    Section,
    Strong,
    Table,
)
from fbgen.docs.page_names import block_page, comno_page, word_page
from fbgen.docs.program import PlantProgram
from fbgen.docs.subject import Subject
from fbgen.docs.texts import code
from fbgen.docs.usage import BitItem, Usage, Use
from fbgen.docs.usage.places import inside, nodes
from fbgen.lang import ast
from fbgen.lang.checked import Constant, Statement

GROUP = "Blocks"
_NO_SAFETY = "No safety function: people are protected by STO and by hard-wired terminals."
_FIRST_ERROR = 0x8000
_CODES_OF_GATEWAY = 0x8500


@dataclass(frozen=True, slots=True)
class _Shown:
    """A block with what its page is made of."""

    unit: ast.Block
    text: BlockText
    machine: StateMachine | None
    body: tuple[Statement, ...]
    calls: tuple[tuple[str, str], ...]
    uses: tuple[Use, ...]
    having: frozenset[str]


def block_pages(subject: Subject, usage: Usage) -> Iterator[Page]:
    """A page for each block that a program of the plant calls, each once."""
    by_block: dict[str, list[Use]] = {}
    for uses in usage.uses.values():
        for use in uses:
            by_block.setdefault(use.block, []).append(use)
    seen: set[str] = set()
    for program in subject.programs:
        calls = example_calls(program)
        having = _having(program, subject)
        for unit in callable_blocks(program.canonical.units):
            name = unit.name.name
            if name not in seen:
                seen.add(name)
                uses = tuple(by_block.get(name, ()))
                yield _page(_read(unit, program, calls[name], uses, having), program)


def _having(program: PlantProgram, subject: Subject) -> frozenset[str]:
    """What the plant has that brings status codes of its own."""
    gateways = [subject.catalog.gateways[one.type] for one in program.plant.gateways]
    lines = any(isinstance(one, TelegramGateway) for one in gateways)
    channels = any(isinstance(one, ProcessDataGateway) for one in gateways)
    found = {"lines": lines, "sequences": lines, "channels": channels, "parameters": channels}
    found |= {"serial": bool(program.plant.serial), "devicenet": bool(program.plant.devicenet)}
    return frozenset(name for name, there in found.items() if there)


def _read(
    unit: ast.Block,
    program: PlantProgram,
    calls: Sequence[tuple[str, str]],
    uses: tuple[Use, ...],
    having: frozenset[str],
) -> _Shown:
    text = read_block(unit)
    checked = program.canonical.program
    block = checked.blocks[unit.name.name.casefold()]
    body = checked.bodies[block]
    kept = (*text.kept, *text.parameters)
    machine = state_machine(block, body, kept)
    return _Shown(unit, text, machine, body, tuple(calls), uses, having)


def _page(shown: _Shown, program: PlantProgram) -> Page:
    name = shown.unit.name.name
    text = shown.text
    sections = [
        Section("In short", (Facts(tuple(_facts(shown, program))),), "facts"),
        Section("Interface", (_interface(text),), "interface"),
    ]
    if text.behaviour:
        paragraphs = tuple(Paragraph((one,)) for one in text.behaviour)
        sections.append(Section("What it does", paragraphs, "behaviour"))
    if shown.machine is not None:
        sections.append(_states(name, shown.machine))
    sections += _status_codes(shown)
    if shown.uses:
        sections.append(Section("What it uses", (_uses(shown.uses),), "uses"))
    sections.append(Section("Example call", tuple(_calls(shown.calls)), "call"))
    if text.facts:
        items = tuple[Phrase, ...]((fact,) for fact in text.facts)
        sections.append(Section("Sources", (Bullets(items),), "sources"))
    lead: Phrase = (f"{text.title}.",)
    return Page(block_page(name), name, GROUP, lead, tuple(sections), f"{name} {text.title}")


def _facts(shown: _Shown, program: PlantProgram) -> Iterator[tuple[str, Phrase]]:
    kind = "function block" if shown.unit.kind is ast.BlockKind.FUNCTION_BLOCK else "function"
    yield "Kind", (kind,)
    yield "Generated for", (f"plant {program.plant.name}",)
    for title, text in shown.text.notes:
        yield title, (text,)
    yield "Safety", (_NO_SAFETY,)


def _interface(text: BlockText) -> Table:
    rows = tuple(
        Row(
            ((one.direction,), code(one.name), code(one.type), code(one.default), (one.meaning,)),
            f"{one.direction.replace(' ', '-')}-{one.name}",
        )
        for one in text.parameters
    )
    return Table(("Direction", "Name", "Type", "Default", "Meaning"), rows)


def _states(name: str, machine: StateMachine) -> Section:
    rows = []
    for number, one in enumerate(machine.transitions, start=1):
        begin = (
            "every state"
            if machine.is_any(one)
            else "; ".join(machine.name(state) for state in one.sources)
        )
        end: Phrase = (
            (machine.name(one.target),) if one.target is not None else (Code(one.worked_out),)
        )
        rows.append(Row(((str(number),), (begin,), end, (Code(one.condition),))))
    lead: Phrase = (
        "Drawn from the code: what is set to ",
        Code(machine.variable),
        ", and where. Several of them can follow each other in one call.",
    )
    blocks: tuple[Block, ...] = (
        Paragraph(lead),
        Figure(state_picture(machine), f"The states of {name} and the ways between them"),
        Table(("Way", "From", "To", "When"), tuple(rows)),
    )
    return Section("States", blocks, "states")


def _status_codes(shown: _Shown) -> Iterator[Section]:
    set_here = _codes_in(shown.body)
    rows = []
    for item in STATUS_CODES:
        of_gateway = _CODES_OF_GATEWAY in set_here and item.codes[0] >> 8 == _CODES_OF_GATEWAY >> 8
        none = set_here.isdisjoint(item.codes) and not of_gateway
        if none or not item.can_come(shown.having):
            continue
        cells = (code(item.text), (item.english,), (item.remedy,))
        rows.append(Row(cells))
    if any(one >= _FIRST_ERROR for one in set_here):
        table = Table(("Status", "Meaning", "What to do"), tuple(rows))
        yield Section("Status codes", (table,), "status-codes")


def _codes_in(body: Sequence[Statement]) -> set[int]:
    """The codes that stand in the text itself, not as a value of the catalogue."""
    known = {one for item in STATUS_CODES for one in item.codes}
    found = set()
    for node in nodes(tuple(body)):
        if isinstance(node, Constant) and isinstance(value := inside(node), Constant):
            origin = value.span.origin
            written = origin is None or origin.is_template
            if written and isinstance(value.value, int) and value.value in known - {0}:
                found.add(value.value)
    return found


def _uses(uses: Sequence[Use]) -> Table:
    rows: dict[tuple[str, Link, str], list[int]] = {}
    for use in uses:
        item = use.item
        if isinstance(item, BitItem):
            name = f"{item.device}.{item.word}.{item.bit}"
            link = Link(name, word_page(item.device, item.word), f"bit-{item.bit}")
            what = "bit"
        else:
            number = f"{item.number:04X}"
            link = Link(f"{item.series} {number}", comno_page(item.series), number)
            what = "ComNo"
        rows.setdefault((what, link, use.does), []).append(use.line)
    table = tuple(
        Row(((what,), (link,), (does,), (", ".join(map(str, sorted(set(lines)))),)))
        for (what, link, does), lines in rows.items()
    )
    return Table(("What", "Name", "The block", "In lines"), table)


def _calls(calls: Sequence[tuple[str, str]]) -> Iterator[Block]:
    """Dialects that write it alike share one sample."""
    titles: dict[str, list[str]] = {}
    for title, text in calls:
        titles.setdefault(text, []).append(title)
    for text, names in titles.items():
        yield Paragraph((Strong("; ".join(names)),))
        yield Sample(text, "scl")
