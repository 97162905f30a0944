"""The sequences of a plant as blocks: one of each for all drives on lines."""

from collections.abc import Mapping

from fbgen.blocks.checked_settings import (
    Sheet,
    handed_over,
    sheets,
    spelled_out,
    varying,
)
from fbgen.blocks.literals import SclText
from fbgen.blocks.same_text import as_text
from fbgen.blocks.sequences import ParameterView, SequenceView, sequence_view
from fbgen.blocks.texts import Texts
from fbgen.catalog import Catalog, Sequence
from fbgen.dataclass import dataclass
from fbgen.diagnostics import error
from fbgen.plant import Plant


@dataclass(frozen=True, slots=True)
class PlantSequences:
    """The sequences of a plant.

    `wanted` are the inputs of TOS_Sequences for what parameters are to be, `handed_over` what a
    call of it gives them, by the names of unit and series.
    """

    views: tuple[SequenceView, ...]
    wanted: tuple[ParameterView, ...]
    handed_over: Mapping[tuple[str, str], tuple[SclText, ...]]

    @property
    def context(self) -> dict[str, object]:
        """What templates are told."""
        return {
            "sequences": self.views,
            "wanted": self.wanted,
            "handed_over": self.handed_over,
        }


def sequence_context(plant: Plant, catalog: Catalog, texts: Texts) -> PlantSequences:
    """The sequences of a plant, made for all series that take telegrams.

    Raises DiagnosticError FB5001, and FB1107 for a parameter of which a sheet says nothing.
    """
    known = [catalog.sequence(name) for name in plant.sequences]
    if not known:
        return PlantSequences((), (), {})
    of_plant = sheets(plant, catalog)
    numbers = varying(known, of_plant)
    views = tuple(_view(one, of_plant, numbers, catalog, texts) for one in known)
    inputs = {item.name: item for view in views for item in view.wanted}
    return PlantSequences(
        views,
        tuple(inputs[name] for name in sorted(inputs)),
        handed_over(numbers, of_plant),
    )


def _view(
    sequence: Sequence,
    of_plant: tuple[Sheet, ...],
    numbers: tuple[int, ...],
    catalog: Catalog,
    texts: Texts,
) -> SequenceView:
    first: tuple[SequenceView, Sheet] | None = None
    different = {(sheet.series.id, *sheet.settings): sheet for sheet in of_plant}
    for sheet in different.values():
        said = spelled_out(sequence, sheet, of_plant)
        view = sequence_view(said, sheet, numbers, catalog, texts)
        if first is None:
            first = view, sheet
        elif as_text(view) != as_text(first[0]):
            raise error(
                "FB5001",
                f"the sequence '{sequence.id}' sends other telegrams to '{sheet.series.id}' than "
                f"to '{first[1].series.id}', and one block cannot do both",
                sequence.span,
                "make a sequence of its own for each series",
            )
    assert first is not None, "a plant with sequences has drives on lines"
    return first[0]
