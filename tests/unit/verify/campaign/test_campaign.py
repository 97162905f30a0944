"""Campaigns: the same seeds give the same, whoever runs them; failures become short scenarios."""

import json
import sys
from collections.abc import Callable
from pathlib import Path

import pytest
from typer.testing import CliRunner

from fbgen.catalog import load_catalog
from fbgen.cli.program import program_for
from fbgen.diagnostics import DiagnosticError
from harness.scenario import run_case, scenario_cases
from harness.verify.campaign import Campaign, CampaignSettings
from harness.verify.campaign.entries import Entry
from harness.verify.campaign.files import campaign_settings
from harness.verify.campaign.reproduction import reproduce
from harness.verify.campaign.shrinking import minimal, shrink
from harness.verify.campaign.trials import case_from, drawn, try_seeds

ROOT = Path(__file__).parents[4]
BAD = ROOT / "tests" / "unit" / "bad"
ONE = ROOT / "tests" / "scenarios" / "one_drive.yaml"
FAILING = f"""version: 1
title: A gateway that must not lose its supply
plant: {ONE.as_posix()}
faults:
  - {{random: 12, before: 2 s, lasts: 300 ms, kinds: [gateway_unpowered, line_noise, drive_slow]}}
steps:
  - wait: 100 ms
  - wait: 50 ms
  - expect: {{gateway.gw1.powered: true}}
    stays_for: 2 s
"""


@pytest.fixture
def failing(tmp_path: Path) -> CampaignSettings:
    """A scenario that fails with every seed that takes the supply away."""
    file = tmp_path / "supply.scenario.yaml"
    file.write_text(FAILING, encoding="utf-8")
    return campaign_settings([file], [])


def test_the_scenario_of_a_seed_is_always_the_same() -> None:
    settings = campaign_settings([ONE], [])
    assert drawn(settings, 7) == drawn(settings, 7)
    assert drawn(settings, 7) != drawn(settings, 8)


def test_what_is_drawn_can_run() -> None:
    settings = campaign_settings([ONE], [])
    for seed in range(30):
        entry = drawn(settings, seed)
        assert 1 <= len({fault["inject"] for fault in entry["faults"]}) <= 4
        assert 1 <= len(entry["faults"]) <= 8
        case_from(entry, ONE)


def test_ten_seeds_share_a_program_and_the_next_ten_have_another() -> None:
    settings = campaign_settings([ONE], [])
    programs = [drawn(settings, seed)["variations"] for seed in range(30)]
    assert programs[:10] == programs[:1] * 10
    assert len({str(program) for program in programs}) == 3


def test_every_configuration_that_the_plant_allows_is_drawn() -> None:
    settings = campaign_settings([ONE], [])
    entries = [drawn(settings, seed) for seed in range(0, 4000, 10)]
    programs = [entry["variations"][0] for entry in entries]
    expected = {
        "dialect": {"tia", "step7", "iec", "twincat", None},
        "plc": {"s7-1200", "s7-1500", "s7-300", "s7-400", "iec", "twincat", None},
        "access": {"per_identifier", "dpxx_dat", "process_image", None},
        "layout": {"gsd10", "doc9", "whole10", None},
        "cycle_time_ms": {5.0, 20.0, 40.0, None},
    }
    for key, values in expected.items():
        assert {program.get(key) for program in programs} == values, key
    options = {name for program in programs for name in program.get("options", ())}
    assert {"handshake", "trigger_poll", "error_counter", "startup_lock"} <= options
    assert {entry["times"]["profibus"] for entry in entries} == {"1 ms", "2 ms", "3 ms", "5 ms"}
    left = [entry["gateways"]["gw1"] for entry in entries if "gateways" in entry]
    assert {gateway["trigger"] for gateway in left} == {0, 1, 253, 254, 255}
    assert {"16#9F00", "16#5F00", "16#C0FF"} <= {gateway["status"] for gateway in left}
    assert (
        len({entry["drives"]["pump"]["reply_time"] for entry in entries if "drives" in entry}) > 9
    )


