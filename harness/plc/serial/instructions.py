"""Which instructions for serial lines a CPU has, once a communication module is plugged."""

from functools import partial

from harness.engine.block_models import ModelFactory
from harness.plc.serial.configuring import PortConfig, ReceiveConfig, SendConfig
from harness.plc.serial.cp34x import PReceive, PSend, Send440
from harness.plc.serial.freeport import ReceiveP2p, ReceiveReset, SendP2p
from harness.plc.serial.jobs import PortInstruction
from harness.plc.serial.modbus_master import ModbusCommLoad, ModbusMaster
from harness.plc.serial.ports import SerialPorts

_FREEPORT: dict[str, type[PortInstruction]] = {
    "SEND_P2P": SendP2p,
    "RECEIVE_P2P": ReceiveP2p,
    "RECEIVE_RESET": ReceiveReset,
    "PORT_CONFIG": PortConfig,
    "SEND_CONFIG": SendConfig,
    "RECEIVE_CONFIG": ReceiveConfig,
    "MB_COMM_LOAD": ModbusCommLoad,
    "MODBUS_COMM_LOAD": ModbusCommLoad,
    "MB_MASTER": ModbusMaster,
    "MODBUS_MASTER": ModbusMaster,
}
_OF_CP_34X: dict[str, type[PortInstruction]] = {
    "P_SND_RK": PSend,
    "P_RCV_RK": PReceive,
    "P_SEND": PSend,
    "P_RCV": PReceive,
    "SEND_440": Send440,
    "RECV_440": PReceive,
}


def serial_instructions(ports: SerialPorts, *, classic: bool) -> dict[str, ModelFactory]:
    """By the name of the checker; those of the CP 340, 341 and 440 on S7-300 and S7-400 alone."""
    known = {**_FREEPORT, **(_OF_CP_34X if classic else {})}
    return {name: partial(model, ports) for name, model in known.items()}
