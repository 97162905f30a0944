"""What a site is about: a whole catalogue, or what one plant has of it."""

from collections.abc import Mapping

from fbgen.catalog import Catalog, Drive, Gateway, Protocol, Sequence
from fbgen.dataclass import dataclass
from fbgen.docs.handshake import Handshake
from fbgen.docs.limits import NotModelled
from fbgen.docs.program import PlantProgram
from fbgen.plant import Plant


@dataclass(frozen=True, slots=True)
class Subject:
    """The entries that get pages, by their ids; `plant` is None for the whole catalogue.

    `programs` are those whose blocks get pages: the plant's, or those of examples;
    `handshakes` is what a run has shown of gateways, `not_modelled` what runs leave out.
    """

    title: str
    catalog: Catalog
    gateways: Mapping[str, Gateway]
    drives: Mapping[str, Drive]
    protocols: Mapping[str, Protocol]
    sequences: Mapping[str, Sequence]
    plant: Plant | None = None
    programs: tuple[PlantProgram, ...] = ()
    handshakes: tuple[Handshake, ...] = ()
    not_modelled: tuple[NotModelled, ...] = ()

    @property
    def devices(self) -> tuple[Gateway | Drive, ...]:
        """Gateways, and behind them series of inverters."""
        return (*self.gateways.values(), *self.drives.values())


def whole_catalogue(catalog: Catalog, programs: tuple[PlantProgram, ...] = ()) -> Subject:
    """Everything, with the blocks of some plants."""
    return Subject(
        "Catalogue",
        catalog,
        catalog.gateways,
        catalog.drives,
        catalog.protocols,
        catalog.sequences,
        programs=programs,
    )


def of_plant(plant: Plant, catalog: Catalog, program: PlantProgram | None = None) -> Subject:
    """What the plant has: its types of gateways, its series, their protocols, its sequences."""
    gateways = plant.gateway_types
    series = {drive.series for drive in plant.drives}
    drives = {key: entry for key, entry in catalog.drives.items() if key in series}
    spoken = {entry.protocol for entry in drives.values()}
    spoken |= {line.family for line in plant.serial}
    return Subject(
        plant.name,
        catalog,
        {key: entry for key, entry in catalog.gateways.items() if key in gateways},
        drives,
        {key: entry for key, entry in catalog.protocols.items() if key in spoken},
        {key: entry for key, entry in catalog.sequences.items() if key in set(plant.sequences)},
        plant,
        (program,) if program is not None else (),
    )