def test_only_the_faults_that_are_named_are_drawn() -> None:
    settings = campaign_settings([ONE], ["line_noise", "drive_slow"])
    kinds = {fault["inject"] for seed in range(20) for fault in drawn(settings, seed)["faults"]}
    assert kinds == {"line_noise", "drive_slow"}


def test_seeds_of_the_shipped_blocks_hold_all_rules_and_recover() -> None:
    chunk = try_seeds(campaign_settings([ONE], []), 0, 4)
    assert chunk.failures == ()
    assert chunk.virtual_ns > 0
    assert chunk.configurations == (
        "one_drive.yaml: tia, s7-1200, doc9, process_image, cycle 20 ms",
    )


@pytest.mark.slow
@pytest.mark.parametrize("first", range(0, 200, 20))
def test_many_seeds_of_the_shipped_blocks_hold_all_rules_and_recover(first: int) -> None:
    assert try_seeds(campaign_settings([ONE], []), first, first + 20).failures == ()


def test_two_processes_find_what_one_finds(failing: CampaignSettings, tmp_path: Path) -> None:
    one = Campaign(failing, 8).run(tmp_path / "one.jsonl")
    two = Campaign(failing, 8, workers=2).run(tmp_path / "two.jsonl")
    assert one.seeds == two.seeds == 8
    assert one.virtual_ns == two.virtual_ns
    assert one.failures
    assert one.kinds() == two.kinds()


def test_a_cluster_finds_what_one_process_finds(failing: CampaignSettings, tmp_path: Path) -> None:
    distributed = pytest.importorskip("distributed")
    one = Campaign(failing, 3).run(tmp_path / "one.jsonl")
    with distributed.LocalCluster(
        n_workers=1, threads_per_worker=1, processes=False, dashboard_address=None
    ) as cluster:
        found = Campaign(failing, 3, cluster=cluster.scheduler_address).run(tmp_path / "c.jsonl")
    assert found.kinds() == one.kinds()


def test_a_campaign_that_was_killed_goes_on(failing: CampaignSettings, tmp_path: Path) -> None:
    log = tmp_path / "log.jsonl"
    whole = Campaign(failing, 8).run(log)
    lines = log.read_text("utf-8").splitlines(keepends=True)
    log.write_text("".join(lines[:4]) + lines[4][:20], "utf-8")
    tried: list[int] = []
    again = Campaign(failing, 8).run(log, lambda how: tried.append(how.done))
    assert again.kinds() == whole.kinds()
    assert again.seeds == 8
    assert len(tried) == len(lines) - 4, "what the log has is not tried again"
    assert all(json.loads(line) for line in log.read_text("utf-8").splitlines())


def test_ctrl_c_leaves_what_was_tried(failing: CampaignSettings, tmp_path: Path) -> None:
    log = tmp_path / "log.jsonl"

    def stop(how: object) -> None:
        raise KeyboardInterrupt

    report = Campaign(failing, 8).run(log, stop)
    assert report.interrupted
    assert 0 < report.seeds < 8
    assert Campaign(failing, 8).run(log).seeds == 8


def test_the_log_of_another_campaign_is_refused(failing: CampaignSettings, tmp_path: Path) -> None:
    log = tmp_path / "log.jsonl"
    Campaign(failing, 1).run(log)
    other = CampaignSettings(failing.files, ("line_noise",))
    with pytest.raises(DiagnosticError) as refused:
        Campaign(other, 1).run(log)
    assert [item.code for item in refused.value.diagnostics] == ["FB8072"]


def test_a_failure_becomes_a_short_scenario_that_fails_in_the_same_way(
    failing: CampaignSettings, tmp_path: Path
) -> None:
    failure = Campaign(failing, 8).run(tmp_path / "log.jsonl").failures[0]
    path = reproduce(failing, failure, tmp_path / "found")
    head = path.read_text("utf-8")
    assert f"# Found by seed {failure.seed} of a campaign: as in the file\n" in head
    (case,) = scenario_cases(path)
    assert len(case.scenario.faults) == 1
    assert len(case.scenario.steps) == 1
    result = run_case(case, load_catalog())
    assert [item.code for item in result.failures] == ["FB8001"]


