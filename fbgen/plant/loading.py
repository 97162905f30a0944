"""Plant files -> `Plant`."""

from pathlib import Path

from fbgen.catalog import Catalog, load_catalog, load_yaml, validate
from fbgen.catalog.catalog import read_source
from fbgen.plant.plant import Plant
from fbgen.source import Source


def load_plant(path: Path, catalog: Catalog | None = None) -> Plant:
    """The plant in a file, checked against the catalogue (the shipped one if none is given).

    Raises DiagnosticError with everything that is wrong: FB1001 to FB1008, FB2001 to FB2019.
    """
    return read_plant(read_source(path, path.as_posix()), catalog)


def read_plant(source: Source, catalog: Catalog | None = None) -> Plant:
    """The plant in a text; otherwise as `load_plant`."""
    known = catalog if catalog is not None else load_catalog()
    return validate(load_yaml(source), Plant, known)
