"""The data of DeviceNet assemblies for `fbgen decode dev003z.151`, field by field."""

from collections.abc import Iterator

from fbgen.catalog import Assembly, Catalog, DeviceNetGateway
from fbgen.catalog.devicenet_gateways import AssemblyField
from fbgen.cli.frames.frame_reading import Part, Reading, size_of
from fbgen.cli.frames.telegram_reading import set_bits
from fbgen.dataclass import dataclass
from fbgen.diagnostics import error


@dataclass(frozen=True, slots=True)
class AssemblyKind:
    """An assembly of an adapter, to ("output") or from it."""

    gateway: DeviceNetGateway
    assembly: Assembly
    way: str


def assembly_kind(known: Catalog, word: str) -> AssemblyKind | None:
    """What `dev003z.151` stands for; None for anything else."""
    device, _, instance = word.lower().partition(".")
    gateway = known.gateways.get(device)
    if not isinstance(gateway, DeviceNetGateway):
        return None
    for pair in gateway.assemblies:
        for way, assembly in (("output", pair.output), ("input", pair.input)):
            if instance == str(assembly.instance):
                return AssemblyKind(gateway, assembly, way)
    return None


def assembly_reading(kind: AssemblyKind, data: bytes) -> Reading:
    """What the bytes say. Raises DiagnosticError FB9041 if they are too few or too many."""
    assembly = kind.assembly
    if len(data) != assembly.length:
        raise error(
            "FB9041",
            f"this is no data of instance {assembly.instance}: it has {size_of(len(data))}",
            help=f"the instance has {assembly.length} bytes",
        )
    title = f"{kind.gateway.id}, instance {assembly.instance}, {kind.way} of the PLC"
    return Reading(title, kind.way, data, None, tuple(_parts(kind, data)), ())


def _parts(kind: AssemblyKind, data: bytes) -> Iterator[Part]:
    for field in kind.assembly.fields:
        raw = data[field.offset : field.offset + field.length]
        text = _meaning(kind.gateway, field, int.from_bytes(raw, "little"))
        yield Part(raw, field.name, text)


def _meaning(gateway: DeviceNetGateway, field: AssemblyField, value: int) -> str:
    if field.word is not None:
        word = gateway.word(field.word)
        named = [item.meaning for item in word.decode(value) if item.field.maximum > 1]
        states = [meaning for meaning in named if meaning]
        return "; ".join([set_bits(word, value), *states])
    if field.parameter is not None:
        display = gateway.parameter(field.parameter).display
        return f"{value:04X}, {value}: what {display} chooses"
    if field.unit is not None:
        step, _, unit = field.unit.rpartition(" ")
        return f"{value * float(step):g} {unit}" if step else f"{value} {unit}"
    return f"{field.title}: {value:04X}, {value}"
