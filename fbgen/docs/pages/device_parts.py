"""What pages of gateways and of series have alike: words, times, switches, open questions."""

from fbgen.catalog import Drive, Gateway, Option
from fbgen.catalog.settings import Switch
from fbgen.catalog.sourced import Duration
from fbgen.docs.document import Block, Code, Link, Paragraph, Phrase, Row, Section, Table
from fbgen.docs.page_names import word_page
from fbgen.docs.sources import Sources
from fbgen.docs.texts import code, number, with_unit


def word_table(device: Gateway | Drive) -> Table:
    """The words of a device, each with its page."""
    rows = tuple(
        Row(((Link(f"{device.id}.{word.name}", word_page(device.id, word.name)),), (word.title,)))
        for word in device.words
    )
    return Table(("Word", "What it is"), rows)


def times_section(device: Gateway | Drive, sources: Sources) -> Section:
    """Its times."""
    times = device.times if isinstance(device, Drive) else getattr(device, "times", None)
    rows = []
    for name in type(times).model_fields if times is not None else ():
        duration = getattr(times, name)
        if isinstance(duration, Duration):
            text = name.replace("_", " ")
            source = sources.of(duration.source, duration.status)
            rows.append(Row(((text,), (f"{number(duration.ms)} ms",), source), f"time-{name}"))
    return Section("Times", (Table(("Time", "Value", "Source"), tuple(rows)),), "times")


def switches_section(switches: tuple[Switch, ...], sources: Sources) -> Section:
    """Its switches."""
    rows = []
    for switch in switches:
        if switch.adds is not None:
            stands = f"ON adds {switch.adds} to the address"
        elif switch.shows is not None:
            stands = f"{switch.shows} of the address"
        else:
            stands = switch.stands or ""
        source = sources.of(switch.source, switch.status)
        rows.append(Row(((switch.name,), (switch.where,), (stands,), source)))
    table = Table(("Switch", "Where", "How it stands", "Source"), tuple(rows))
    return Section("Switches", (table,), "switches")


def options_section(options: tuple[Option, ...], sources: Sources) -> Section:
    """What documents leave open, and the reading that is taken."""
    rows = []
    for option in options:
        default = (
            str(option.default).lower() if isinstance(option.default, bool) else option.default
        )
        meaning = option.choices.get(str(option.default), "")
        text = (
            f"{default}: {meaning}"
            if meaning
            else with_unit(option.default, option.unit)
            if (isinstance(option.default, int) and not isinstance(option.default, bool))
            else str(default)
        )
        others = "; ".join(
            f"{key}: {what}" for key, what in option.choices.items() if key != option.default
        )
        cells: tuple[Phrase, ...] = (
            *(code(option.id), (option.title,), (text,), (others,)),
            sources.of(option.source, option.status),
        )
        rows.append(Row(cells, f"option-{option.id}", f"option {option.id} {option.title}"))
    blocks: tuple[Block, ...] = (
        Paragraph(
            (
                "What the documents leave open or say in two ways. A plant file can choose, under ",
                Code("options:"),
                ".",
            )
        ),
        Table(("Option", "What it is about", "Taken", "Other choices", "Source"), tuple(rows)),
    )
    return Section("Open questions", blocks, "options")
