"""Who wrote a value: the statement of the PLC, with the instance of the block that ran it.

Only an engine with `writers` knows (`harness.engine.compiled.writers_probe`). A value that changed
without a note since its last change was written through a pointer; then nobody is named.
"""

from harness.engine.compiled import CompiledEngine
from harness.engine.compiled.data.memory import Location
from harness.engine.compiled.watching.last_writes import instance_name
from harness.engine.compiled.watching.writers import Entry, Writers
from harness.engine.interface import Engine
from harness.fieldbus import Station
from harness.plc import Cpu
from harness.trace.places import Places, place_of


def who_wrote(cpu: Cpu, places: Places) -> "WhoWrote | None":
    """What a CPU's engine knows of writers; None if it was loaded without them."""
    engine: Engine = cpu.engine
    if isinstance(engine, CompiledEngine) and engine.writers is not None:
        return WhoWrote(cpu, engine, engine.writers, places)
    return None


class WhoWrote:
    """Names the places of statements by their numbers in `places`."""

    def __init__(self, cpu: Cpu, engine: CompiledEngine, writers: Writers, places: Places) -> None:
        self._cpu = cpu
        self._engine = engine
        self._writers = writers
        self._places = places
        self._numbers: dict[tuple[int, int], int] = {}

    def variable(self, path: str) -> "VariableWriter | None":
        """Who writes a variable; None for one that is reached by an address."""
        where = self._engine.location(path)
        if not isinstance(where, Location) or where.key is None:
            return None
        return VariableWriter(self, self._writers, where.owner, where.key)

    def output(self, station: Station, offset: int) -> int | None:
        """Who wrote this byte of a station's outputs last."""
        modules, writers = self._cpu.modules, self._writers
        for laddr, entries in writers.records.items():
            there, slot = modules.writable.get(laddr, (None, None))
            if there is station and slot is not None:
                at = offset - (slot.output_offset or 0)
                if 0 <= at < len(entries):
                    return self.number(entries[at])
        return self.output_byte(station.settings.output_address + offset)

    def output_byte(self, address: int) -> int | None:
        """Who wrote this byte of the outputs of the PLC last."""
        return self.number(self._writers.outputs.get(address))

    def number(self, entry: Entry | None) -> int | None:
        """The number of an entry's place; None for none."""
        if entry is None:
            return None
        statement, instance = entry
        key = statement, id(instance)
        if key not in self._numbers:
            found = self._writers.statements[statement]
            name = instance_name(self._engine, self._writers, instance)
            place = place_of(found.span, found.block.name, name)
            self._numbers[key] = self._places.number(place)
        return self._numbers[key]


class VariableWriter:
    """Tells who wrote one variable."""

    __slots__ = ("_key", "_owner", "_seen", "_who", "_writers")

    def __init__(self, who: WhoWrote, writers: Writers, owner: object, key: str | int) -> None:
        self._who = who
        self._writers = writers
        self._owner = owner
        self._key = key
        self._seen: Entry | None = None

    def of_change(self) -> int | None:
        """The place of the write that has just changed it; None if that was not noted."""
        entry = self._writers.of(self._owner, self._key)
        if entry is self._seen:
            return None
        self._seen = entry
        return self._who.number(entry)

    def last(self) -> int | None:
        """The place of the last write, whether it changed the value or not."""
        return self._who.number(self._writers.of(self._owner, self._key))
