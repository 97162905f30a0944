"""Finding what a path names in the catalogue, and entries as plain data."""

from collections.abc import Mapping

from pydantic import BaseModel

from fbgen.catalog import Catalog, ComNo, Word
from fbgen.catalog.catalog import Entry
from fbgen.catalog.scalars import BitRange
from fbgen.diagnostics import error
from fbgen.nearest import nearest


def find_entry(catalog: Catalog, name: str) -> Entry:
    """The entry of an id, whatever its kind. Raises DiagnosticError FB9005."""
    entries: dict[str, Entry] = {
        **catalog.manuals,
        **catalog.sequences,
        **catalog.protocols,
        **catalog.gateways,
        **catalog.drives,
    }
    if name.lower() in entries:
        return entries[name.lower()]
    raise error("FB9005", f"the catalogue has no entry '{name}'", None, nearest(name, entries))


def find_part(catalog: Catalog, path: str) -> Word | ComNo:
    """The word of `device.word`, or the ComNo of `drive.ComNo` that is no bit word.

    Raises DiagnosticError FB9005 with the nearest names.
    """
    device = path.lower().partition(".")[0]
    parts = _parts(catalog, device)
    if path.lower() in parts:
        return parts[path.lower()]
    devices = (*catalog.drives, *catalog.gateways)
    known = parts or [name for known_device in devices for name in _parts(catalog, known_device)]
    raise error(
        "FB9005", f"the catalogue has no word or ComNo '{path}'", None, nearest(path, known)
    )


def _parts(catalog: Catalog, device: str) -> dict[str, Word | ComNo]:
    """Words and ComNos of a device by their paths."""
    drive = catalog.drives.get(device)
    comnos = {
        f"{device}.{name.lower()}": comno
        for comno in (() if drive is None else drive.comnos)
        for name in (comno.hex, comno.name)
    }
    return {**comnos, **dict(catalog.word_names(device))}


def as_json(item: BaseModel) -> object:
    """An entry or a part of one as it could stand in JSON.

    Numbers are numbers, bytes are hexadecimal text, bit ranges are written as in YAML.
    """
    return _plain(item.model_dump(exclude_none=True))


def _plain(value: object) -> object:
    if isinstance(value, BitRange):
        return str(value)
    if isinstance(value, bytes):
        return value.hex(" ").upper()
    if isinstance(value, Mapping):
        return {str(key): _plain(item) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [_plain(item) for item in value]
    return value
