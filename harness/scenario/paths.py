"""Names in scenario files: what `drive.pump.running` and `plc.TOS_Plant...` stand for.

plc.VARIABLE        a variable of the PLC, `plc.TOS_Plant.gw1.pump.stop.execute`, `plc.List[2].ok`
                    TOS_ stands for the plant's own prefix, too
cpu.ITEM, bus.ITEM  the CPU and the DP master
gateway.NAME.ITEM   a gateway, `gateway.gw1.led.device_status`, `gateway.gw1.input.a_status`
drive.NAME.ITEM     a drive, `drive.pump.frequency`, `drive.pump.comno.FE03`,
                    `drive.pump.terminal.s1`
line.NAME.ITEM      the module of the PLC at a serial line, `line.line1.lost_messages`
devicenet.NAME.ITEM the option in a drive, `devicenet.pump.input.status`; of a network its `mode`

`docs/reference/scenario-files.md` has the whole list.
"""

from collections.abc import Callable, Mapping
from functools import partial
from types import MappingProxyType

from fbgen.catalog import Catalog
from fbgen.dataclass import dataclass
from fbgen.diagnostics import DiagnosticError, error
from fbgen.plant import with_prefix
from fbgen.source import Span
from harness.drives import Inverter
from harness.engine.compiled.watching.last_writes import last_write
from harness.fieldbus import MasterMode
from harness.gateways.tospbdp001 import Light, Tospbdp001
from harness.installation import Installation
from harness.plc import CpuMode
from harness.scenario.devicenet_paths import devicenet_item, network_item
from harness.scenario.interface_paths import interface_item
from harness.scenario.kinds import (
    COUNT,
    FLAG,
    NUMBER,
    Found,
    ValueKind,
    choice_kind,
    coded_kind,
    no_bytes,
    octets_kind,
    word_kind,
)
from harness.scenario.named_things import Readable, Writer, one_of, unknown
from harness.scenario.plc_variables import reading, variable_kind

ROOTS = ("plc", "cpu", "bus", "gateway", "line", "drive", "devicenet")


@dataclass(frozen=True, slots=True)
class Writable:
    """What a path can be set to. `set` may raise DiagnosticError for a device that refuses.

    `writer` is as that of `Readable`.
    """

    kind: ValueKind
    set: Callable[[Found], None]
    writer: Writer | None = None


_DRIVE: Mapping[str, tuple[ValueKind, Callable[[Inverter], Found]]] = MappingProxyType(
    {
        "running": (FLAG, lambda drive: drive.running),
        "frequency": (NUMBER, lambda drive: drive.frequency_hz),
        "set_point": (NUMBER, lambda drive: drive.set_point_hz),
        "direction": (choice_kind(("forward", "reverse")), lambda drive: drive.direction),
        "current": (NUMBER, lambda drive: drive.current_percent),
        "torque": (NUMBER, lambda drive: drive.torque_percent),
        "tripped": (FLAG, lambda drive: drive.tripped),
        "network_command": (FLAG, lambda drive: drive.network_command),
        "network_frequency": (FLAG, lambda drive: drive.network_frequency),
        "powered": (FLAG, lambda drive: drive.powered),
    }
)
DRIVE_ITEMS = (*_DRIVE, "trip", "trip_code")
"""What a drive has by itself."""
COMNO_ITEMS = ("comno", "word", "writes")
"""What a drive has by ComNo: value in its unit, raw word, write cycles of the EEPROM cell."""
_TERMINAL = "terminal"
"""An input terminal of a drive, by its name."""
_GATEWAY: Mapping[str, tuple[ValueKind, Callable[[Tospbdp001], Found]]] = MappingProxyType(
    {
        "powered": (FLAG, lambda gateway: gateway.powered),
        "online": (FLAG, lambda gateway: gateway.slave.online),
        "telegrams": (COUNT, lambda gateway: gateway.telegrams),
        "overwritten": (COUNT, lambda gateway: gateway.overwritten),
    }
)
GATEWAY_ITEMS = (*_GATEWAY, "status", "outputs", "inputs", "too_close")
"""What a gateway has, beside its lamps."""
LINE_ITEMS = ("available", "lost_messages")
"""What the module of a serial line has: it answers the CPU; messages that found no room."""
_LIGHT = choice_kind(tuple(str(light.value) for light in Light))
_CPU_MODE = choice_kind(tuple(mode.name for mode in CpuMode))
_BUS_MODE = choice_kind(tuple(mode.name for mode in MasterMode))


