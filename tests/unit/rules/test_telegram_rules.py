"""The rules about telegrams: the generated blocks keep them, what each forbids is told."""

from collections.abc import Sequence
from pathlib import Path

import pytest

from fbgen.catalog import load_catalog
from fbgen.plant import Plant, load_plant
from fbgen.wire.toshiba import seal
from harness.kernel import NS_PER_MS, NS_PER_S
from harness.rules.answers import Answer, belongs
from harness.rules.put_out import PutOuts, Sending
from harness.rules.repeats_allowed import most_attempts
from harness.scenario import prepare, scenario_cases
from tests.unit.rules.watched import WatchedPlant

ROOT = Path(__file__).parents[3]
CATALOG = load_catalog()
READ = "TOS_Plant.gw1.pump.read_status.execute"
ABOUT_TELEGRAMS = (
    "one_telegram_at_once",
    "repeats_allowed",
    "telegrams_asked_for",
    "values_answered",
)


@pytest.fixture(scope="module")
def plan() -> Plant:
    return load_plant(ROOT / "tests" / "scenarios" / "one_drive.yaml", CATALOG)


class Watched(WatchedPlant):
    """A plant of one drive that nobody polls, with what breaks the rules in it."""

    def __init__(self, plan: Plant, changes: Sequence[tuple[str, str]] = ()) -> None:
        super().__init__(plan, CATALOG, ABOUT_TELEGRAMS, changes)
        self.run_ms(200)

    def read(self) -> None:
        """One read of the status word of the drive, from its begin to its end."""
        self.plant.cpu.engine.set_global(READ, True)
        self.run_ms(600)
        self.plant.cpu.engine.set_global(READ, False)
        self.run_ms(50)

    def sends(self, telegram: str) -> None:
        """The gateway sends this although nobody wants it."""
        self.plant.gateways["gw1"].port.transmit(seal(bytes.fromhex(telegram)))
        self.run_ms(50)


def test_the_generated_blocks_keep_all_of_them(plan: Plant) -> None:
    watched = Watched(plan)
    watched.read()
    watched.plant.drives["pump"].power_off()
    watched.read()
    watched.plant.drives["pump"].power_on()
    watched.run_ms(3000)
    watched.read()
    assert watched.plant.gateways["gw1"].telegrams > 5
    assert watched.broken == {}


@pytest.mark.parametrize(
    ("telegram", "message"),
    [
        ("0B50FA00C400", "and the PLC has never put it out like that"),
        ("0B47FC900000", "went out once more without a new trigger"),
    ],
)
def test_a_telegram_that_nobody_has_asked_for_is_told(
    plan: Plant, telegram: str, message: str
) -> None:
    watched = Watched(plan)
    watched.read()
    watched.sends(telegram)
    ((name, texts),) = watched.broken.items()
    assert name == "telegrams_asked_for"
    assert message in texts[0]


def test_a_request_while_a_reply_may_still_come_is_told(plan: Plant) -> None:
    watched = Watched(
        plan,
        [
            ("request.timeout := T#500ms", "request.timeout := T#1ms"),
            ("AND #statTaken AND", "AND NOT #sent AND"),
        ],
    )
    watched.read()
    assert "was over or out of time" in watched.broken["one_telegram_at_once"][0]


def test_a_value_that_was_answered_to_an_earlier_telegram_is_told(plan: Plant) -> None:
    watched = Watched(plan, [("#statSpacers := 1;", "#statSpacers := 0;")])
    watched.read()
    assert "0B 47 FC 90 00 00 gives 0000" in watched.broken["values_answered"][0]


def test_more_attempts_than_are_allowed_are_told(plan: Plant) -> None:
    watched = Watched(plan, [("#statAttempt < #retries", "#statAttempt < 9")])
    watched.plant.drives["pump"].power_off()
    watched.plant.cpu.engine.set_global("TOS_Plant.gw1.pump.stop.execute", True)
    watched.run_ms(3000)
    assert "0B 50 FA 00 C0 00 was put out 4 times" in watched.broken["repeats_allowed"][0]


def test_what_a_gateway_sends_again_unnoticed_is_no_mistake_of_the_plc(tmp_path: Path) -> None:
    """Zeros for 4 ms make the gateway forget its trigger; the PLC sees nothing of it."""
    file = tmp_path / "clear.scenario.yaml"
    file.write_text(
        "version: 1\ntitle: Short zeros\nrules: [telegrams_spaced, one_telegram_at_once]\n"
        f"plant: {(ROOT / 'examples' / 'five_drives' / 'plant.yaml').as_posix()}\nfaults: "
        "[{at: 1 s, lasts: 4 ms, every: 137 ms, until: 4 s, inject: profibus_clear}]\n"
        "steps: [{wait: 5 s}]\n",
        "utf-8",
    )
    run = prepare(scenario_cases(file)[0], CATALOG)
    run.run()
    assert run.installation.spacing["gw1"].too_close, "or it shows nothing"


