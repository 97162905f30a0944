"""The Control Supervisor's states, and its run/stop event matrix, as tables.

Facts: DEV003Z-1 manual E6581737, page 40 (printed 39). The matrix is there whole but for its
arrows. Of the diagram all names of states and events are there, but no arrows: what leads where is
as the CIP profile of AC drives has it. The states have the numbers of the attribute, page 39.
"""

from collections.abc import Mapping
from enum import Enum, IntEnum
from types import MappingProxyType


class State(IntEnum):
    """The attribute `state`, and Drive Status in instances 71 and 151."""

    NON_EXISTENT = 0
    STARTUP = 1
    NOT_READY = 2
    READY = 3
    ENABLED = 4
    STOPPING = 5
    FAULT_STOP = 6
    FAULTED = 7


class Event(Enum):
    """What takes it from state to state."""

    SWITCH_ON = "switch on"
    SWITCH_OFF = "switch off"
    INITIALISED = "initialisation complete"
    MAIN_POWER_ON = "main power on"
    MAIN_POWER_OFF = "main power off"
    RUN = "run"
    STOP = "stop"
    STOP_COMPLETE = "stop complete"
    RESET = "reset"
    FAULT = "fault detected"
    FAULT_STOP_COMPLETE = "fault stop complete"
    FAULT_RESET = "fault reset"


_POWERED = tuple(state for state in State if state is not State.NON_EXISTENT)
TRANSITIONS: Mapping[tuple[State, Event], State] = MappingProxyType(
    {
        (State.NON_EXISTENT, Event.SWITCH_ON): State.STARTUP,
        (State.STARTUP, Event.INITIALISED): State.NOT_READY,
        (State.NOT_READY, Event.MAIN_POWER_ON): State.READY,
        (State.READY, Event.RUN): State.ENABLED,
        (State.ENABLED, Event.STOP): State.STOPPING,
        (State.STOPPING, Event.RUN): State.ENABLED,
        (State.STOPPING, Event.STOP_COMPLETE): State.READY,
        (State.READY, Event.MAIN_POWER_OFF): State.NOT_READY,
        (State.ENABLED, Event.MAIN_POWER_OFF): State.FAULTED,
        (State.STOPPING, Event.MAIN_POWER_OFF): State.FAULTED,
        (State.FAULT_STOP, Event.MAIN_POWER_OFF): State.FAULTED,
        (State.STARTUP, Event.FAULT): State.FAULTED,
        (State.NOT_READY, Event.FAULT): State.FAULTED,
        (State.READY, Event.FAULT): State.FAULTED,
        (State.ENABLED, Event.FAULT): State.FAULT_STOP,
        (State.STOPPING, Event.FAULT): State.FAULT_STOP,
        (State.FAULT_STOP, Event.FAULT_STOP_COMPLETE): State.FAULTED,
        (State.FAULTED, Event.FAULT_RESET): State.NOT_READY,
        **{(state, Event.RESET): State.STARTUP for state in _POWERED},
        **{(state, Event.SWITCH_OFF): State.NON_EXISTENT for state in _POWERED},
    }
)
"""State and event -> next state; where nothing stands the state stays."""


def next_state(state: State, event: Event) -> State:
    """The state behind an event."""
    return TRANSITIONS.get((state, event), state)


class Trigger(Enum):
    """What the run/stop event matrix makes of Run 1 and Run 2."""

    NONE = "no action"
    STOP = "stop"
    RUN = "run"


class RunType(Enum):
    """Which of the two runs."""

    NONE = "no action"
    RUN_1 = "run 1"
    RUN_2 = "run 2"


def run_stop(before: tuple[bool, bool], now: tuple[bool, bool]) -> tuple[Trigger, RunType]:
    """The event matrix: Run 1 and Run 2 as they were, and as they are.

    Only an edge starts: a bit that stays set does not. Both at once do nothing; of two that were
    set, the one that stays runs on when the other goes.
    """
    run_1, run_2 = now
    if not run_1 and not run_2:
        return Trigger.STOP, RunType.NONE
    if run_1 and run_2:
        return Trigger.NONE, RunType.NONE
    both_were = before == (True, True)
    if run_1 and (both_were or not before[0]):
        return Trigger.RUN, RunType.RUN_1
    if run_2 and (both_were or not before[1]):
        return Trigger.RUN, RunType.RUN_2
    return Trigger.NONE, RunType.NONE
