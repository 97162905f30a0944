"""A simulated DEV003Z: a DeviceNet slave inside an inverter, whose cells it reads and writes.

Facts: DEV003Z-1 manual E6581737; what of it is lost is marked in the catalogue, which gives all
numbers. A DeviceNet master reaches it by frames: `receive` takes one, `send` puts one on the bus.
"""

from collections.abc import Callable

from fbgen.catalog import DeviceNetGateway
from fbgen.catalog.devicenet_objects import Attribute, ObjectClass
from fbgen.catalog.options import OptionValue
from fbgen.diagnostics import error
from fbgen.wire.devicenet import BodyFormat, Frame, Service, Status
from fbgen.wire.devicenet_messages import ErrorResponse, Request, Response
from harness.fieldbus.devicenet import DeviceNetSlave, Network, NodeSettings
from harness.fieldbus.devicenet.connection import POLLED
from harness.gateways.dev003z.assemblies import Assemblies
from harness.gateways.dev003z.cells import Cells
from harness.gateways.dev003z.commands import Commands
from harness.gateways.dev003z.control_supervisor import State
from harness.gateways.dev003z.drive_attributes import DriveAttributes, refusal
from harness.gateways.dev003z.entry import check_attributes, check_complete
from harness.gateways.dev003z.host import Host
from harness.gateways.dev003z.leds import Light, module_status, network_status
from harness.gateways.dev003z.network_attributes import NetworkAttributes
from harness.gateways.dev003z.objects import ObjectModel, Value
from harness.gateways.dev003z.own_parameters import OwnParameters
from harness.gateways.dev003z.parts import Parts
from harness.gateways.dev003z.settings import Dev003zSettings
from harness.gateways.dev003z.speeds import Speeds
from harness.gateways.dev003z.supervisor import Supervisor
from harness.kernel import NS_PER_MS, Event, Kernel

_FACTORY = b"\x01"
_FORMATS = {
    "8_8": BodyFormat.C8_I8,
    "8_16": BodyFormat.C8_I16,
    "16_16": BodyFormat.C16_I16,
    "16_8": BodyFormat.C16_I8,
}


