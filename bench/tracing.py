"""The yardstick plant with everything recorded: every change, frame and telegram, and who wrote it;
plants on DeviceNet and on a serial line as well.

The figure is the processor time for one second of the plant's own time, as in `bench.yardstick`; a
drive ramps up and down meanwhile. 100 times real time is 10 ms. A recorder keeps all that it has
seen, so each window goes on with the same one.
"""

from collections.abc import Iterator, Sequence
from pathlib import Path

from bench.measuring import Figure, measure
from harness.engine.compiled import ProbeMaker, writers_probe
from harness.installation import Installation, PlantSetup, plant
from harness.kernel import NS_PER_S
from harness.trace import Recorder, Trace, trace_text
from harness.trace.vcd import vcd_text

_EXAMPLES = Path(__file__).parents[1] / "examples"
_PLANT = _EXAMPLES / "five_drives" / "plant.yaml"
_WARM_UP_NS = 3 * NS_PER_S
_CONTROL = "TOS_Plant.gw1.drive1.control"
_WINDOWS, _FEW_WINDOWS = 100, 20
_WRITTEN_NS = 5 * NS_PER_S


def figures() -> Iterator[Figure]:
    """A second of the plant with and without writers; writing what came of it."""
    for name, probes in (
        ("1 s of the yardstick plant, recorded", ()),
        ("the same with who wrote what", (writers_probe,)),
    ):
        installation, _ = _running(probes)
        second = measure(name, lambda at=installation: _second(at), windows=_WINDOWS)
        limit = f"{1 / second.seconds:.0f} times real time, at least 100"
        yield Figure(name, second.seconds, second.turns, limit)
    for name, made in (
        ("1 s of examples/devicenet, recorded", _on_devicenet()),
        ("1 s of examples/serial, recorded", _on_serial()),
    ):
        made.record()
        made.start()
        made.run_for(_WARM_UP_NS)
        second = measure(name, lambda at=made: at.run_for(NS_PER_S), windows=_FEW_WINDOWS)
        real = f"{1 / second.seconds:.0f} times real time"
        yield Figure(name, second.seconds, second.turns, real)
    installation, recorder = _running((writers_probe,))
    installation.run_for(_WRITTEN_NS)
    trace = recorder.finish()
    changes = len(trace.changes)
    for name, write in (("JSON Lines", _json), ("VCD", vcd_text)):
        title = f"writing one change as {name}"
        yield measure(title, lambda made=write: made(trace), per=changes, windows=20)


def _on_devicenet() -> Installation:
    """With the program of the example: one drive polled, one that sends by itself beside."""
    folder = _EXAMPLES / "devicenet"
    setup = PlantSetup(sources=[folder / "conveyors.scl"], probes=[writers_probe])
    return plant(folder / "plant.yaml", setup)


def _on_serial() -> Installation:
    return plant(_EXAMPLES / "serial" / "plant.yaml", PlantSetup(probes=[writers_probe]))


def _json(trace: Trace) -> str:
    return trace_text([trace])


def _running(probes: Sequence[ProbeMaker]) -> tuple[Installation, Recorder]:
    installation = plant(_PLANT, PlantSetup(probes=probes))
    recorder = installation.record()
    installation.start()
    installation.cpu.engine.set_global(f"{_CONTROL}.enable", True)
    installation.cpu.engine.set_global(f"{_CONTROL}.run", True)
    installation.run_for(_WARM_UP_NS)
    return installation, recorder


def _second(installation: Installation) -> None:
    """A second of the plant; the set-point is now 10 and now 40 Hz."""
    engine = installation.cpu.engine
    low = engine.global_value(f"{_CONTROL}.frequency") != 10.0
    engine.set_global(f"{_CONTROL}.frequency", 10.0 if low else 40.0)
    installation.run_for(NS_PER_S)
