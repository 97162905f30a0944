"""Real CAN interfaces, by python-can: socketcan, slcan, pcan and more; `virtual` in a process.

DeviceNet has identifiers of 11 bits and data frames only: anything else on the bus is not heard.
"""

import logging
from collections import deque
from importlib.util import find_spec
from typing import TYPE_CHECKING, Protocol

from fbgen.diagnostics import Diagnostic, DiagnosticError, error
from fbgen.nearest import nearest
from fbgen.wire.devicenet import Frame

if TYPE_CHECKING:
    import can

TICK_S = 0.005
"""How long an interface waits for a frame: so often the server looks what else there is to do."""
_UDP = "udp_multicast:239.74.163.2"
_HELP = f"--can INTERFACE:CHANNEL, such as socketcan:can0, slcan:/dev/ttyACM0 or {_UDP}"
_OPEN_HELP = (
    f"is the adapter there, with its driver? between programs on one computer {_UDP} needs none"
)
_UDP_HELP = "the channel is an address of a group: 239.74.163.2, or another from 224.0.0.0 on"
_ECHOING = ("udp_multicast",)
"""Interfaces that give back what was sent, which no CAN controller does."""
_ECHOES = 64
"""Frames sent whose echo is waited for, at most; older ones got lost."""


class CanInterface(Protocol):
    """Where the network is."""

    @property
    def name(self) -> str:
        """What a person calls it."""
        ...

    def read(self, wait_s: float = TICK_S) -> Frame | None:
        """The next frame; waits `wait_s` at most, None if none came.

        Raises DiagnosticError FB9031 if the interface is not there any more.
        """
        ...

    def write(self, frame: Frame) -> None:
        """Send; as `read`."""
        ...

    def close(self) -> None:
        """Give the interface back."""
        ...


class PythonCan:
    """An interface of python-can that is open."""

    def __init__(self, name: str, bus: "can.BusABC", *, echoes: bool = False) -> None:
        """`echoes`: the interface gives back what was sent."""
        self._name = name
        self._bus = bus
        self._echoes: deque[Frame] | None = deque(maxlen=_ECHOES) if echoes else None

    @property
    def name(self) -> str:
        """As it was asked for."""
        return self._name

    def read(self, wait_s: float = TICK_S) -> Frame | None:
        """The next data frame with an identifier of 11 bits."""
        import can  # noqa: PLC0415 - an extra: only who opens an interface needs it

        try:
            message = self._bus.recv(wait_s)
        except (can.CanError, OSError) as problem:
            if self._is_no_frame(problem):
                return None
            raise self._gone(problem) from None
        if message is None or message.is_extended_id or message.is_fd:
            return None
        if message.is_remote_frame or message.is_error_frame:
            return None
        frame = Frame(message.arbitration_id, bytes(message.data))
        return None if self._is_echo(frame) else frame

    def write(self, frame: Frame) -> None:
        """Send a frame."""
        import can  # noqa: PLC0415 - an extra: only who opens an interface needs it

        message = can.Message(
            arbitration_id=frame.identifier, data=frame.data, is_extended_id=False
        )
        try:
            self._bus.send(message)
        except (can.CanError, OSError) as problem:
            raise self._gone(problem) from None
        if self._echoes is not None:
            self._echoes.append(frame)

    def close(self) -> None:
        """Give the interface back."""
        self._bus.shutdown()

    def _is_echo(self, frame: Frame) -> bool:
        """Whether it is the next of those sent; the ones sent before it got lost then."""
        if self._echoes is None or frame not in self._echoes:
            return False
        while self._echoes.popleft() != frame:
            pass
        return True

    def _is_no_frame(self, problem: Exception) -> bool:
        """Whether somebody sent what is no CAN frame, which is possible without a controller."""
        cause = problem.__cause__
        return self._echoes is not None and cause is not None and not isinstance(cause, OSError)

    def _gone(self, problem: Exception) -> DiagnosticError:
        message = f"{self._name} cannot be used any more: {problem}"
        return DiagnosticError([Diagnostic("FB9031", message, None, "is the network there?")])


def can_interface(name: str, bit_rate: int) -> PythonCan:
    """Open an interface by INTERFACE:CHANNEL. Raises DiagnosticError FB9033 without python-can,
    FB9030 for a name that is none, FB9031 for an interface that cannot be opened."""
    if find_spec("can") is None:
        raise error(
            "FB9033",
            "CAN interfaces are opened with the package python-can, which is not installed",
            None,
            "pip install 'fbgen[devicenet]'",
        )
    import can  # noqa: PLC0415 - an extra: only who opens an interface needs it

    interface, colon, channel = name.partition(":")
    if not colon or not channel:
        raise error("FB9030", f"'{name}' names no interface with its channel", None, _HELP)
    if interface not in can.VALID_INTERFACES:
        help_ = nearest(interface, can.VALID_INTERFACES)
        raise error("FB9030", f"python-can has no interface '{interface}'", None, help_)
    logging.getLogger("can").setLevel(logging.CRITICAL)
    try:
        bus = can.Bus(interface=interface, channel=channel, bitrate=bit_rate)
    except Exception as problem:  # each interface has errors of its own, down to those of drivers
        reason = str(problem) or type(problem).__name__
        help_ = _UDP_HELP if interface in _ECHOING else _OPEN_HELP
        raise error("FB9031", f"{name} cannot be opened: {reason}", None, help_) from None
    return PythonCan(name, bus, echoes=interface in _ECHOING)
