"""Attributes of the network's side: Identity, Message Router, DeviceNet, Connection and the like.

The numbers of transport classes, triggers and communication characteristics are those that CIP
gives the predefined connections.
"""

from collections.abc import Callable, Mapping

from fbgen.catalog import DeviceNetGateway
from fbgen.catalog.devicenet_objects import Attribute
from fbgen.wire.devicenet import Choice, Status
from fbgen.wire.devicenet_ids import Group2, SlaveMessage, group_2, slave_message
from fbgen.wire.devicenet_paths import assembly_path
from harness.fieldbus.devicenet import Connection, DeviceNetSlave, Network
from harness.fieldbus.devicenet.connection import COS, EXPLICIT, POLLED, WatchdogAction
from harness.gateways.dev003z.assemblies import Assemblies

_STATES = {
    Network.OFF: 0,
    Network.SELF_TEST: 1,
    Network.CHECKING: 2,
    Network.ONLINE: 3,
    Network.FAULT: 5,
}
_OWNED, _MINOR_RECOVERABLE_FAULT = 0x0001, 0x0100
_NO_IO, _IO_FAULT, _RUN_MODE, _IDLE_MODE = 0x0030, 0x0020, 0x0060, 0x0070
"""Bits 4 to 7 of the status (E6581737, page 11)."""

_OF_CONNECTIONS = (
    *("state", "instance_type", "transport_class_trigger", "produced_connection_id"),
    *("consumed_connection_id", "initial_comm_characteristics", "produced_connection_size"),
    *("consumed_connection_size", "expected_packet_rate", "watchdog_timeout_action"),
    *("produced_connection_path_length", "produced_connection_path"),
    *("consumed_connection_path_length", "consumed_connection_path", "production_inhibit_time"),
)

Value = int | bytes


