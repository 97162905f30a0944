"""The module that a gateway is configured with: the catalogue's, or that of the plant file."""

from typing import TYPE_CHECKING

from fbgen.catalog import Layout, ProcessDataGateway, ProfibusGateway
from fbgen.plant.gsd_file import plugged
from fbgen.wire.profibus import IdentifierError, decode_identifiers, input_length, output_length

if TYPE_CHECKING:
    from fbgen.plant.plant import PlantGateway


def layout_of(part: "PlantGateway", entry: ProfibusGateway) -> Layout:
    """The layout of the plant file, with the identifiers of its GSD file or its own if it has any.

    Identifiers that do not fit, or of a gateway with a line, count as none: FB2025, FB2026, FB2042
    have told them. Raises DiagnosticError FB1105 for a layout that the gateway does not have.
    """
    layout = entry.layout(part.layout)
    if (chosen := plugged(part, entry)) is not None:
        return layout.model_copy(
            update={"identifiers": chosen.code, "unverified": (), "invented": False}
        )
    if part.identifiers is None or not isinstance(entry, ProcessDataGateway):
        return layout
    if why_not(part.identifiers, layout):
        return layout
    return layout.model_copy(update={"identifiers": part.identifiers, "unverified": ()})


def why_not(identifiers: bytes, layout: Layout) -> str:
    """What keeps these identifiers from carrying the data of the layout; "" for nothing."""
    try:
        decoded = decode_identifiers(identifiers)
    except IdentifierError as wrong:
        return str(wrong)
    found = (output_length(decoded), input_length(decoded))
    wanted = (layout.output_length, layout.input_length)
    if found == wanted:
        return ""
    return (
        f"they carry {found[0]} bytes out and {found[1]} in, layout '{layout.name}' has "
        f"{wanted[0]} and {wanted[1]}"
    )
