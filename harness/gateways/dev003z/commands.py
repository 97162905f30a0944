"""What the network commands, as FA06 and FA07 of the inverter.

Instances 20, 21 and 101 and the attributes of Control Supervisor and AC/DC Drive go through the
run/stop event matrix; instances 100, 102 and 105 write the words themselves. Our own, because the
text at hand does not say it: a run edge counts only while the network has the command and the drive
is Ready, Enabled or Stopping; after a trip, or when communication was lost, it takes a new edge; a
fault reset acts once, when its bit comes; a set-point over the maximum frequency becomes that, and
a speed below 0 becomes 0.
"""

from fbgen.catalog import Word
from harness.gateways.dev003z.control_supervisor import RunType, State, Trigger, run_stop
from harness.gateways.dev003z.host import Host
from harness.gateways.dev003z.speeds import Speeds

COMMAND, FREQUENCY = 0xFA06, 0xFA07
MAXIMUM_FREQUENCY = 0x0011
_RUNNABLE = (State.READY, State.ENABLED, State.STOPPING)


class Commands:
    """Run 1, Run 2, Net Ctrl, Net Ref and Fault Reset as they were set last, and what follows."""

    __slots__ = (
        "_bits",
        "_host",
        "_presets",
        "_raw_reset",
        "_run_type",
        "_speeds",
        "_word",
        "fault_reset",
        "net_control",
        "net_reference",
        "runs",
        "speed",
    )

    def __init__(self, host: Host, word: Word, speeds: Speeds) -> None:
        """`word`: the bits of the command word."""
        self._host = host
        self._speeds = speeds
        self._bits = {field.name: field.mask for field in word.bits}
        self._presets = [self._bits[f"preset_speed_{place}"] for place in (1, 2, 3, 4)]
        self.clear()

    def clear(self) -> None:
        """As after power-on."""
        self._word = 0
        self._raw_reset = False
        self._run_type = RunType.NONE
        self.runs = (False, False)
        self.net_control = self.net_reference = self.fault_reset = False
        self.speed = 0

    def set_links(self, *, control: bool, reference: bool) -> None:
        """Net Ctrl and Net Ref."""
        self.net_control, self.net_reference = control, reference
        self._put()

    def set_runs(self, run_1: bool, run_2: bool, state: State) -> None:
        """Run 1 and Run 2, in a state of the Control Supervisor."""
        trigger, run_type = run_stop(self.runs, (run_1, run_2))
        self.runs = (run_1, run_2)
        if trigger is Trigger.STOP:
            self._run_type = RunType.NONE
        elif trigger is Trigger.RUN and state in _RUNNABLE and self._host.network_command:
            self._run_type = run_type
        self._put()

    def set_speed(self, speed: int) -> None:
        """The speed reference, in min-1; a negative one becomes 0."""
        self.speed = speed = max(0, speed)
        self.write_frequency(self._speeds.hundredths_of_hz(speed))

    def set_fault_reset(self, wanted: bool) -> None:
        """Fault Reset: a change from 0 to 1 resets."""
        before, self.fault_reset = self.fault_reset, wanted
        if wanted and not before and self._host.tripped:
            self._host.write_ram(COMMAND, self._bits["fault_reset"])
            self.fault()

    def fault(self) -> None:
        """It tripped: it will not go on by itself."""
        self._run_type = RunType.NONE
        self._word &= ~self._bits["run"]

    def withdraw(self) -> None:
        """The Control Supervisor was reset: what runs stops, and takes a new edge."""
        self._run_type = RunType.NONE
        self._put()

    def write_command(self, word: int) -> None:
        """A command word from instance 100, 102 or 105. Its reset bit acts once."""
        reset = self._bits["fault_reset"]
        wanted = bool(word & reset)
        if wanted and not self._raw_reset:
            self._host.write_ram(COMMAND, reset)
        self._raw_reset = wanted
        self._write(word & ~reset)

    def write_frequency(self, word: int) -> None:
        """A frequency command in 0.01 Hz."""
        maximum = self._host.read(MAXIMUM_FREQUENCY)
        self._host.write_ram(FREQUENCY, word if maximum is None else min(word, maximum))

    def lost(self, action: int, preset: int) -> None:
        """Communication was lost: do what c101 says (E6581737, page 9)."""
        bits = self._bits
        run, links = bits["run"], bits["network_command"] | bits["network_frequency"]
        if action == 0:
            self.net_control = self.net_reference = False
            self._stop_word(0)
        elif action == 2:
            self._stop_word(self._word & ~run)
        elif action == 3:
            self._stop_word(self._word & ~run | bits["coast_stop"])
        elif action == 4:
            self._run_type = RunType.NONE
            self._host.trip("Err8")
        elif action == 5 and preset:
            row = sum(mask for place, mask in enumerate(self._presets) if preset >> place & 1)
            self._run_type = RunType.NONE
            self._write(links | run | row)

    def _stop_word(self, word: int) -> None:
        self._run_type = RunType.NONE
        self._write(word)

    def _put(self) -> None:
        """The word that the attributes make."""
        bits = self._bits
        word = bits["network_command"] * self.net_control
        word |= bits["network_frequency"] * self.net_reference
        if self._run_type is not RunType.NONE:
            word |= bits["run"]
        if self._run_type is RunType.RUN_2:
            word |= bits["reverse"]
        self._write(word)

    def _write(self, word: int) -> None:
        self._word = word
        if self._host.powered and not self._host.tripped:
            self._host.write_ram(COMMAND, word)
