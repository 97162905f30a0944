"""How a PLC gets at cyclic data: what each access way can do, and what not.

One DPRD_DAT or DPWR_DAT (SFC14, SFC15) reaches one identifier (S7-400 CPU Specifications, 10/2006,
7.3). Load and transfer instructions move 1, 2 or 4 bytes that belong together (System and Standard
Functions for S7-300/400, A5E00709327-01, 16.6). Consistent data have 128 bytes at most, 64 words in
special format; normal format says 32, and older CPUs move no more than that (S7-400H manual, 9.3).
"""

from collections.abc import Sequence
from typing import Literal

from fbgen.catalog import AccessWay, PlacedIdentifier, covers_all
from fbgen.dataclass import dataclass
from fbgen.plant.families import Family

OLDER_CPUS_MOVE = 32
"""Consistent bytes that every S7-300 and S7-400 moves by one SFC14 or SFC15; newer ones 128."""

Move = Literal["nothing", "at once", "byte by byte", "word by word", "SFC14/15 only"]
"""How the data of one identifier are moved so that none of them tears."""


@dataclass(frozen=True, slots=True)
class Refusal:
    """Why a PLC cannot reach data by an access way, and what to do instead."""

    message: str
    help: str


def not_a_way(access: AccessWay) -> str:
    """Why these identifiers do not have this access way on any PLC."""
    if access == "dpxx_dat":
        return "no single identifier covers the frame consistently"
    return "one identifier covers the whole frame"


def refusal(
    access: AccessWay, identifiers: Sequence[PlacedIdentifier], family: Family, name: str
) -> Refusal | None:
    """Why PLCs of a family cannot reach data by a way that the identifiers have; None: they can.

    `name` says whose data they are: layout 'gsd10'.
    """
    if access == "dpxx_dat" and not family.whole_frame:
        return Refusal(
            f"{family.title} has no DPRD_DAT and DPWR_DAT",
            "use process_image, or per_identifier where the layout has several identifiers",
        )
    if access == "per_identifier" and not family.peripheral:
        return Refusal(
            f"{family.title} has no direct access to single inputs and outputs",
            "use process_image",
        )
    if access == "per_identifier" and (torn := _only_as_a_whole(identifiers)):
        return Refusal(
            f"{torn} bytes of {name} are consistent as a whole, and no single access moves so many",
            "choose a module whose identifiers are consistent by words, or one that a single "
            "identifier covers in both directions",
        )
    whole = covers_all(identifiers)
    if access == "process_image" and whole and not family.image_moves_whole:
        return Refusal(
            f"the process image of {family.title} cannot hold the consistent data of {name}",
            "use dpxx_dat",
        )
    if access == "dpxx_dat" and family.hardware_identifiers and not whole and len(identifiers) > 1:
        return Refusal(
            f"{name} has {len(identifiers)} modules, each with a hardware identifier of its own on "
            f"{family.title}",
            "choose a module that one identifier covers in both directions, or process_image",
        )
    return None


def move_of(identifier: PlacedIdentifier) -> Move:
    """How the data of one identifier are moved without tearing."""
    lengths = _lengths(identifier)
    if not lengths:
        return "nothing"
    if identifier.consistent:
        return "SFC14/15 only" if any(map(_needs_block_move, lengths)) else "at once"
    if max(lengths) == identifier.unit_length:
        return "at once"
    return "word by word" if identifier.unit_length == 2 else "byte by byte"


def _only_as_a_whole(identifiers: Sequence[PlacedIdentifier]) -> int:
    """The length of an identifier that only DPRD_DAT and DPWR_DAT can move; 0 for none."""
    lengths = [length for item in identifiers if item.consistent for length in _lengths(item)]
    return max(filter(_needs_block_move, lengths), default=0)


def _needs_block_move(length: int) -> bool:
    return length == 3 or length > 4


def _lengths(identifier: PlacedIdentifier) -> list[int]:
    return [one for one in (identifier.output_length, identifier.input_length) if one]
