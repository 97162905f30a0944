"""A DeviceNet adapter as text for a person, for `fbgen catalog show`."""

from collections.abc import Iterable, Iterator

from fbgen.catalog import Assembly, DeviceNetGateway
from fbgen.catalog.devicenet_objects import Attribute, ObjectClass, Service
from fbgen.catalog.sourced import Sourced
from fbgen.cli.entries.word_tables import Sources
from fbgen.cli.table import table


def devicenet_text(gateway: DeviceNetGateway, sources: Sources) -> list[str]:
    """Its node, assemblies, parameters, selections, objects and times."""
    return [
        table(["node", "value", "source"], list(_node(gateway, sources))),
        table(
            ["assemblies", gateway.parameter(gateway.assembly_parameter).display, "instance",
             "byte", "field", "unit", "word or parameter", "source", "title"],
            [row for pair in gateway.assemblies for way in ("output", "input")
             for row in _fields(pair.name, pair.setting, getattr(pair, way), sources)],
        ),
        table(
            ["parameter", "number", "name", "range", "default", "source", "title"],
            list(_parameters(gateway, sources)),
        ),
        *(
            table(
                [f"{kind} code", "ComNo", "source", "title"],
                [[str(item.code), f"{item.comno:04X}", sources.of(item), item.title]
                 for item in chosen],
            )
            for kind, chosen in (("command", gateway.commands), ("monitor", gateway.monitors))
        ),
        *(_class(item, sources) for item in gateway.objects),
        table(
            ["cells of the inverter", "instance", "source"],
            [[name, instance, sources.of(gateway.parameter_object)]
             for name, instance in _cells(gateway)],
        ),
        table(["time", "value", "source"], list(_times(gateway, sources))),
    ]  # fmt: skip


def _node(gateway: DeviceNetGateway, sources: Sources) -> Iterator[list[str]]:
    node = gateway.devicenet
    source = _doubts(node, node.unverified, sources)
    rates = ", ".join(f"{value}: {rate}" for value, rate in node.baud_rates.items())
    codes = ", ".join(f"{series}: {code}" for series, code in node.product_codes.items())
    yield ["MAC ID", f"{node.minimum_mac} to {node.maximum_mac}", source]
    yield ["kbit/s", rates, source]
    yield ["vendor", str(node.vendor_id), source]
    yield ["device type", str(node.device_type), source]
    yield ["product", codes, source]


def _fields(name: str, setting: int, data: Assembly, sources: Sources) -> Iterator[list[str]]:
    for field in data.fields:
        yield [
            name,
            str(setting),
            str(data.instance),
            f"{field.offset}..{field.offset + field.length - 1}",
            field.name,
            field.unit or "",
            field.word or field.parameter or "",
            _doubts(data, (field.name,) if field.name in data.unverified else (), sources),
            field.title,
        ]


def _parameters(gateway: DeviceNetGateway, sources: Sources) -> Iterator[list[str]]:
    for item in gateway.parameters:
        step = item.resolution
        yield [
            item.display,
            f"{item.number:04X}",
            item.name,
            f"{item.minimum * step:g}..{item.maximum * step:g} {item.unit}".rstrip(),
            f"{item.default * step:g}",
            _doubts(item, item.unverified, sources),
            "; ".join([item.title, *(f"{key}: {text}" for key, text in item.values.items())]),
        ]


def _class(item: ObjectClass, sources: Sources) -> str:
    rows = [
        *(_attribute("class", one, item, sources) for one in item.class_attributes),
        *(_attribute("", one, item, sources) for one in item.attributes),
        *(_service(one, item, sources) for one in item.services),
    ]
    heading = f"{item.code:02X} {item.title}"
    if item.instances:
        heading += " (" + ", ".join(f"{one.number} {one.title}" for one in item.instances) + ")"
    return table(["of the", "number", "name", "type", "access", "default", "source", heading], rows)


def _attribute(owner: str, item: Attribute, above: ObjectClass, sources: Sources) -> list[str]:
    values = (f"{key}: {text}" for key, text in item.values.items())
    return [
        owner,
        str(item.id),
        item.name,
        item.type,
        "get, set" if item.settable else "get",
        "" if item.default is None else str(item.default),
        _source(item, above, sources),
        "; ".join([item.title, *values, *([] if item.remark is None else [item.remark])]),
    ]


def _service(item: Service, above: ObjectClass, sources: Sources) -> list[str]:
    owners = [name for name, has in (("class", item.on_class), ("object", item.on_instance)) if has]
    return [
        ", ".join(owners),
        f"{item.code:02X}",
        item.name,
        "service",
        "",
        "",
        _source(item, above, sources),
        item.title,
    ]


def _source(item: Attribute | Service, above: ObjectClass, sources: Sources) -> str:
    """The source of the class, unless the entry has its own; and whether it is verified."""
    shown = sources.of(above)
    return f"{shown} unverified" if item.status == "unverified" else shown


def _cells(gateway: DeviceNetGateway) -> Iterator[tuple[str, str]]:
    rule = gateway.parameter_object
    yield "communication numbers", f"number + {rule.offset:04X}, attribute {rule.attribute}"
    yield "those that begin with F", f"number - {rule.offset_of_f:04X}, attribute {rule.attribute}"


def _times(gateway: DeviceNetGateway, sources: Sources) -> Iterator[list[str]]:
    for name in type(gateway.times).model_fields:
        time = getattr(gateway.times, name)
        yield [name, f"{time.ms:g} ms", sources.of(time)]


def _doubts(item: Sourced, unverified: Iterable[str], sources: Sources) -> str:
    named = " ".join(unverified)
    return f"{sources.of(item)} unverified: {named}" if named else sources.of(item)
