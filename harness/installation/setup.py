"""What a plant file does not say and a simulated plant needs: seed, engine, loads, bus."""

from collections.abc import Mapping, Sequence
from dataclasses import field
from pathlib import Path
from typing import TYPE_CHECKING

from fbgen.dataclass import dataclass
from fbgen.lang.checked import Program
from fbgen.source import Source
from harness.drives import Load
from harness.engine.interface import EngineFactory
from harness.fieldbus import CycleTimes
from harness.gateways.tospbdp001 import Memory
from harness.kernel import NS_PER_MS
from harness.plc import CpuSettings

if TYPE_CHECKING:
    from harness.engine.compiled import ProbeMaker


@dataclass(frozen=True, slots=True)
class DriveConditions:
    """How one drive differs from the one that the plant file describes.

    `load` None is the inverter's own default. `parameters` are physical values by ComNo or name,
    set on top of those of the TOSPBDP001 manual. `reply_time_ns` fixes the reply time.
    `port` is the one at the line, by its name in the catalogue; None is the first.
    """

    load: Load | None = None
    parameters: Mapping[str, float] = field(default_factory=dict)
    reply_time_ns: int | None = None
    port: str | None = None


@dataclass(frozen=True, slots=True)
class PlantSetup:
    """How a plant is simulated.

    `engine` is "compiled" or "reference". `drives` has conditions by the drive's name; `memories`
    what is in a gateway at the start, by its name, for those that had their supply before.
    `sources` are the PLC text, as files or texts; None takes what is generated for the plant. `cpu`
    gives the times of the CPU; its family, cycle and memory come from the plant file. `watchdog_ns`
    is the DP watchdog of every gateway, None for none. The PLC starts `start_after_ns` later than
    the gateways and the bus. `probes` look on while the program runs; only the compiled engine
    takes them. `program` is what `sources` have been read to already, and `factory` loads it
    instead of the engine that is named. `leftovers` is the seed of what temporary variables hold
    before they are written; None where they begin with their defaults.
    """

    seed: int = 0
    engine: str = "compiled"
    drives: Mapping[str, DriveConditions] = field(default_factory=dict)
    memories: Mapping[str, Memory] = field(default_factory=dict)
    sources: Sequence[Path | Source] | None = None
    cpu: CpuSettings = field(default_factory=CpuSettings)
    bus: CycleTimes = field(default_factory=CycleTimes)
    watchdog_ns: int | None = 100 * NS_PER_MS
    start_after_ns: int = 0
    probes: "Sequence[ProbeMaker]" = ()
    program: Program | None = None
    factory: EngineFactory | None = None
    leftovers: int | None = None
