"""What the page of a DeviceNet adapter has of its own: node, assemblies, parameters, objects."""

from collections.abc import Iterable, Iterator

from fbgen.catalog import Assembly, DeviceNetGateway
from fbgen.catalog.devicenet_gateways import Selection
from fbgen.catalog.devicenet_objects import Attribute, ObjectClass, Service
from fbgen.docs.document import Link, Paragraph, Phrase, Row, Section, Table
from fbgen.docs.page_names import word_page
from fbgen.docs.sources import Sources
from fbgen.docs.texts import code


def node_facts(gateway: DeviceNetGateway, sources: Sources) -> list[tuple[str, Phrase]]:
    """How it appears on the network."""
    node = gateway.devicenet
    codes = ", ".join(f"{number} in a {series}" for series, number in node.product_codes.items())
    rates = ", ".join(str(rate) for rate in node.baud_rates.values())
    source = sources.of(node.source, "unverified" if node.unverified else node.status)
    return [
        ("MAC ID", (f"{node.minimum_mac} to {node.maximum_mac}",)),
        ("Rates", (f"{rates} kbit/s",)),
        ("Identity", (f"vendor {node.vendor_id}, type {node.device_type}, product {codes}",)),
        ("DeviceNet", source),
    ]


def devicenet_sections(gateway: DeviceNetGateway, sources: Sources) -> Iterator[Section]:
    """Assemblies, parameters, selections and objects."""
    chooser = gateway.parameter(gateway.assembly_parameter).display
    for pair in gateway.assemblies:
        table = Table(
            ("Instance", "Bytes from 0", "Field", "Unit", "What it is", "Source"),
            (*_fields(gateway, pair.output, sources), *_fields(gateway, pair.input, sources)),
        )
        lead = Paragraph((f"{pair.title}, with {chooser} at {pair.setting}.",))
        title = f"Assemblies {pair.output.instance} and {pair.input.instance}"
        yield Section(title, (lead, table), f"assemblies-{pair.name}")
    yield Section("Parameters of its own", (_parameters(gateway, sources),), "parameters")
    choices = (
        _selections("Commands", gateway.commands, sources),
        _selections("Monitors", gateway.monitors, sources),
    )
    yield Section("What words can be chosen to carry", choices, "selections")
    for item in gateway.objects:
        yield _object(item, sources)


def _fields(gateway: DeviceNetGateway, data: Assembly, sources: Sources) -> Iterable[Row]:
    for field in data.fields:
        title: Phrase = (field.title,)
        if field.word is not None:
            title = (Link(field.title, word_page(gateway.id, field.word)),)
        cells: tuple[Phrase, ...] = (
            *((str(data.instance),), (f"{field.offset} to {field.offset + field.length - 1}",)),
            *(code(field.name), (field.unit or "",), title),
            sources.of(data.source, data.status),
        )
        yield Row(cells, f"assembly-{data.instance}-{field.name}")


def _parameters(gateway: DeviceNetGateway, sources: Sources) -> Table:
    rows = []
    for item in gateway.parameters:
        values = "; ".join(f"{value}: {text}" for value, text in item.values.items())
        status = "unverified" if item.unverified else item.status
        cells: tuple[Phrase, ...] = (
            *(code(item.display), (item.title,), (values or f"{item.minimum} to {item.maximum}",)),
            *((str(item.default),), sources.of(item.source, status)),
        )
        found = f"{gateway.id} {item.display} {item.title}"
        rows.append(Row(cells, f"parameter-{item.display}", found))
    return Table(("Parameter", "What it is", "Values", "Default", "Source"), tuple(rows))


def _selections(title: str, items: tuple[Selection, ...], sources: Sources) -> Table:
    rows = tuple(
        Row(
            (
                *((str(item.code),), code(f"{item.comno:04X}"), (item.title,)),
                sources.of(item.source, item.status),
            )
        )
        for item in items
    )
    return Table(("Code", "ComNo", "What it is", "Source"), rows, title)


def _object(item: ObjectClass, sources: Sources) -> Section:
    attributes = [
        Row(
            (
                *((owner,), (str(one.id),), (_what(one),), (one.type,)),
                *(("get and set" if one.settable else "get",),),
                ("" if one.default is None else str(one.default),),
                sources.of(one.source or item.source, one.status or item.status),
            ),
            f"class-{item.code:02x}-{owner}-{one.id}",
        )
        for owner, rows in (("class", item.class_attributes), ("object", item.attributes))
        for one in rows
    ]
    services = [
        Row(
            (
                *((_owners(one),), code(f"{one.code:02X}"), (one.title,)),
                sources.of(one.source or item.source, one.status or item.status),
            )
        )
        for one in item.services
    ]
    blocks = (
        Table(
            ("Of the", "Attribute", "What it is", "Type", "Access", "Default", "Source"),
            tuple(attributes),
        ),
        Table(("Of the", "Service", "What it does", "Source"), tuple(services)),
    )
    if item.instances:
        named = "; ".join(f"{one.number}, {one.title}" for one in item.instances)
        return Section(
            f"Class {item.code:02X}: {item.title}",
            (Paragraph((f"Its instances: {named}.",)), *blocks),
            f"class-{item.code:02x}",
        )
    return Section(f"Class {item.code:02X}: {item.title}", blocks, f"class-{item.code:02x}")


def _what(item: Attribute) -> str:
    """What an attribute is, its values, and what else there is to say of it."""
    values = ", ".join(f"{value} {text}" for value, text in item.values.items())
    said = f"{item.title}: {values}" if values else item.title
    return f"{said}. {item.remark}" if item.remark else said


def _owners(item: Service) -> str:
    """Who has a service: the class itself, its objects, or both."""
    owners = (("class", item.on_class), ("object", item.on_instance))
    return ", ".join(name for name, has in owners if has)