class Dev003z:
    """The option. It is on as soon and as long as the inverter has its supply."""

    __slots__ = (
        "_drive",
        "_host",
        "_kernel",
        "_lost",
        "_network",
        "_objects",
        "_powered",
        "assemblies",
        "cells",
        "commands",
        "gateway",
        "node",
        "on_loss",
        "own",
        "supervisor",
    )

    def __init__(
        self,
        kernel: Kernel,
        gateway: DeviceNetGateway,
        host: Host,
        send: Callable[[Frame], None],
        settings: Dev003zSettings = Dev003zSettings(),  # noqa: B008 - frozen
    ) -> None:
        """Raises DiagnosticError FB7101 for parameters that it does not take, FB1109 for options.

        FB7106 for a MAC ID, a rate or a series that it cannot have, FB7107 for an entry of the
        catalogue that lacks what the simulation stands on.
        """
        check_complete(gateway)
        _check(gateway, settings)
        self._kernel = kernel
        self._host = host
        self.gateway = gateway
        speeds = Speeds(int(_option(gateway, settings, "motor_poles")))
        self.own = OwnParameters(gateway.parameters, settings.parameters)
        eeprom = _option(gateway, settings, "register_memory") == "eeprom"
        self.cells = Cells(host, self.own, eeprom=eeprom)
        self.commands = Commands(host, gateway.word("command"), speeds)
        serial = int(_option(gateway, settings, "serial_number"))
        self.supervisor = Supervisor(host, self._is_initialised, self.commands.fault)
        parts = Parts(gateway, host, self.own, self.cells, speeds, self.commands, self.supervisor)
        self.assemblies = Assemblies(parts)
        self.node = DeviceNetSlave(kernel, send, _node_settings(gateway, settings, serial), self)
        self._drive = DriveAttributes(parts, int(_option(gateway, settings, "rated_torque")))
        port = gateway.devicenet
        name = port.product_name.encode("ascii")
        revision = int(_option(gateway, settings, "revision"))
        self._network = NetworkAttributes(
            gateway,
            self.node,
            self.assemblies,
            settings.baud,
            identity={
                "vendor_id": port.vendor_id,
                "device_type": port.device_type,
                "product_code": port.product_codes[settings.series],
                "revision": revision.to_bytes(2, "big"),
                "serial_number": serial,
                "product_name": bytes([len(name)]) + name,
            },
            tripped=lambda: host.tripped,
        )
        check_attributes(gateway, self._has_value)
        self._objects = ObjectModel(gateway, self)
        self._lost: Event | None = None
        self.on_loss: list[Callable[[int], None]] = []
        self._powered = False
        host.observers.append(self._host_changed)
        self._host_changed()

    def _has_value(self, known: ObjectClass, attribute: Attribute) -> bool:
        """Whether the simulation itself has the value of an attribute."""
        if known.name in ("assembly", "parameter"):
            return True
        ours = self._network.knows(known.name, attribute.name)
        return ours or self._drive.knows(known, attribute.name)

    def receive(self, frame: Frame) -> None:
        """Take a frame from the bus."""
        self.node.receive(frame)

    @property
    def powered(self) -> bool:
        """Whether it has its supply, which comes from the inverter."""
        return self._powered

    @property
    def state(self) -> State:
        """State of the Control Supervisor."""
        return self.supervisor.state

    @property
    def lights(self) -> tuple[Light, Light]:
        """MS and NS."""
        return module_status(self.node, tripped=self._host.tripped), network_status(self.node)

    # What the node asks for

    @property
    def output_length(self) -> int:
        """Bytes of I/O data from the master."""
        return self.assemblies.chosen.output.length

    @property
    def input_length(self) -> int:
        """Bytes of I/O data to the master."""
        return self.assemblies.chosen.input.length

    def serve(self, request: Request) -> Response | ErrorResponse:
        """Carry out an explicit request."""
        return self._objects.serve(request)

    def consume(self, data: bytes) -> None:
        """Take I/O data of the master."""
        self._found()
        self.assemblies.take(self.assemblies.chosen, data, self.state)

    def produce(self) -> bytes:
        """The I/O data for the master."""
        return self.assemblies.make(self.assemblies.chosen, self._drive.status())

    def communication_lost(self) -> None:
        """Do what c101 says, if c103 lets it count, and after the time of c100.

        What the register channel was asked for is forgotten: whoever comes next asks anew.
        """
        self.assemblies.forget_request()
        if self._lost is not None or not self._host.powered:
            return
        delay = self.gateway.parameter("timeout_time").resolution * self.own["timeout_time"]
        self._lost = self._kernel.after(round(delay * 1000) * NS_PER_MS, self._act_on_loss)

    def reset(self) -> None:
        """The network part was reset: nothing is commanded any more."""
        self.commands.clear()
        self.assemblies.restart()
        self._network.restart()
        self.supervisor.reset()

    # What the object model asks for

    def exists(self, object_class: ObjectClass, instance: int) -> bool:
        """Whether there is such an instance now."""
        match object_class.name:
            case "connection":
                return instance in self.node.connections
            case "assembly":
                return self.assemblies.find(instance) is not None
            case "parameter":
                return self.cells.read(self._number(instance)) is not None
            case _:
                return instance == 1

    def get(self, object_class: ObjectClass, attribute: Attribute, instance: int) -> Value | Status:
        """The value of an attribute now."""
        if self._network.knows(object_class.name, attribute.name):
            return self._network.get(object_class.name, attribute, instance)
        if object_class.name == "assembly":
            return self._assembly_data(instance)
        if object_class.name == "parameter":
            value = self.cells.read(self._number(instance))
            return Status.OBJECT_DOES_NOT_EXIST if value is None else value
        return self._drive.get(object_class, attribute)

    def set(
        self, object_class: ObjectClass, attribute: Attribute, instance: int, value: Value
    ) -> Status | None:
        """Set an attribute; why it is refused, or None."""
        if isinstance(value, bytes):
            return self._set_assembly(instance, value)
        if self._network.knows(object_class.name, attribute.name):
            return self._network.set(object_class.name, attribute, instance, value)
        if object_class.name == "parameter":
            number = self._number(instance)
            if not self.cells.writable(number):
                return Status.ATTRIBUTE_NOT_SETTABLE
            return refusal(self.cells.write(number, value))
        return self._drive.set(object_class, attribute, value)

    def call(self, object_class: ObjectClass, request: Request) -> bytes | Status:
        """Reset of the Identity object, of a connection, or of the Control Supervisor."""
        if object_class.name == "connection":
            if request.data:
                return Status.TOO_MUCH_DATA
            done = self.node.connections[request.instance].reset()
            self.node.changed()
            return b"" if done else Status.OBJECT_STATE_CONFLICT
        if object_class.name == "control_supervisor":
            if request.data:
                return Status.TOO_MUCH_DATA
            self.commands.withdraw()
            self.supervisor.reset()
            return b""
        if object_class.name == "identity" and request.service == Service.RESET:
            if len(request.data) > 1:
                return Status.TOO_MUCH_DATA
            if request.data not in (b"", b"\x00", _FACTORY):
                return Status.INVALID_PARAMETER
            if request.data == _FACTORY:
                self.own.reset()
            self.node.restart()
            return b""
        return Status.SERVICE_NOT_SUPPORTED

    # Inside

    def _number(self, instance: int) -> int:
        return self.gateway.parameter_object.number(instance)

    def _assembly_data(self, instance: int) -> bytes:
        found = self.assemblies.find(instance)
        assert found is not None, "asked before"
        pair, assembly = found
        if assembly is pair.output:
            return self.assemblies.outputs(pair)
        return self.assemblies.make(pair, self._drive.status())

    def _set_assembly(self, instance: int, data: bytes) -> Status | None:
        found = self.assemblies.find(instance)
        assert found is not None, "asked before"
        pair, assembly = found
        if assembly is not pair.output:
            return Status.ATTRIBUTE_NOT_SETTABLE
        if len(data) != assembly.length:
            short = len(data) < assembly.length
            return Status.NOT_ENOUGH_DATA if short else Status.TOO_MUCH_DATA
        polled = self.node.connections.get(POLLED)
        if polled is not None and polled.established:
            return Status.OBJECT_STATE_CONFLICT
        self.assemblies.take(pair, data, self.state)
        return None

    def _act_on_loss(self) -> None:
        self._lost = None
        condition, host = self.own["timeout_condition"], self._host
        if condition and not host.given_to_option:
            return
        if condition == 2 and not host.running:
            return
        action = self.own["timeout_action"]
        for told in self.on_loss:
            told(action)
        self.commands.lost(action, self.own["timeout_preset"])

    def _found(self) -> None:
        """Communication is there: what was about to follow from its loss does not."""
        if self._lost is not None:
            self._kernel.cancel(self._lost)
            self._lost = None

    def _is_initialised(self) -> bool:
        return self.node.network not in (Network.OFF, Network.SELF_TEST)

    def _host_changed(self) -> None:
        """The inverter did something, or its supply came or went."""
        if self._host.powered != self._powered:
            self._powered = self._host.powered
            if self._powered:
                self.reset()
                self.node.power_on()
            else:
                self.node.power_off()
                self._found()
                self.reset()
        self.supervisor.follow()


