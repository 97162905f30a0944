"""Whatever the phase between the CPU's scan and the PROFIBUS cycle, a telegram stays whole.

The direct accesses of one scan lie a few microseconds apart. A bus cycle may fall between any two
of them, so the gateway may see a frame of which only a part is new. The trigger goes last, so what
it forwards is whole all the same, and what the PLC takes for the reply is the reply.
"""

from collections.abc import Iterable, Iterator
from pathlib import Path

import pytest

from fbgen.catalog import load_catalog
from fbgen.plant import Plant, load_plant
from fbgen.source import Source
from harness.fieldbus import CycleTimes
from harness.installation import PlantSetup, build_plant, generated_sources
from harness.kernel import NS_PER_MS, NS_PER_US

EXAMPLE = Path(__file__).parents[2] / "examples" / "manual_example" / "plant.yaml"
# The read of FC90 that goes out first (docs/decisions/0016), then the commands of the manual.
SENT = ("0B47FC900000", "0B50FA00C400", "0B50FA011388", "0B47FE030000", "0B50FA00C200")
SCAN_NS = 10 * NS_PER_MS


def example(layout: str) -> Plant:
    plant = load_plant(EXAMPLE, load_catalog())
    gateways = tuple(item.model_copy(update={"layout": layout}) for item in plant.gateways)
    return plant.model_copy(update={"gateways": gateways})


def sent_at(
    phases_us: Iterable[int], plant: Plant, sources: list[Source] | None = None
) -> Iterator[tuple[str, ...]]:
    """What the gateway sends to the drive in each phase, from the supply of the PLC on."""
    installation = build_plant(plant, load_catalog(), PlantSetup(sources=sources))
    kernel, gateway = installation.kernel, installation.gateways["gw1"]
    recorder = installation.record_telegrams()["gw1"]
    for phase_us in phases_us:
        installation.cpu.power_off()
        gateway.power_off()
        installation.run_for(300 * NS_PER_MS)
        times = CycleTimes(period_ns=SCAN_NS, phase_ns=phase_us * NS_PER_US)
        installation.master.set_times(times)
        kernel.run_until(-(-kernel.now_ns // SCAN_NS) * SCAN_NS)
        before = len(recorder.records)
        installation.start()
        installation.run_for(100 * NS_PER_MS)
        installation.cpu.engine.set_global("TOS_Plant.gw1.drive11.manual_example.execute", True)
        installation.run_for(600 * NS_PER_MS)
        yield tuple(
            frame.data[1:-1].hex().upper()
            for record in recorder.records[before:]
            for frame in record.frames
            if frame.to_drives
        )


@pytest.mark.parametrize("layout", ["gsd10", "doc9"])
def test_every_frame_is_whole_wherever_the_bus_cycle_falls(layout: str) -> None:
    plant = example(layout)
    for phase_us, sent in enumerate(sent_at(range(60), plant)):
        assert sent == SENT, f"phase {phase_us} us"


def test_with_the_trigger_in_front_some_frame_is_torn() -> None:
    """The same sweep finds the mistake that the order of the accesses avoids."""
    plant = example("gsd10")
    trigger = "      %QB258:P := #frameOut.trigger;\n"
    first = "      %QW264:P := #frameOut.data;\n"
    sources = [
        Source(item.name, item.text.replace(trigger, "").replace(first, trigger + first))
        for item in generated_sources(plant, load_catalog())
    ]
    assert set(sent_at(range(0, 60, 2), plant, sources)) != {SENT}