@pytest.mark.parametrize(
    ("needed", "fails"),
    [
        ([3], lambda some: 3 in some),
        ([1, 17], lambda some: {1, 17} <= set(some)),
        ([], lambda some: True),
        (list(range(20)), lambda some: len(some) == 20),
    ],
)
def test_what_is_left_of_a_list_is_what_it_takes(
    needed: list[int], fails: Callable[[list[int]], bool]
) -> None:
    assert minimal(range(20), fails) == needed


def test_settings_are_dropped_and_times_made_round() -> None:
    fault = {"at": "1234567 us", "lasts": "98765 us", "inject": "x", "settings": {"a": 1}}
    entry: Entry = {"faults": [fault], "steps": [{"wait": "2345678 us"}]}

    def fails(tried: Entry) -> bool:
        return len(tried["faults"]) == 1 and tried["faults"][0]["at"].endswith(" ms")

    def always(tried: Entry) -> bool:
        return bool(tried["faults"])

    assert shrink(entry, always) == {
        "faults": [{"at": "1000 ms", "lasts": "1 ms", "inject": "x"}],
        "steps": [{"wait": "2000 ms"}],
    }
    assert shrink(entry, lambda tried: True) == {"steps": [{"wait": "2000 ms"}]}
    assert not fails(entry)


def test_the_plant_becomes_plain_again_as_far_as_it_fails() -> None:
    entry: Entry = {
        "engine": "reference",
        "variations": [{"dialect": "iec", "layout": "doc9", "options": {"handshake": False}}],
        "times": {"profibus": "5 ms", "start": "3 ms"},
        "drives": {"one": {"reply_time": "1 ms"}, "two": {"reply_time": "2 ms"}},
        "gateways": {"gw1": {"trigger": 254}},
        "steps": [{"wait": "1 s"}],
    }

    def fails(tried: Entry) -> bool:
        is_iec = tried.get("variations", [{}])[0].get("dialect") == "iec"
        return is_iec and "two" in tried.get("drives", {})

    assert shrink(entry, fails) == {
        "variations": [{"dialect": "iec"}],
        "drives": {"two": {"reply_time": "2 ms"}},
        "steps": [{"wait": "1000 ms"}],
    }


def test_the_command_tells_what_failed_and_writes_its_file(tmp_path: Path) -> None:
    file = tmp_path / "supply.scenario.yaml"
    file.write_text(FAILING, encoding="utf-8")
    out = tmp_path / "out"
    asked = ["campaign", str(file), "--seeds", "4", "-o", str(out), "--json"]
    run = CliRunner().invoke(program_for(asked), asked)
    assert run.exit_code == 1, run.output
    found = json.loads(run.stdout)
    assert found["seeds"] == 4
    assert found["configurations"] == ["supply.scenario.yaml: as in the file"]
    assert found["failures"][0]["configuration"] == "as in the file"
    assert Path(found["failures"][0]["file"]).is_file()
    assert (out / "log.jsonl").is_file()


def test_an_unknown_fault_is_told_with_the_nearest_name() -> None:
    with pytest.raises(DiagnosticError) as refused:
        campaign_settings([ONE], ["line_nose"])
    (found,) = refused.value.diagnostics
    assert (found.code, "line_noise" in found.help) == ("FB8004", True)


def test_without_an_answer_there_is_no_cluster(failing: CampaignSettings, tmp_path: Path) -> None:
    pytest.importorskip("distributed")
    address = (BAD / "FB8073_no_cluster.txt").read_text("utf-8").strip()
    with pytest.raises(DiagnosticError) as refused:
        Campaign(failing, 1, cluster=address).run(tmp_path / "log.jsonl")
    (found,) = refused.value.diagnostics
    assert found.span is not None
    assert (found.code, found.span.source.name) == ("FB8073", "--cluster")
    assert (found.span.line, found.span.column) == (1, 1)


def test_without_the_package_there_is_no_cluster(
    failing: CampaignSettings, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "distributed", None)
    with pytest.raises(DiagnosticError) as refused:
        Campaign(failing, 1, cluster="tcp://10.0.0.5:8786").run(tmp_path / "log.jsonl")
    (found,) = refused.value.diagnostics
    assert (found.code, found.help) == ("FB8073", "pip install fbgen[cluster]")