def test_a_telegram_that_the_gateway_sends_late_is_no_reason_to_wait_longer(tmp_path: Path) -> None:
    """Seed 489 of a campaign: it had been given up, and the next one went out at its usual time."""
    file = tmp_path / "slow.scenario.yaml"
    file.write_text(
        "version: 1\ntitle: A slow gateway\nseed: 489\nrules: [all]\n"
        f"plant: {(ROOT / 'examples' / 'five_drives' / 'plant.yaml').as_posix()}\n"
        "variations: [{dialect: step7, plc: s7-300, access: process_image}]\n"
        "times: {profibus: 1 ms}\n"
        "drives: {drive2: {reply_time: 12 ms}, drive3: {reply_time: 16 ms}}\nfaults:\n"
        "- {at: 1.8 s, lasts: 200 ms, inject: gateway_slow, on: gw1, settings: &slow\n"
        "    {processing_time: 60 ms}}\n"
        "- {at: 2250 ms, lasts: 400 ms, inject: gateway_slow, on: gw1, settings: *slow}\n"
        "steps: [{set: {plc.TOS_Plant.gw1.line.emergencyStop: true}}, {wait: 4 s}]\n",
        "utf-8",
    )
    run = prepare(scenario_cases(file)[0], CATALOG)
    run.run()
    assert run.installation.spacing["gw1"].too_close, "or it shows nothing"


# --- what the rules are made of ---------------------------------------------------------------

RESET, STOP, EEPROM = "01 50 FA 00 E0 00", "01 50 FA 00 C0 00", "01 57 00 09 00 32"


@pytest.mark.parametrize(
    ("telegram", "expected", "most"),
    [
        ("01 47 FE 03 00 00", True, 3),
        ("01 47 FD 01 00 00", True, 5),
        (STOP, True, 3),
        (STOP, False, 1),
        (RESET, True, 1),
        (EEPROM, True, 1),
        ("01 53 FA 01 13 88", True, 1),
    ],
)
def test_only_what_a_drive_may_get_twice_may_go_out_again(
    telegram: str, expected: bool, most: int
) -> None:
    spacers = {0xFC90, 0xFD01, 0xFD00}
    assert most_attempts(bytes.fromhex(telegram), 2, spacers, reply_expected=expected) == most


@pytest.mark.parametrize(
    ("asked", "data", "since_ns", "until_ns", "is_its"),
    [
        ("01 47 FE 03 00 00", 0x1234, 100, 300, True),
        ("01 47 FE 03 00 00", 0x1235, 100, 300, False),
        ("01 47 FE 03 00 00", 0x1234, 101, 300, False),
        ("01 47 FE 03 00 00", 0x1234, 100, 299, False),
        ("01 47 FD 01 00 00", 0x1234, 100, 300, False),
        ("02 47 FE 03 00 00", 0x1234, 100, 300, False),
        ("01 50 FE 03 12 34", 0x1234, 100, 300, False),
    ],
)
def test_a_value_belongs_to_the_telegram_to_which_it_was_answered(
    asked: str, data: int, since_ns: int, until_ns: int, is_its: bool
) -> None:
    for said in ("01 47 FE 03 12 34", "01 67 FE 03 12 34"):
        answers = [Answer(200, 300, bytes.fromhex(said), heard_ns=100)]
        assert belongs(answers, bytes.fromhex(asked), data, since_ns, until_ns) is is_its


@pytest.mark.parametrize("number", ["00", "FF"])
def test_a_broadcast_is_answered_by_drive_00(number: str) -> None:
    answers = [Answer(200, 300, bytes.fromhex(f"{number} 50 FA 00 C0 00"), heard_ns=100)]
    assert belongs(answers, bytes.fromhex("FF 50 FA 00 C0 00"), 0xC000, 0, 300)


def test_a_gateway_may_send_again_only_what_it_has_forgotten() -> None:
    put = PutOuts(processing_ns=5 * NS_PER_MS)
    first, second = b"first ", b"second"
    put.new_trigger(0, first, is_first=False)
    assert put.on_line(first, 6 * NS_PER_MS)[0] is Sending.NEW
    assert put.on_line(first, 20 * NS_PER_MS)[0] is Sending.REPEATED
    put.forgets()
    assert put.on_line(first, 30 * NS_PER_MS)[0] is Sending.RESENT
    assert put.on_line(first, 40 * NS_PER_MS)[0] is Sending.REPEATED
    assert put.on_line(second, 50 * NS_PER_MS)[0] is Sending.FOREIGN
    put.stands(second)
    assert put.on_line(second, 60 * NS_PER_MS)[0] is Sending.REPEATED


def test_what_is_like_the_telegram_before_is_new_with_a_new_trigger() -> None:
    put = PutOuts(processing_ns=5 * NS_PER_MS)
    telegram = b"a read"
    put.new_trigger(0, telegram, is_first=False)
    put.on_line(telegram, 6 * NS_PER_MS)
    put.new_trigger(NS_PER_S, telegram, is_first=False)
    assert put.on_line(telegram, NS_PER_S + 6 * NS_PER_MS)[0] is Sending.NEW
    put.forgets()
    put.new_trigger(2 * NS_PER_S, telegram, is_first=True)
    assert put.on_line(telegram, 2 * NS_PER_S + NS_PER_MS)[0] is Sending.RESENT
    sending, belongs_to = put.on_line(telegram, 2 * NS_PER_S + 9 * NS_PER_MS)
    assert sending is Sending.NEW
    assert belongs_to is not None
    assert belongs_to.is_first