def _option(gateway: DeviceNetGateway, settings: Dev003zSettings, name: str) -> OptionValue:
    entry = gateway.option(name)
    return entry.check(settings.options[name]) if name in settings.options else entry.default


def _node_settings(
    gateway: DeviceNetGateway, settings: Dev003zSettings, serial: int
) -> NodeSettings:
    port, times = gateway.devicenet, gateway.times
    return NodeSettings(
        mac=settings.mac,
        vendor=port.vendor_id,
        serial=serial,
        body_format=_FORMATS[port.body_format],
        explicit_bytes=port.explicit_bytes,
        self_test_ns=times.self_test.ns,
        check_ns=times.duplicate_check.ns,
        response_ns=times.response.ns,
        fragment_timeout_ns=times.fragment_timeout.ns,
        unused_ns=times.unused.ns,
        sample_ns=times.sample.ns,
    )


def _check(gateway: DeviceNetGateway, settings: Dev003zSettings) -> None:
    port = gateway.devicenet
    if settings.series not in port.product_codes:
        raise error(
            "FB7106",
            f"a {gateway.id} does not fit into an inverter of the series '{settings.series}'",
            help=f"it fits into {', '.join(port.product_codes)}",
        )
    if not port.minimum_mac <= settings.mac <= port.maximum_mac:
        raise error(
            "FB7106",
            f"{settings.mac} is no MAC ID of a {gateway.id}",
            help=f"use {port.minimum_mac} to {port.maximum_mac}",
        )
    if settings.baud not in port.baud_rates:
        rates = ", ".join(f"{key} for {rate} kbit/s" for key, rate in port.baud_rates.items())
        raise error("FB7106", f"there is no rate {settings.baud}", help=f"use {rates}")
