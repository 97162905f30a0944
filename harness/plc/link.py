"""The way of the bytes between the CPU and the master's image, and how it gets torn.

CPU and master are consistent with each other only as far as one configuration identifier says: over
its whole length, or over one byte or word of it. Whatever moves more moves piece by piece in
ascending order, and the master's cycle may fall between two pieces. It does so on demand
(`tear_next_write`, `tear_next_read`) or with a probability, by the plant's seed.
"""

from random import Random

from fbgen.diagnostics import error
from fbgen.wire.profibus import Extent
from harness.fieldbus import DpMaster
from harness.plc.io_module import IoModule


class MasterLink:
    """Moves bytes to and from the master. `armed` is False as long as nothing can be torn."""

    __slots__ = ("_master", "_probability", "_random", "_reads", "_writes", "armed", "torn")

    def __init__(self, master: DpMaster, random: Random, tear_probability: float = 0.0) -> None:
        self._master = master
        self._random = random
        self._probability = tear_probability
        self._reads: dict[IoModule, int] = {}
        self._writes: dict[IoModule, int] = {}
        self.torn = 0
        self.armed = tear_probability > 0

    @property
    def tear_probability(self) -> float:
        """The probability with which a transfer that can be torn is torn; it may change."""
        return self._probability

    @tear_probability.setter
    def tear_probability(self, probability: float) -> None:
        self._probability = probability
        self.armed = bool(probability > 0 or self._reads or self._writes)

    def tear_next_write(self, station: IoModule, behind: int) -> None:
        """Let the master's cycle fall behind slot `behind` in the next change of outputs there.

        Slots count from 1. Raises DiagnosticError FB7403 where no outputs follow.
        """
        self._writes[station] = _first_behind(station, behind, _output_pieces(station), "outputs")
        self.armed = True

    def tear_next_read(self, station: IoModule, behind: int) -> None:
        """The same for the next reading of inputs that have changed since the latest cycle."""
        self._reads[station] = _first_behind(station, behind, _input_pieces(station), "inputs")
        self.armed = True

    def next_cycle_ns(self, time_ns: int) -> int:
        """The instant of the first bus cycle that is later than `time_ns`."""
        return self._master.next_cycle_ns(time_ns)

    def write(self, station: IoModule, offset: int, data: bytes) -> None:
        """Outputs from the CPU to the master."""
        if self.armed and station.outputs[offset : offset + len(data)] != data:
            cut = self._cut(station, offset, len(data), _output_pieces(station), self._writes)
            if cut is not None:
                station.write(offset, data[: cut - offset])
                self._master.cycle()
                station.write(cut, data[cut - offset :])
                return
        station.write(offset, data)

    def read(self, station: IoModule, offset: int, length: int) -> bytes:
        """Inputs from the master to the CPU."""
        end = offset + length
        if self.armed and station.inputs_pending:
            cut = self._cut(station, offset, length, _input_pieces(station), self._reads)
            if cut is not None:
                before = bytes(station.inputs[offset:cut])
                self._master.cycle()
                return before + station.inputs[cut:end]
        return bytes(station.inputs[offset:end])

    def _cut(
        self,
        station: IoModule,
        offset: int,
        length: int,
        pieces: list[int],
        orders: dict[IoModule, int],
    ) -> int | None:
        """Where to tear the bytes from `offset` on; None for not at all."""
        ordered = orders.get(station)
        if ordered is not None and offset < ordered < offset + length:
            del orders[station]
            self.armed = bool(self._probability > 0 or self._reads or self._writes)
            self.torn += 1
            return ordered
        if self._probability <= 0 or self._random.random() >= self._probability:
            return None
        places = [place for place in pieces if offset < place < offset + length]
        if not places:
            return None
        self.torn += 1
        return self._random.choice(places)


def _output_pieces(station: IoModule) -> list[int]:
    return _pieces([(slot.output_offset, slot.identifier.outputs) for slot in station.slots])


def _input_pieces(station: IoModule) -> list[int]:
    return _pieces([(slot.input_offset, slot.identifier.inputs) for slot in station.slots])


def _pieces(parts: list[tuple[int | None, Extent | None]]) -> list[int]:
    """Offsets at which a consistent piece begins."""
    return [
        begin
        for offset, extent in parts
        if offset is not None and extent is not None
        for begin in range(offset, offset + extent.length, extent.consistent_bytes)
    ]


def _first_behind(station: IoModule, behind: int, pieces: list[int], what: str) -> int:
    if 1 <= behind <= len(station.slots):
        slot = station.slots[behind - 1]
        first = slot.output_offset if what == "outputs" else slot.input_offset
        length = (
            slot.identifier.output_length if what == "outputs" else slot.identifier.input_length
        )
        if first is not None and first + length in pieces:
            return first + length
    raise error(
        "FB7403",
        f"the {what} of station '{station.settings.name}' cannot be torn behind slot {behind}",
        None,
        f"the station has {len(station.slots)} slots; {what} must lie in this one and behind it",
    )
