"""The rules on a serial line: the generated blocks keep them, and without a piece of a block each
tells what it forbids."""

from pathlib import Path

import pytest

from fbgen.catalog import load_catalog
from fbgen.plant import load_plant
from fbgen.wire import modbus
from fbgen.wire.single_words import Said, Wanted
from fbgen.wire.toshiba import seal
from tests.unit.rules.watched import WatchedPlant

ROOT = Path(__file__).parents[3]
CATALOG = load_catalog()
RULES = (
    "lost_is_told",
    "no_command_unasked",
    "one_telegram_at_once",
    "repeats_allowed",
    "telegrams_asked_for",
    "values_answered",
)


class Watched(WatchedPlant):
    """Two drives on a line, with what breaks the rules; both have been heard."""

    def __init__(
        self, example: str, *changes: tuple[str, str], protocol: str = "", cycle_ms: float = 10.0
    ) -> None:
        plan = load_plant(ROOT / "examples" / example / "plant.yaml", CATALOG)
        plan = plan.model_copy(update={"cycle_time_ms": cycle_ms})
        if protocol:
            line = plan.serial[0].model_copy(update={"protocol": protocol})
            plan = plan.model_copy(update={"serial": (line,)})
        super().__init__(plan, CATALOG, RULES, changes)
        self.run_ms(1000)

    def set(self, name: str, value: object) -> None:
        self.plant.cpu.engine.set_global(f"TOS_Plant.line1.fan.{name}", value)

    def run_and_lose_the_drive(self) -> None:
        self.set("control.enable", True)
        self.run_ms(400)
        self.set("control.frequency", 20.0)
        self.set("control.run", True)
        self.run_ms(1000)
        assert self.plant.drives["fan"].running
        self.plant.drives["fan"].power_off()
        self.run_ms(2500)
        self.plant.drives["fan"].power_on()
        self.run_ms(3000)

    def sends(self, frame: bytes) -> None:
        """The module sends this although no block wants it."""
        self.plant.devices.modules["line1"].send(frame)
        self.run_ms(100)


@pytest.mark.parametrize(
    ("example", "protocol"),
    [("serial", ""), ("serial", "toshiba_ascii"), ("modbus", "")],
    ids=["binary", "ascii", "modbus"],
)
def test_the_generated_blocks_keep_all_of_them(example: str, protocol: str) -> None:
    watched = Watched(example, protocol=protocol)
    watched.run_and_lose_the_drive()
    assert not watched.plant.drives["fan"].running, "it does not start by itself"
    assert watched.broken == {}


@pytest.mark.parametrize(
    ("example", "frame"),
    [
        ("serial", seal(bytes.fromhex("02 50 FA 00 C4 00"))),
        ("serial", seal(bytes.fromhex("FF 57 FA 00 C4 00"))),
        ("modbus", modbus.seal(bytes.fromhex("02 06 FA 00 C4 00"))),
        ("modbus", modbus.seal(bytes.fromhex("00 06 FA 00 C4 00"))),
    ],
)
def test_a_run_command_that_nobody_has_asked_for_is_told(example: str, frame: bytes) -> None:
    watched = Watched(example)
    watched.sends(frame)
    assert "a run command (C400) went out to fan, unasked" in watched.broken["no_command_unasked"]
    assert "the PLC has never put it out like that" in watched.broken["telegrams_asked_for"][0]


def test_bytes_that_are_no_telegram_are_told() -> None:
    watched = Watched("serial")
    watched.sends(b"\x2f\x02\x47")
    assert "2F 02 47 at" in watched.broken["telegrams_asked_for"][0]


def test_a_telegram_that_a_stop_of_the_cpu_cuts_off_is_nobodys_fault() -> None:
    watched = Watched("serial")
    port = watched.plant.devices.modules["line1"].port
    while not port.transmitting:
        watched.run_ms(1)
    watched.run_ms(2)
    watched.plant.cpu.stop()
    watched.run_ms(50)
    watched.look()
    assert watched.broken == {}


def test_a_run_command_without_run_is_told() -> None:
    watched = Watched(
        "serial", ("AND #drive.control.interlock AND NOT #drive.state.inhibited THEN", "THEN")
    )
    watched.set("control.enable", True)
    watched.set("control.run", True)
    watched.run_ms(400)
    watched.set("control.enable", False)
    watched.run_ms(700)
    watched.set("control.reverse", True)
    watched.run_ms(2000)
    assert "unasked" in watched.broken["no_command_unasked"][0]


def test_a_lost_drive_that_is_shown_as_running_is_told() -> None:
    watched = Watched(
        "serial", ("state.running := #drive.polled.valid\n", "state.running := TRUE\n")
    )
    watched.run_and_lose_the_drive()
    assert "fan is shown as running, and it is lost" in watched.broken["lost_is_told"]


def test_more_attempts_than_are_allowed_are_told() -> None:
    watched = Watched("modbus", ("#statAttempt < #retries", "#statAttempt < 9"))
    watched.plant.drives["fan"].power_off()
    watched.run_ms(6000)
    assert "of drive 2 went out 4 times" in watched.broken["repeats_allowed"][0]


def test_a_request_while_a_reply_may_still_come_is_told() -> None:
    watched = Watched("serial", ("#tempLimit := #timeout;", "#tempLimit := T#9ms;"), cycle_ms=2)
    watched.run_ms(1000)
    assert "was over or out of time" in watched.broken["one_telegram_at_once"][0]


def test_a_value_that_nobody_has_answered_is_told() -> None:
    watched = Watched("serial", ("#replyData := #tempData;", "#replyData := 16#1234;"))
    watched.run_ms(1000)
    assert "which nobody answered to it" in watched.broken["values_answered"][0]


@pytest.mark.parametrize(
    ("said", "data", "is_its"),
    [
        (Said(2, 0xFD00, 7), 7, True),
        (Said(2, None, 7), 7, True),
        (Said(2, 0xFD01, 7), 7, False),
        (Said(1, 0xFD00, 7), 7, False),
        (Said(2, 0xFD00, 8), 7, False),
    ],
)
def test_an_answer_belongs_to_what_was_asked(said: Said, data: int, is_its: bool) -> None:
    assert said.answers(Wanted(2, False, 0xFD00, 0), data) is is_its


def test_a_broadcast_is_answered_by_drive_00() -> None:
    wanted = Wanted(0xFF, True, 0xFA00, 0xC000)
    assert Said(0, 0xFA00, 0xC000).answers(wanted, 0xC000)
    assert str(wanted) == "write FA00 = C000 to all drives"
