"""How often what there is in a file was reached, and which vectors its decisions have had."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from harness.engine.compiled.expressions.decisions import Results
from harness.verify.coverage.model import BlockPlaces, Branching, DecisionPlace, FileKey, Place


class FileCounts:
    """One file: `hits` of all statements and outcomes, `vectors` of all decisions, in their order.

    The order is block by block; in each block the statements come before the outcomes. `plants` are
    the plants whose text it was; empty for a file of the user's own.
    """

    __slots__ = ("blocks", "hits", "key", "plants", "vectors")

    def __init__(self, key: FileKey, blocks: Sequence[BlockPlaces]) -> None:
        self.key = key
        self.blocks = tuple(blocks)
        self.hits = [0] * sum(map(_slots, blocks))
        self.vectors = [Results(one.tree) for block in blocks for one in block.decisions]
        self.plants: set[str] = set()

    def __reduce__(self) -> tuple[object, ...]:
        """For other processes, which keep what there is in a file only once."""
        return _restored, (self.key, self.blocks, self.hits, self.vectors, self.plants)

    def add(self, other: "FileCounts") -> None:
        """Take over what another run of the same file has reached."""
        self.hits[:] = map(int.__add__, self.hits, other.hits)
        for mine, more in zip(self.vectors, other.vectors, strict=True):
            mine.update(more)
        self.plants |= other.plants

    def of_blocks(self) -> "Iterator[BlockCounts]":
        """The counts of each block."""
        at = decided = 0
        for block in self.blocks:
            statements = len(block.statements)
            hits = self.hits[at : at + _slots(block)]
            vectors = self.vectors[decided : decided + len(block.decisions)]
            at += len(hits)
            decided += len(vectors)
            yield BlockCounts(
                self.key,
                block,
                hits[:statements],
                hits[statements:],
                vectors,
                frozenset(self.plants),
            )


class BlockKey(NamedTuple):
    """Blocks are the same if all of this is the same; `text` are the lines that it stands in.

    `sizes` are the numbers of statements, outcomes and conditions: what is constant in one program
    need not be so in another one.
    """

    name: str
    dialect: str
    text: str
    sizes: tuple[int, ...]


class BlockCounts(NamedTuple):
    """What was reached in one block; `plants` are those whose text it is."""

    file: FileKey
    places: BlockPlaces
    statement_hits: Sequence[int]
    outcome_hits: Sequence[int]
    vectors: Sequence[Results]
    plants: frozenset[str]

    @property
    def key(self) -> BlockKey:
        """What block it is."""
        sizes = (
            len(self.statement_hits),
            len(self.outcome_hits),
            *(len(decision.conditions) for decision in self.places.decisions),
        )
        return BlockKey(self.places.name, self.file.dialect, "\n".join(self.lines), sizes)

    @property
    def lines(self) -> list[str]:
        """The text of the block, line by line."""
        first, last = self.places.place.line, self.places.place.end_line
        return self.file.text.split("\n")[first - 1 : last]

    def plus(self, other: "BlockCounts") -> "BlockCounts":
        """Together with the same block in another file."""
        return self._replace(
            statement_hits=list(map(int.__add__, self.statement_hits, other.statement_hits)),
            outcome_hits=list(map(int.__add__, self.outcome_hits, other.outcome_hits)),
            vectors=[one.plus(more) for one, more in zip(self.vectors, other.vectors, strict=True)],
            plants=self.plants | other.plants,
        )

    def statements(self) -> Iterator[tuple[Place, int]]:
        """Each statement with how often it ran."""
        return zip(self.places.statements, self.statement_hits, strict=True)

    def branchings(self) -> Iterator[tuple[Branching, Sequence[int]]]:
        """Each branching with how often each of its outcomes was taken."""
        at = 0
        for branching in self.places.branchings:
            count = len(branching.outcomes)
            yield branching, self.outcome_hits[at : at + count]
            at += count

    def decisions(self) -> Iterator[tuple[DecisionPlace, Results]]:
        """Each decision with its vectors."""
        return zip(self.places.decisions, self.vectors, strict=True)


def _slots(block: BlockPlaces) -> int:
    return len(block.statements) + sum(len(one.outcomes) for one in block.branchings)


_known: dict[FileKey, tuple[BlockPlaces, ...]] = {}
"""What there is in a file, once for each file: the runs of many processes have the same."""


def _restored(
    key: FileKey,
    blocks: tuple[BlockPlaces, ...],
    hits: list[int],
    vectors: list[Results],
    plants: set[str],
) -> FileCounts:
    counts = FileCounts(key, _known.setdefault(key, blocks))
    counts.hits, counts.vectors, counts.plants = hits, vectors, plants
    return counts