class Paths:
    """Resolves the names of one plant. Errors are FB8003 with the nearest names."""

    def __init__(self, plant: Installation, catalog: Catalog) -> None:
        self._plant = plant
        self._catalog = catalog

    def readable(self, path: str, span: Span | None) -> Readable:
        """What a path gives. Raises DiagnosticError FB8003."""
        root, _, rest = path.partition(".")
        plant = self._plant
        if root == "plc":
            variable = with_prefix(rest, plant.plan.prefix)
            kind = self._variable(variable, span)
            engine = plant.cpu.engine
            writer = partial(last_write, engine, variable)
            return Readable(kind, reading(engine, variable), writer)
        if root == "cpu":
            one_of(rest, ("mode", "scans"), "property of the CPU", span)
            if rest == "scans":
                return Readable(COUNT, lambda: plant.cpu.scans)
            return Readable(_CPU_MODE, lambda: plant.cpu.mode.name)
        if root == "bus":
            one_of(rest, ("mode",), "property of the bus", span)
            return Readable(_BUS_MODE, lambda: plant.master.mode.name)
        name, _, item = rest.partition(".")
        if root == "gateway":
            one_of(name, plant.stations, "gateway", span)
            if name in plant.interfaces:
                entry = next(item for item in plant.plan.gateways if item.name == name)
                return interface_item(plant.interfaces[name], entry, self._catalog, item, span)
            return self._gateway(plant.gateways[name], item, span)
        if root == "line":
            one_of(name, plant.devices.modules, "serial line", span)
            one_of(item, LINE_ITEMS, "property of a serial line", span)
            module = plant.devices.modules[name]
            if item == "available":
                return Readable(FLAG, lambda: module.available)
            return Readable(COUNT, lambda: module.lost_messages)
        if root == "drive":
            one_of(name, plant.drives, "drive", span)
            return _drive(plant.drives[name], item, span)
        if root == "devicenet":
            if name in plant.networks:
                return network_item(plant.networks[name], item, span)
            one_of(name, plant.options, "drive on DeviceNet", span)
            network = next(one for one in plant.networks.values() if name in one.options)
            return devicenet_item(network, name, item, span)
        raise unknown(root, ROOTS, "kind of thing", span)

    def writable(self, path: str, span: Span | None) -> Writable:
        """What a path can be set to. Raises DiagnosticError FB8003."""
        root, _, rest = path.partition(".")
        if root == "plc":
            variable = with_prefix(rest, self._plant.plan.prefix)
            kind = self._variable(variable, span)
            engine = self._plant.cpu.engine
            writer = partial(last_write, engine, variable)
            return Writable(
                kind, lambda value: engine.set_global(variable, no_bytes(value)), writer
            )
        name, _, item = rest.partition(".")
        what, _, key = item.partition(".")
        if root != "drive" or what not in ("comno", _TERMINAL):
            one_of(root, ROOTS, "kind of thing", span)
            raise error(
                "FB8003",
                f"'{path}' cannot be set",
                span,
                "set plc.<variable>, drive.<name>.terminal.<terminal>, or "
                "drive.<name>.comno.<parameter> as at its panel",
            )
        one_of(name, self._plant.drives, "drive", span)
        drive = self._plant.drives[name]
        if what == _TERMINAL:
            one_of(key, drive.terminals.names, "input terminal of this drive", span)
            return Writable(FLAG, lambda value: drive.switch_terminal(key, bool(value)))
        number = _comno(drive, key, span)
        if "w" not in drive.series.comno(number).access:
            advice = "it can only be read: expect it"
            raise error("FB8003", f"'{path}' cannot be set", span, advice)
        return Writable(NUMBER, lambda value: drive.set_parameter(number, _number(value)))

    def _variable(self, path: str, span: Span | None) -> ValueKind:
        engine = self._plant.cpu.engine
        if not path:
            raise unknown(
                "",
                tuple(item.name for item in engine.program.globals.values()),
                "variable of the PLC",
                span,
            )
        try:
            engine.global_value(path)
        except DiagnosticError as wrong:
            first = wrong.diagnostics[0]
            raise error("FB8003", f"in the PLC {first.message}", span, first.help) from None
        return variable_kind(engine.program, path)

    def _gateway(self, gateway: Tospbdp001, item: str, span: Span | None) -> Readable:
        kind, _, lamp = item.partition(".")
        if kind == "led":
            one_of(lamp, gateway.leds._fields, "lamp of a gateway", span)
            return Readable(_LIGHT, lambda: str(getattr(gateway.leds, lamp).value))
        one_of(item, (*GATEWAY_ITEMS, "led"), "property of a gateway", span)
        if item == "status":
            entry = next(entry for entry in self._plant.plan.gateways if entry.name == gateway.name)
            word = self._catalog.telegram_gateway(entry.type).status_word
            return Readable(word_kind(word), lambda: gateway.status.word)
        if item == "outputs":
            length = gateway.settings.layout.output_length
            return Readable(octets_kind(length), lambda: gateway.slave.outputs)
        if item == "too_close":
            spacing = self._plant.spacing[gateway.name]
            return Readable(COUNT, lambda: len(spacing.too_close))
        if item == "inputs":
            length = gateway.settings.layout.input_length
            return Readable(octets_kind(length), lambda: gateway.slave.inputs)
        value_kind, read = _GATEWAY[item]
        return Readable(value_kind, lambda: read(gateway))


def _drive(drive: Inverter, item: str, span: Span | None) -> Readable:
    what, _, key = item.partition(".")
    if what in COMNO_ITEMS:
        number = _comno(drive, key, span)
        if what == "comno":
            return Readable(NUMBER, lambda: drive.read_parameter(number))
        if what == "writes":
            return Readable(COUNT, lambda: drive.registers.write_cycles.get(number, 0))
        name = drive.series.comno(number).word
        word = drive.series.word(name) if name is not None else None
        return Readable(word_kind(word), lambda: drive.read_word(number))
    if what == _TERMINAL:
        one_of(key, drive.terminals.names, "input terminal of this drive", span)
        return Readable(FLAG, lambda: drive.terminals.is_on(key))
    one_of(item, (*DRIVE_ITEMS, *COMNO_ITEMS, _TERMINAL), "property of a drive", span)
    trips = drive.series.trips
    if item == "trip":
        displays = choice_kind(("", *(trip.display for trip in trips)))
        return Readable(displays, lambda: drive.trip_display)
    if item == "trip_code":
        meanings = coded_kind({trip.code: trip.display for trip in trips})
        return Readable(meanings, lambda: drive.trip_code)
    kind, read = _DRIVE[item]
    return Readable(kind, lambda: read(drive))


def _comno(drive: Inverter, key: str, span: Span | None) -> int:
    try:
        return drive.series.comno(key).number
    except DiagnosticError as wrong:
        first = wrong.diagnostics[0]
        raise error("FB8003", first.message, span, first.help) from None


def _number(value: Found) -> float:
    assert isinstance(value, int | float), "NUMBER has read it"
    return float(value)
