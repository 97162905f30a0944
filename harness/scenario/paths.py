"""Names in scenario files: what `drive.pump.running` and `plc.TOS_Plant...` stand for.

plc.PATH            a global variable of the PLC, `plc.TOS_Plant.gw1.pump.stop.execute`
cpu.NAME            mode, scans
bus.NAME            mode (STOP, CLEAR, OPERATE)
gateway.NAME.ITEM   status, control, trigger, reply, powered, telegrams, led.LAMP
drive.NAME.ITEM     running, frequency, set_point, direction, current, torque, tripped, trip,
                    trip_code, network_command, network_frequency, powered, and by the
                    catalogue comno.FE03 (in its unit), word.FD01 (raw), parameter.ACC name
"""

from collections.abc import Callable, Mapping
from types import MappingProxyType

from fbgen.catalog import Catalog
from fbgen.diagnostics import Diagnostic, DiagnosticError
from fbgen.nearest import nearest
from fbgen.source import Span
from harness.drives import Inverter
from harness.gateways.tospbdp001 import Tospbdp001
from harness.installation import Installation
from harness.scenario.model import ScalarValue
from harness.scenario.values import Found, plain

Getter = Callable[[], Found]

_DRIVE: Mapping[str, Callable[[Inverter], Found]] = MappingProxyType(
    {
        "running": lambda drive: drive.running,
        "frequency": lambda drive: drive.frequency_hz,
        "set_point": lambda drive: drive.set_point_hz,
        "direction": lambda drive: drive.direction,
        "current": lambda drive: drive.current_percent,
        "torque": lambda drive: drive.torque_percent,
        "tripped": lambda drive: drive.tripped,
        "trip": lambda drive: drive.trip_display,
        "trip_code": lambda drive: drive.trip_code,
        "network_command": lambda drive: drive.network_command,
        "network_frequency": lambda drive: drive.network_frequency,
        "powered": lambda drive: drive.powered,
    }
)
_GATEWAY: Mapping[str, Callable[[Tospbdp001], Found]] = MappingProxyType(
    {
        "status": lambda gateway: gateway.status.word,
        "outputs": lambda gateway: gateway.slave.outputs,
        "inputs": lambda gateway: gateway.slave.inputs,
        "powered": lambda gateway: gateway.powered,
        "online": lambda gateway: gateway.slave.online,
        "telegrams": lambda gateway: gateway.telegrams,
        "overwritten": lambda gateway: gateway.overwritten,
    }
)


class Paths:
    """Resolves the names of one running plant. Errors are FB8003 with the nearest names."""

    def __init__(self, plant: Installation, catalog: Catalog) -> None:
        self._plant = plant
        self._catalog = catalog

    def getter(self, path: str, span: Span | None) -> Getter:
        """A function that gives the value of a path now."""
        root, _, rest = path.partition(".")
        if root == "plc":
            engine = self._plant.cpu.engine
            with _Located(span):
                engine.global_value(rest)
            return lambda: engine.global_value(rest)
        if root == "cpu":
            return self._cpu(rest, span)
        if root == "bus":
            _one_of(rest, ("mode",), "property of the bus", span)
            return lambda: self._plant.master.mode.name
        name, _, item = rest.partition(".")
        if root == "gateway":
            gateways = self._plant.gateways
            _one_of(name, gateways, "gateway", span)
            return self._gateway(gateways[name], item, span)
        if root == "drive":
            drives = self._plant.drives
            _one_of(name, drives, "drive", span)
            return self._drive(drives[name], item, span)
        raise _unknown(root, ("plc", "cpu", "bus", "gateway", "drive"), "kind of thing", span)

    def set(self, path: str, value: ScalarValue, span: Span | None) -> None:
        """Write a variable of the PLC or a parameter of a drive."""
        root, _, rest = path.partition(".")
        if root == "plc":
            with _Located(span):
                self._plant.cpu.engine.set_global(rest, plain(value))
            return
        name, _, item = rest.partition(".")
        kind, _, key = item.partition(".")
        if root == "drive" and kind == "parameter" and isinstance(value, int | float):
            _one_of(name, self._plant.drives, "drive", span)
            with _Located(span):
                self._plant.drives[name].set_parameter(key, float(value))
            return
        raise DiagnosticError(
            [
                Diagnostic(
                    "FB8003",
                    f"'{path}' cannot be set",
                    span,
                    "set plc.<variable>, or drive.<name>.parameter.<ComNo> to a number",
                )
            ]
        )

    def _cpu(self, item: str, span: Span | None) -> Getter:
        cpu = self._plant.cpu
        getters: dict[str, Getter] = {
            "mode": lambda: cpu.mode.name,
            "scans": lambda: cpu.scans,
        }
        _one_of(item, getters, "property of the CPU", span)
        return getters[item]

    def _gateway(self, gateway: Tospbdp001, item: str, span: Span | None) -> Getter:
        kind, _, lamp = item.partition(".")
        if kind == "led":
            _one_of(lamp, gateway.leds._fields, "lamp", span)
            return lambda: str(getattr(gateway.leds, lamp).value)
        _one_of(item, _GATEWAY, "property of a gateway", span)
        read = _GATEWAY[item]
        return lambda: read(gateway)

    def _drive(self, drive: Inverter, item: str, span: Span | None) -> Getter:
        kind, _, key = item.partition(".")
        if kind in ("comno", "word", "writes"):
            with _Located(span):
                number = drive.series.comno(key).number
            if kind == "comno":
                return lambda: drive.read_parameter(number)
            if kind == "word":
                return lambda: drive.read_word(number)
            return lambda: drive.registers.write_cycles.get(number, 0)
        _one_of(item, (*_DRIVE, "comno", "word", "writes"), "property of a drive", span)
        read = _DRIVE[item]
        return lambda: read(drive)


class _Located:
    """Gives findings without a place the place in the scenario file."""

    def __init__(self, span: Span | None) -> None:
        self._span = span

    def __enter__(self) -> None:
        pass

    def __exit__(self, kind: object, failure: BaseException | None, trace: object) -> None:
        if isinstance(failure, DiagnosticError):
            raise DiagnosticError(
                Diagnostic("FB8003", found.message, self._span, found.help)
                for found in failure.diagnostics
            ) from None


def _one_of(
    name: str, known: Mapping[str, object] | tuple[str, ...], what: str, span: Span | None
) -> None:
    if name not in known:
        raise _unknown(name, tuple(known), what, span)


def _unknown(name: str, known: tuple[str, ...], what: str, span: Span | None) -> DiagnosticError:
    message = f"there is no {what} '{name}' in this plant"
    return DiagnosticError([Diagnostic("FB8003", message, span, nearest(name, known))])
