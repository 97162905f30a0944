"""An EDS file for a DeviceNet adapter: what a configuration tool asks for, from the catalogue.

The format is that of ODVA's electronic data sheets: sections of entries, fields between commas, an
entry ends with a semicolon. The maker's own file is not public; this one says so in its text.
"""

from collections.abc import Iterable, Iterator
from fractions import Fraction

from fbgen.catalog import Assembly, DeviceNetGateway, Drive
from fbgen.wire.devicenet_paths import Logical, Segment, assembly_path, encode_path

_DATE, _TIME = "01-01-2026", "12:00:00"
"""Fixed: the same catalogue gives the same file."""
_REVISION = "1.0"
_POLLED, _COS, _CYCLIC = 0x0001, 0x0004, 0x0008
_ALL = _POLLED | _COS | _CYCLIC
"""Outputs too: beside polls the master sends them when they change, or cyclically."""
_NO_DESCRIPTOR, _SCALED = 0x0000, 0x0004
_UINT, _UINT_CODE = 2, 0xC7
_NAME, _HELP = 32, 64
"""Characters that names and helps may have."""


def eds_text(gateway: DeviceNetGateway, series: Drive) -> str:
    """The file for the option inside an inverter of a series."""
    lines = [
        f"$ {gateway.title}",
        f"$ Inside a {series.id}. Simulated by fbgen: this is not the maker's file.",
        "",
        *_section("File", _file(gateway)),
        *_section("Device", _device(gateway, series)),
        *_section("IO_Info", _io(gateway)),
        *_section("ParamClass", _parameter_class(gateway)),
        *_section("Params", _parameters(gateway)),
    ]
    return "\n".join(lines).rstrip("\n") + "\n"


def _section(name: str, entries: Iterable[tuple[str, list[str]]]) -> Iterator[str]:
    yield f"[{name}]"
    for key, fields in entries:
        if len(fields) == 1:
            yield f"        {key} = {fields[0]};"
            continue
        yield f"        {key} ="
        for place, field in enumerate(fields):
            end = ";" if place == len(fields) - 1 else ","
            yield f"                {field}{end}"
    yield ""


def _file(gateway: DeviceNetGateway) -> Iterator[tuple[str, list[str]]]:
    yield "DescText", [_text(f"{gateway.devicenet.product_name}, simulated by fbgen")]
    yield "CreateDate", [_DATE]
    yield "CreateTime", [_TIME]
    yield "ModDate", [_DATE]
    yield "ModTime", [_TIME]
    yield "Revision", [_REVISION]


def _device(gateway: DeviceNetGateway, series: Drive) -> Iterator[tuple[str, list[str]]]:
    port = gateway.devicenet
    revision = gateway.option("revision").default
    assert isinstance(revision, int), "the catalogue's option is a number"
    yield "VendCode", [str(port.vendor_id)]
    yield "VendName", [_text(gateway.vendor)]
    yield "ProdType", [str(port.device_type)]
    yield "ProdTypeStr", [_text("AC Drive")]
    yield "ProdCode", [str(port.product_codes[series.id])]
    yield "MajRev", [str(revision >> 8)]
    yield "MinRev", [str(revision & 0xFF)]
    yield "ProdName", [_text(port.product_name)]
    yield "Catalog", [_text(gateway.id.upper())]


def _io(gateway: DeviceNetGateway) -> Iterator[tuple[str, list[str]]]:
    yield "Default", [_hex(_POLLED)]
    yield "PollInfo", [_hex(_ALL), "1", "1"]
    yield "COSInfo", [_hex(_POLLED | _COS), "1", "1"]
    yield "CyclicInfo", [_hex(_POLLED | _CYCLIC), "1", "1"]
    for number, pair in enumerate(gateway.assemblies, start=1):
        yield f"Input{number}", _connection(pair.input)
    for number, pair in enumerate(gateway.assemblies, start=1):
        yield f"Output{number}", _connection(pair.output)


def _connection(assembly: Assembly) -> list[str]:
    path = assembly_path(assembly.instance)
    name = f"Instance {assembly.instance}"
    return [
        *(str(assembly.length), "0", _hex(_ALL), _text(name)),
        *(str(len(path)), _path(path), _text(assembly.title, _HELP)),
    ]


def _parameter_class(gateway: DeviceNetGateway) -> Iterator[tuple[str, list[str]]]:
    yield "MaxInst", [str(len(gateway.parameters))]
    yield "Descriptor", [_hex(_NO_DESCRIPTOR)]
    yield "CfgAssembly", ["0"]


def _parameters(gateway: DeviceNetGateway) -> Iterator[tuple[str, list[str]]]:
    rule = gateway.parameter_object
    for number, item in enumerate(gateway.parameters, start=1):
        path = encode_path(
            (
                Logical(Segment.CLASS, rule.code),
                Logical(Segment.INSTANCE, rule.instance(item.number), wide=True),
                Logical(Segment.ATTRIBUTE, rule.attribute),
            )
        )
        step = Fraction(str(item.resolution))
        decimals = len(str(step.denominator)) - 1
        yield (
            f"Param{number}",
            [
                *("0", str(len(path)), _path(path), _hex(_NO_DESCRIPTOR if step == 1 else _SCALED)),
                *(_hex(_UINT_CODE, 2), str(_UINT), _text(item.display)),
                *(_text(item.unit), _text(item.title, _HELP)),
                *(str(item.minimum), str(item.maximum), str(item.default)),
                *(str(step.numerator), str(step.denominator), "1", "0"),
                *("0", "0", "0", "0", str(decimals)),
            ],
        )


def _text(text: str, longest: int = _NAME) -> str:
    return '"' + text.replace('"', "'")[:longest] + '"'


def _hex(number: int, digits: int = 4) -> str:
    return f"0x{number:0{digits}X}"


def _path(path: bytes) -> str:
    return _text(path.hex(" ").upper())
