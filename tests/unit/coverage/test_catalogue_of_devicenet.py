"""Catalogue coverage of DeviceNet: words, lamps, refusals, the parameter channel, c101."""

from pathlib import Path

import pytest

from fbgen.catalog import load_catalog
from fbgen.plant import load_plant
from fbgen.wire.devicenet import Service
from fbgen.wire.devicenet_messages import Request
from harness.installation import Installation, PlantSetup, build_plant
from harness.kernel import NS_PER_MS, NS_PER_S
from harness.verify.coverage import watch
from harness.verify.coverage.catalogue import (
    GATEWAY_WORDS,
    GENERAL_STATUS,
    LAMPS,
    PARAMETER_ERRORS,
    TIMEOUT_ACTIONS,
    TRIPS,
    CatalogueCoverage,
)

SCENARIOS = Path(__file__).parents[2] / "scenarios" / "devicenet"
CATALOG = load_catalog()


def watched(assemblies: str = "101/151") -> tuple[Installation, CatalogueCoverage]:
    """Two drives on a network, the first with these assemblies, three seconds after the start."""
    plan = load_plant(SCENARIOS / "two_channels.yaml", CATALOG)
    network = plan.devicenet[0]
    belt = network.drives[0].model_copy(
        update={"assemblies": assemblies, "settings": {"timeout_action": 2}}
    )
    network = network.model_copy(update={"drives": (belt, *network.drives[1:])})
    plant = build_plant(plan.model_copy(update={"devicenet": (network,)}), CATALOG, PlantSetup())
    coverage = CatalogueCoverage()
    watch(plant, coverage)
    plant.start()
    plant.run_for(3 * NS_PER_S)
    return plant, coverage


def job(plant: Installation, mode: int, number: int, value: int = 0) -> None:
    engine, base = plant.cpu.engine, "TOS_Plant.net1.belt.parameter"
    for name, what in (("mode", mode), ("number", number), ("value", value), ("execute", True)):
        engine.set_global(f"{base}.{name}", what)
    plant.run_for(600 * NS_PER_MS)
    engine.set_global(f"{base}.execute", False)
    plant.run_for(100 * NS_PER_MS)


def seen(coverage: CatalogueCoverage) -> dict[str, set[str]]:
    return {
        group: {item for item, found in items.items() if found}
        for group, items in coverage.items.items()
    }


@pytest.fixture(scope="module")
def found() -> dict[str, set[str]]:
    """A drive runs, is asked for what it does not have, trips, and loses the network."""
    plant, coverage = watched()
    engine = plant.cpu.engine
    engine.set_global("TOS_Plant.net1.belt.control.enable", True)
    engine.set_global("TOS_Plant.net1.belt.control.frequency", 30.0)
    plant.run_for(200 * NS_PER_MS)
    engine.set_global("TOS_Plant.net1.belt.control.run", True)
    job(plant, 1, 0x3FFF)
    job(plant, 2, 0x0009, 0xFFFF)
    for attribute in (b"\x63", b"\x06\x01"):
        request = Request(Service.GET_ATTRIBUTE_SINGLE, 0x29, 1, attribute)
        plant.networks["net1"].scanner.request(4, request, lambda _: None)
    plant.run_for(200 * NS_PER_MS)
    plant.drives["belt"].trip("OC3")
    plant.run_for(200 * NS_PER_MS)
    plant.networks["net1"].trunk.plugged = False
    plant.run_for(2 * NS_PER_S)
    return seen(coverage)


def test_words_go_by_the_instance_of_the_assembly(found: dict[str, set[str]]) -> None:
    words = found[GATEWAY_WORDS]
    assert {f"dev003z.101.extended_control.run_forward = {bit}" for bit in (0, 1)} <= words
    assert {f"dev003z.151.extended_status.running_forward = {bit}" for bit in (0, 1)} <= words
    assert {f"dev003z.151.extended_status.drive_status = {state}" for state in (3, 4)} <= words
    assert "dev003z.101.extended_control.run_reverse = 1" not in words
    assert {f"dev003z.101.index_request.write = {bit}" for bit in (0, 1)} <= words
    assert "dev003z.155.function_response.error = 0" in words


def test_errors_of_the_channel_are_told_by_its_data(found: dict[str, set[str]]) -> None:
    assert found[PARAMETER_ERRORS] == {"dev003z 0001 data", "dev003z 0002 com_no"}


def test_refusals_of_explicit_requests_are_told(found: dict[str, set[str]]) -> None:
    assert found[GENERAL_STATUS] == {"14 attribute not supported", "15 too much data"}


def test_lamps_are_told_by_their_light(found: dict[str, set[str]]) -> None:
    assert found[LAMPS] == {
        *(f"dev003z.module_status = {one}" for one in ("green", "red_green_alternating")),
        "dev003z.module_status = red_flashing",
        *(f"dev003z.network_status = {one}" for one in ("off", "green_flashing", "green")),
        "dev003z.network_status = red_flashing",
    }


def test_what_c101_has_done_is_told(found: dict[str, set[str]]) -> None:
    assert found[TIMEOUT_ACTIONS] == {
        "dev003z c101 = 1: goes on as it was told last",
        "dev003z c101 = 2: deceleration stop",
    }
    assert found[TRIPS] == {"vf-s15 OC3 (03)"}


def test_what_nothing_brings_about_is_not_asked_for() -> None:
    _, coverage = watched("20/70")
    items = {item for group in coverage.items.values() for item in group}
    assert "dev003z.module_status = red" not in items
    assert not any("drive_status = 0" in item for item in items)
    assert "dev003z.20.basic_control.run_forward = 1" in items
    assert not any(item.startswith("dev003z.101.") for item in items), "the words in use"
