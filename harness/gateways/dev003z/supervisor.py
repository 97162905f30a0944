"""The Control Supervisor on a running inverter: it follows what that does, event by event.

The option has its supply from the inverter, so that main power is on whenever it is itself.
"""

from collections.abc import Callable

from harness.gateways.dev003z.control_supervisor import Event, State, next_state
from harness.gateways.dev003z.host import Host

_MOVING = (State.ENABLED, State.STOPPING, State.FAULT_STOP)
_READY = (State.READY, State.ENABLED, State.STOPPING)


class Supervisor:
    """`initialised` says whether the option's self test is over; `fault` is called by each trip."""

    __slots__ = ("_fault", "_host", "_initialised", "_state")

    def __init__(
        self, host: Host, initialised: Callable[[], bool], fault: Callable[[], None]
    ) -> None:
        self._host = host
        self._initialised = initialised
        self._fault = fault
        self._state = State.NON_EXISTENT

    @property
    def state(self) -> State:
        """The state now."""
        self.follow()
        return self._state

    @property
    def running_1(self) -> bool:
        """Enabled, Stopping or Fault Stop, forward."""
        return self.state in _MOVING and not self._host.reverse

    @property
    def running_2(self) -> bool:
        """Enabled, Stopping or Fault Stop, in reverse."""
        return self.state in _MOVING and self._host.reverse

    @property
    def ready(self) -> bool:
        """Ready, Enabled or Stopping."""
        return self.state in _READY

    def reset(self) -> None:
        """The option was reset."""
        self._take(Event.RESET)

    def follow(self) -> None:
        """Let everything happen that the inverter has done since."""
        while (event := self._event()) is not None:
            self._take(event)

    def _take(self, event: Event) -> None:
        self._state = next_state(self._state, event)

    def _event(self) -> Event | None:
        """What has happened and was not taken yet, one thing at a time."""
        state, host = self._state, self._host
        if not host.powered:
            return None if state is State.NON_EXISTENT else Event.SWITCH_OFF
        if state is State.NON_EXISTENT:
            return Event.SWITCH_ON
        if host.tripped and state not in (State.FAULT_STOP, State.FAULTED):
            self._fault()
            return Event.FAULT
        if state is State.STARTUP:
            return Event.INITIALISED if self._initialised() else None
        if state is State.NOT_READY:
            return Event.MAIN_POWER_ON
        if state is State.FAULT_STOP:
            return None if host.running else Event.FAULT_STOP_COMPLETE
        if state is State.FAULTED:
            return None if host.tripped else Event.FAULT_RESET
        if state is State.ENABLED:
            return None if host.told_to_run else Event.STOP
        if host.told_to_run:
            return Event.RUN
        return Event.STOP_COMPLETE if state is State.STOPPING and not host.running else None