class NetworkAttributes:
    """The attributes by class and name."""

    __slots__ = ("_assemblies", "_baud", "_gateway", "_getters", "_heartbeat", "_identity", "_node")

    def __init__(
        self,
        gateway: DeviceNetGateway,
        node: DeviceNetSlave,
        assemblies: Assemblies,
        baud: int,
        *,
        identity: Mapping[str, Value],
        tripped: Callable[[], bool],
    ) -> None:
        """`identity`: what the Identity object says and never changes."""
        self._gateway = gateway
        self._node = node
        self._assemblies = assemblies
        self._baud = baud
        self._identity = identity
        self._heartbeat = 0
        self._getters: Mapping[tuple[str, str], Callable[[], Value]] = {
            ("identity", "status"): lambda: self._status(tripped()),
            ("identity", "state"): lambda: _STATES[node.network],
            ("identity", "heartbeat_interval"): lambda: self._heartbeat,
            ("message_router", "object_list"): self._classes,
            ("message_router", "number_available"): lambda: gateway.devicenet.max_connections,
            ("message_router", "number_active"): lambda: len(node.connections),
            ("message_router", "active_connections"): lambda: _words(sorted(node.connections)),
            ("devicenet", "mac_id"): lambda: node.settings.mac,
            ("devicenet", "baud_rate"): lambda: baud,
            ("devicenet", "bus_off_interrupt"): lambda: int(node.bus_off_interrupt),
            ("devicenet", "bus_off_counter"): lambda: node.bus_off_count,
            ("devicenet", "allocation"): lambda: bytes(
                (node.allocation.choice, node.allocation.master)
            ),
            ("devicenet", "mac_switch_changed"): lambda: 0,
            ("devicenet", "baud_switch_changed"): lambda: 0,
            ("devicenet", "mac_switch"): lambda: node.settings.mac,
            ("devicenet", "baud_switch"): lambda: baud,
            ("acknowledge_handler", "timer"): lambda: node.ack_timer_ms,
            ("acknowledge_handler", "retry_limit"): lambda: node.ack_retries,
            ("acknowledge_handler", "producing_connection"): lambda: COS,
        }

    def knows(self, class_name: str, name: str) -> bool:
        """Whether it has the value of an attribute."""
        if class_name == "connection":
            return name in _OF_CONNECTIONS
        of_identity = class_name == "identity" and name in self._identity
        return of_identity or (class_name, name) in self._getters

    def get(self, class_name: str, attribute: Attribute, instance: int) -> Value:
        """The value now."""
        if class_name == "connection":
            return self._connection(self._node.connections[instance], attribute.name)
        if class_name == "identity" and attribute.name in self._identity:
            return self._identity[attribute.name]
        return self._getters[class_name, attribute.name]()

    def set(
        self, class_name: str, attribute: Attribute, instance: int, value: int
    ) -> Status | None:
        """Set it; why it is refused, or None."""
        node = self._node
        match class_name, attribute.name:
            case "connection", name:
                return self._set_connection(node.connections[instance], name, value)
            case "identity", "heartbeat_interval":
                self._heartbeat = value
            case "devicenet", "bus_off_interrupt":
                node.bus_off_interrupt = bool(value)
            case "devicenet", "bus_off_counter":
                node.bus_off_count = 0
            case "acknowledge_handler", "timer":
                node.ack_timer_ms = value
            case "acknowledge_handler", "retry_limit":
                node.ack_retries = value
            case _:
                return None if value == COS else Status.INVALID_ATTRIBUTE_VALUE
        if node.producer is not None:
            node.producer.timer_ms, node.producer.retries = node.ack_timer_ms, node.ack_retries
        return None

    def restart(self) -> None:
        """As after power-on."""
        self._heartbeat = 0

    def _status(self, tripped: bool) -> int:
        node = self._node
        status = _NO_IO
        if node.io_established:
            status = _RUN_MODE if node.io_running else _IDLE_MODE
        if node.io_timed_out:
            status = _IO_FAULT
        if node.connections:
            status |= _OWNED
        return status | _MINOR_RECOVERABLE_FAULT if tripped else status

    def _classes(self) -> bytes:
        codes = [item.code for item in self._gateway.objects]
        return _words([len(codes), *codes])

    def _connection(self, connection: Connection, name: str) -> Value:
        instance, mac, choice = connection.instance, self._node.settings.mac, self._choice()
        pair = self._assemblies.chosen
        produced = b"" if instance == EXPLICIT else assembly_path(pair.input.instance)
        consumed = assembly_path(pair.output.instance) if instance == POLLED else b""
        acknowledged = not choice & Choice.ACK_SUPPRESSION
        trigger = 0x00 if choice & Choice.CYCLIC else 0x10
        sends = {
            EXPLICIT: group_2(Group2.EXPLICIT_RESPONSE, mac),
            POLLED: slave_message(SlaveMessage.POLL_RESPONSE, mac),
            COS: slave_message(SlaveMessage.COS, mac),
        }
        takes = {
            EXPLICIT: group_2(Group2.EXPLICIT_REQUEST, mac),
            POLLED: group_2(Group2.POLL, mac),
            COS: group_2(Group2.COS_ACKNOWLEDGE, mac) if acknowledged else 0xFFFF,
        }
        values: Mapping[str, Value] = {
            "state": int(connection.state),
            "instance_type": int(instance != EXPLICIT),
            "transport_class_trigger": {
                EXPLICIT: 0x83,
                POLLED: 0x82,
                COS: trigger | (2 if acknowledged else 0),
            }[instance],
            "produced_connection_id": sends[instance],
            "consumed_connection_id": takes[instance],
            "initial_comm_characteristics": {
                EXPLICIT: 0x21,
                POLLED: 0x01,
                COS: 0x01 if acknowledged else 0x0F,
            }[instance],
            "produced_connection_size": connection.produced_size,
            "consumed_connection_size": connection.consumed_size,
            "expected_packet_rate": connection.rate_ms,
            "watchdog_timeout_action": int(connection.action),
            "produced_connection_path_length": len(produced),
            "produced_connection_path": produced,
            "consumed_connection_path_length": len(consumed),
            "consumed_connection_path": consumed,
            "production_inhibit_time": connection.inhibit_ms,
        }
        return values[name]

    def _choice(self) -> Choice:
        return self._node.allocation.choice

    def _set_connection(self, connection: Connection, name: str, value: int) -> Status | None:
        if name == "expected_packet_rate":
            if value and value < connection.inhibit_ms:
                return Status.INVALID_ATTRIBUTE_VALUE
            connection.set_rate(value)
            self._node.changed()
        elif name == "production_inhibit_time":
            if connection.rate_ms and value > connection.rate_ms:
                return Status.INVALID_ATTRIBUTE_VALUE
            connection.inhibit_ms = value
        elif connection.instance != EXPLICIT:
            return Status.ATTRIBUTE_NOT_SETTABLE
        elif value not in (WatchdogAction.AUTO_DELETE, WatchdogAction.DEFERRED_DELETE):
            return Status.INVALID_ATTRIBUTE_VALUE
        else:
            connection.action = WatchdogAction(value)
        return None


def _words(numbers: list[int]) -> bytes:
    return b"".join(number.to_bytes(2, "little") for number in numbers)
