"""The data of DeviceNet assemblies in words: field by field, by the names of the catalogue."""

from fbgen.catalog import Assembly, DeviceNetGateway
from fbgen.catalog.devicenet_gateways import AssemblyField


def assembly_meaning(gateway: DeviceNetGateway, assembly: Assembly, data: bytes) -> str:
    """All fields of an assembly; `data` has as many bytes as it has."""
    return ", ".join(
        f"{field.name} = {_value(gateway, field, field_value(field, data))}"
        for field in assembly.fields
    )


def field_value(field: AssemblyField, data: bytes) -> int:
    """The number in a field: the low byte stands first."""
    return int.from_bytes(data[field.offset : field.offset + field.length], "little")


def _value(gateway: DeviceNetGateway, field: AssemblyField, value: int) -> str:
    if field.word is not None:
        word = gateway.word(field.word)
        names = [
            item.meaning if item.field.maximum > 1 and item.meaning else item.field.name
            for item in word.decode(value)
            if item.value
        ]
        return f"{value:04X} ({', '.join(names) or 'no bit set'})"
    if field.unit is not None:
        step, _, unit = field.unit.rpartition(" ")
        decimals = len(step.partition(".")[2])
        return f"{value * float(step or 1):.{decimals}f} {unit}"
    return f"{value:04X}"
