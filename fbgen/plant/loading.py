"""Plant files -> `Plant`."""

from collections.abc import Iterator
from pathlib import Path

from fbgen.cache import remembered
from fbgen.catalog import Catalog, load_catalog, load_yaml, validate
from fbgen.catalog.catalog import read_source
from fbgen.catalog.yaml_nodes import Document, YamlMapping, YamlSequence
from fbgen.plant.gsd_file import gsd_file, layout_named_by
from fbgen.plant.plant import Plant
from fbgen.source import Source


def load_plant(path: Path, catalog: Catalog | None = None) -> Plant:
    """The plant in a file, checked against the catalogue (the shipped one if none is given).

    An earlier process may have read it, if it was with the shipped catalogue.
    Raises DiagnosticError with everything that is wrong: FB1001 to FB1008, FB2001 to FB2019.
    """
    source = read_source(path, path.as_posix())
    shipped = load_catalog()
    if catalog is not None and catalog is not shipped:
        return read_plant(source, catalog)
    parts = ("plant", source.name, source.text)
    known = (text for file in shipped.sources for text in (file.name, file.text))
    return remembered((*parts, *known), lambda: read_plant(source, shipped), _stands_for_itself)


def _stands_for_itself(plant: Plant) -> bool:
    """Whether nothing of it stands in a GSD file, which may become another one."""
    return all(gateway.gsd is None for gateway in plant.gateways)


def read_plant(source: Source, catalog: Catalog | None = None) -> Plant:
    """The plant in a text; otherwise as `load_plant`. GSD files are looked for where its name says
    that the text stands."""
    known = catalog if catalog is not None else load_catalog()
    document = load_yaml(source)
    for gateway in _with_gsd(document):
        _read_gsd(gateway, Path(source.name).parent, known)
    return validate(document, Plant, known)


def _with_gsd(document: Document) -> Iterator[YamlMapping]:
    """The gateways that name a GSD file."""
    plant = document.data
    gateways = plant.get("gateways") if isinstance(plant, YamlMapping) else None
    for gateway in gateways if isinstance(gateways, YamlSequence) else ():
        if isinstance(gateway, YamlMapping) and isinstance(gateway.get("gsd"), str):
            yield gateway


def _read_gsd(gateway: YamlMapping, folder: Path, catalog: Catalog) -> None:
    """Put the file in the place of its name, and the layout that it says where none is written."""
    file = gsd_file(str(gateway["gsd"]), folder, gateway.value_spans["gsd"])
    gateway["gsd"] = file
    if gateway.get("layout"):
        return
    entry = catalog.profibus_gateways.get(str(gateway.get("type")))
    names = gateway.get("modules")
    modules = [str(name) for name in names] if isinstance(names, YamlSequence) else []
    if entry is None or file.station is None:
        gateway["layout"] = ""
    else:
        gateway["layout"] = layout_named_by(file.station, modules, entry)
