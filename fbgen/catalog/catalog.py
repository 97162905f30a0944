"""The whole catalogue: drives, gateways, protocols, sequences and manuals, in layers.

The shipped folder is the lowest layer. Folders of the user's own have the same structure; an
entry with the id of a lower one replaces it, which `Catalog.replaced` tells. Sequences that lie
beside a plant file are the highest layer for that plant.
"""

from collections.abc import Iterable, Iterator, Mapping
from collections.abc import Sequence as Row
from dataclasses import field
from functools import cache
from pathlib import Path
from types import MappingProxyType
from typing import TypeVar

from fbgen.cache import remembered
from fbgen.catalog.devicenet_gateways import DeviceNetGateway
from fbgen.catalog.drives import Drive
from fbgen.catalog.gateway_kinds import GATEWAY_KINDS
from fbgen.catalog.gateways import Gateway
from fbgen.catalog.kinds import kind_of
from fbgen.catalog.kinship import relative_of, with_relative
from fbgen.catalog.located import validate
from fbgen.catalog.manuals import Manual
from fbgen.catalog.modbus_protocol import ModbusProtocol
from fbgen.catalog.process_data_gateways import ProcessDataGateway
from fbgen.catalog.profibus_gateways import ProfibusGateway
from fbgen.catalog.protocol_kinds import PROTOCOL_KINDS
from fbgen.catalog.protocols import Protocol, ToshibaProtocol
from fbgen.catalog.references import unresolved
from fbgen.catalog.sequences import Sequence
from fbgen.catalog.telegram_gateways import TelegramGateway
from fbgen.catalog.words import Word
from fbgen.catalog.yaml_nodes import Document, load_yaml
from fbgen.dataclass import dataclass
from fbgen.diagnostics import Diagnostic, DiagnosticError, Note, error
from fbgen.nearest import nearest
from fbgen.resources import shipped
from fbgen.source import Source, Span

Entry = Drive | Gateway | Protocol | Sequence | Manual
KINDS: Mapping[str, type[Entry]] = MappingProxyType(
    {
        "drives": Drive,
        "gateways": Gateway,
        "protocols": Protocol,
        "sequences": Sequence,
        "manuals": Manual,
    }
)
"""Folder name -> model of the files in it."""
_KINDS_OF: Mapping[str, Mapping[str, type[Gateway] | type[Protocol]]] = MappingProxyType(
    {"gateways": GATEWAY_KINDS, "protocols": PROTOCOL_KINDS}
)
"""Folder name -> the kinds of models, where there are several."""
OWN_SEQUENCES = "sequences"
"""The folder beside a plant file in which its own sequences lie."""

EntryType = TypeVar("EntryType", Drive, Gateway, Protocol, Sequence, Manual)
KindType = TypeVar("KindType", bound=Gateway | Protocol)


@dataclass(frozen=True, slots=True)
class Replacement:
    """An entry of a higher layer that took the place of a lower one."""

    kind: str
    id: str
    file: str
    replaced_file: str


@dataclass(frozen=True, slots=True)
class Catalog:
    """All entries by id. `sources` are the files in the order in which they were read."""

    drives: Mapping[str, Drive]
    gateways: Mapping[str, Gateway]
    protocols: Mapping[str, Protocol]
    sequences: Mapping[str, Sequence]
    replaced: tuple[Replacement, ...] = ()
    sources: tuple[Source, ...] = ()
    manuals: Mapping[str, Manual] = field(default_factory=dict)

    def drive(self, name: str) -> Drive:
        """The series of an id. Raises DiagnosticError FB1205 with the nearest ids."""
        return _entry(self.drives, name, "drive series")

    def gateway(self, name: str) -> Gateway:
        """The gateway of an id. Raises DiagnosticError FB1205 with the nearest ids."""
        return _entry(self.gateways, name, "gateway")

    @property
    def profibus_gateways(self) -> Mapping[str, ProfibusGateway]:
        """Those gateways that are slaves on PROFIBUS, of which a plant file is made."""
        known = self.gateways.items()
        return {key: entry for key, entry in known if isinstance(entry, ProfibusGateway)}

    def profibus_gateway(self, name: str) -> ProfibusGateway:
        """The gateway of an id, if it is one on PROFIBUS. Raises FB1205, or FB1206 if not."""
        return _of_kind(self.gateway(name), self.gateways, ProfibusGateway, "PROFIBUS gateway")

    def devicenet_gateway(self, name: str) -> DeviceNetGateway:
        """The gateway of an id, if it is one on DeviceNet. Raises FB1205, or FB1206 if not."""
        return _of_kind(self.gateway(name), self.gateways, DeviceNetGateway, "DeviceNet adapter")

    def telegram_gateway(self, name: str) -> TelegramGateway:
        """The gateway of an id, if it is one for telegrams. Raises FB1205, or FB1206 if not."""
        return _of_kind(self.gateway(name), self.gateways, TelegramGateway, "gateway for telegrams")

    def process_data_gateway(self, name: str) -> ProcessDataGateway:
        """The gateway of an id, if it is one for process data. Raises FB1205, or FB1206 if not."""
        kind = "gateway for process data"
        return _of_kind(self.gateway(name), self.gateways, ProcessDataGateway, kind)

    def protocol(self, name: str) -> Protocol:
        """The protocol of an id. Raises DiagnosticError FB1205 with the nearest ids."""
        return _entry(self.protocols, name, "protocol")

    def toshiba_protocol(self, name: str) -> ToshibaProtocol:
        """The protocol of an id, if it is Toshiba's. Raises FB1205, or FB1206 if not."""
        kind = "Toshiba inverter protocol"
        return _of_kind(self.protocol(name), self.protocols, ToshibaProtocol, kind)

    def modbus_protocol(self, name: str) -> ModbusProtocol:
        """The protocol of an id, if it is MODBUS. Raises FB1205, or FB1206 if not."""
        kind = "MODBUS protocol"
        return _of_kind(self.protocol(name), self.protocols, ModbusProtocol, kind)

    def sequence(self, name: str) -> Sequence:
        """The sequence of an id. Raises DiagnosticError FB1205 with the nearest ids."""
        return _entry(self.sequences, name, "sequence")

    def word(self, path: str) -> Word:
        """The word of `device.word` or `drive.ComNo`, such as `vf-s11.command`, `vf-s11.FA00`.

        Raises DiagnosticError FB1201 with the nearest names.
        """
        device = path.partition(".")[0].lower()
        of_device = dict(self.word_names(device))
        if (word := of_device.get(path.lower())) is not None:
            return word
        shown = of_device or dict(self.word_names())
        raise error("FB1201", f"there is no word '{path}'", help=nearest(path, shown))

    def word_names(self, device: str | None = None) -> Iterator[tuple[str, Word]]:
        """Every word under each of its paths: by name, and in drives by ComNo and its name.

        With the id of a gateway or drive only the words of that one.
        """
        for gateway in _those(self.gateways, device):
            for word in gateway.words:
                yield f"{gateway.id}.{word.name}", word
        for drive in _those(self.drives, device):
            for word in drive.words:
                yield f"{drive.id}.{word.name}", word
            for comno in drive.comnos:
                if comno.word is not None:
                    yield f"{drive.id}.{comno.hex.lower()}", drive.word(comno.word)
                    yield f"{drive.id}.{comno.name}", drive.word(comno.word)


def load_catalog(extra: Row[Path] = ()) -> Catalog:
    """The shipped catalogue with the `extra` folders layered over it, in that order.

    Raises DiagnosticError with everything that is wrong in all files.
    """
    if not extra:
        return _shipped_catalog()
    return _load([(shipped("catalog"), "catalog"), *((folder, str(folder)) for folder in extra)])


@cache
def _shipped_catalog() -> Catalog:
    """Read by an earlier process, if nothing has changed since: reading takes four times as long.

    What is wrong is never kept.
    """
    folder = shipped("catalog")
    return remembered(["catalogue", *_contents(folder)], lambda: _load([(folder, "catalog")]))


def _contents(folder: Path) -> Iterator[str | bytes]:
    """The files of a catalogue and what stands in them."""
    for path in sorted(folder.rglob("*.y*ml")):
        yield path.relative_to(folder).as_posix()
        yield path.read_bytes()


def with_own_sequences(catalog: Catalog, folder: Path) -> Catalog:
    """The catalogue with the sequences in `folder`/sequences over it, if there are any.

    Raises DiagnosticError with everything that is wrong in these files.
    """
    files = sorted((folder / OWN_SEQUENCES).glob("*.y*ml"))
    if not files:
        return catalog
    layers = _Layers(sources=list(catalog.sources), replaced=list(catalog.replaced))
    for kind in KINDS:
        layers.entries[kind] |= getattr(catalog, kind)
    for path in files:
        file = _read(path, folder.as_posix(), path.relative_to(folder), layers)
        if file is not None:
            _enter(file, layers)
    layers.found += unresolved(_catalog(layers), layers.broken)
    if layers.found:
        raise DiagnosticError(layers.found)
    return _catalog(layers)


@dataclass(slots=True)
class _Layers:
    """What has been read so far."""

    entries: dict[str, dict[str, Entry]] = field(default_factory=lambda: {key: {} for key in KINDS})
    sources: list[Source] = field(default_factory=list)
    replaced: list[Replacement] = field(default_factory=list)
    found: list[Diagnostic] = field(default_factory=list)
    broken: set[tuple[str, str]] = field(default_factory=set)
    series: dict[str, Document] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class _File:
    """A file that was read and is no entry yet. `shown` is the catalogue that it lies in."""

    kind: str
    path: Path
    shown: str
    document: Document


def _load(folders: Row[tuple[Path, str]]) -> Catalog:
    layers = _Layers()
    for folder, shown in folders:
        if not folder.is_dir():
            layers.found.append(
                Diagnostic("FB1110", f"the catalogue folder {shown} is not there", None, _STRUCTURE)
            )
            continue
        files = [
            file
            for path in sorted(folder.rglob("*.y*ml"))
            if (file := _read(path, shown, path.relative_to(folder), layers)) is not None
        ]
        for file in _relatives_first(files, layers):
            _enter(file, layers)
    layers.found += unresolved(_catalog(layers), layers.broken)
    if layers.found:
        raise DiagnosticError(layers.found)
    return _catalog(layers)


_STRUCTURE = "a catalogue has the folders " + ", ".join(KINDS) + " with one YAML file an entry"


def _read(path: Path, shown: str, relative: Path, layers: _Layers) -> _File | None:
    """A file as YAML; None if that is wrong. Series are known from now on for those like them."""
    name = f"{shown}/{relative.as_posix()}"
    kind = relative.parts[0] if len(relative.parts) == 2 else ""
    if kind not in KINDS:
        layers.found.append(
            Diagnostic("FB1110", f"{name} lies in no folder of a catalogue", None, _STRUCTURE)
        )
        return None
    try:
        source = read_source(path, name)
        layers.sources.append(source)
        document = load_yaml(source)
    except DiagnosticError as failure:
        layers.found += failure.diagnostics
        layers.broken.add((kind, path.stem))
        return None
    if kind == "drives":
        layers.series[path.stem] = document
    return _File(kind, path, shown, document)


def _relatives_first(files: Row[_File], layers: _Layers) -> Iterator[_File]:
    """The files in an order in which every series comes behind the one that it is like."""
    waiting = {file.path.stem: file for file in files if file.kind == "drives"}
    for file in files:
        row = [file]
        while file.kind == "drives":
            try:
                like = relative_of(row[-1].document, layers.series)
            except DiagnosticError:
                break  # told when the file is entered
            if like is None or like not in waiting:
                break
            row.append(waiting[like])
        for one in reversed(row):
            if one.kind != "drives" or waiting.pop(one.path.stem, None) is not None:
                yield one


def _enter(file: _File, layers: _Layers) -> None:
    """A file as an entry, in the place of one of a lower layer if there is one."""
    kind, path, shown, document = file.kind, file.path, file.shown, file.document
    try:
        like = relative_of(document, layers.series) if kind == "drives" else None
        if like is not None:
            base = layers.entries[kind].get(like)
            if not isinstance(base, Drive):
                layers.broken.add((kind, path.stem))
                return  # what is wrong with that series is told there
            document = with_relative(document, base)
        kinds = _KINDS_OF.get(kind)
        model = KINDS[kind] if kinds is None else kind_of(document, kinds)
        entry = validate(document, model)
    except DiagnosticError as failure:
        layers.found += failure.diagnostics
        layers.broken.add((kind, path.stem))
        return
    if entry.id != path.stem:
        layers.found.append(
            Diagnostic(
                "FB1111",
                f"the entry is called '{entry.id}', its file {path.name}",
                entry.span_of("id"),
                f"call the file {entry.id}.yaml",
            )
        )
    below = layers.entries[kind].get(entry.id)
    if below is not None:
        below_file = _file(below)
        if below_file.startswith(f"{shown}/"):
            note = Note("first here", below.span_of("id"))
            message = f"'{entry.id}' stands twice in one catalogue"
            found = Diagnostic("FB1102", message, entry.span_of("id"), "", (note,))
            layers.found.append(found)
        layers.replaced.append(Replacement(kind, entry.id, document.source.name, below_file))
    layers.entries[kind][entry.id] = entry


def _catalog(layers: _Layers) -> Catalog:
    return Catalog(
        drives=_typed(layers.entries["drives"], Drive),
        gateways=_typed(layers.entries["gateways"], Gateway),
        protocols=_typed(layers.entries["protocols"], Protocol),
        sequences=_typed(layers.entries["sequences"], Sequence),
        replaced=tuple(layers.replaced),
        sources=tuple(layers.sources),
        manuals=_typed(layers.entries["manuals"], Manual),
    )


def _typed(entries: Mapping[str, Entry], kind: type[EntryType]) -> Mapping[str, EntryType]:
    ordered = sorted(entries.items())
    return MappingProxyType({key: entry for key, entry in ordered if isinstance(entry, kind)})


def _file(entry: Entry) -> str:
    span = entry.span
    return span.source.name if span is not None else ""


_NO_YAML = "name a YAML file that you may read; fbgen init writes a plant file to start from"


def read_source(path: Path, name: str) -> Source:
    """The text of a YAML file. Raises DiagnosticError FB1008 if it cannot be read as UTF-8."""
    try:
        data = path.read_bytes()
    except OSError as problem:
        reason = problem.strerror or type(problem).__name__
        raise error("FB1008", f"{name} cannot be read: {reason}", help=_NO_YAML) from None
    try:
        return Source(name, data.decode("utf-8-sig"))
    except UnicodeDecodeError as problem:
        good = Source(name, data[: problem.start].decode("utf-8", "replace"))
        end = len(good.text)
        message = f"the byte {data[problem.start]:02X} behind this place is not UTF-8"
        if data.startswith((b"\xff\xfe", b"\xfe\xff")):
            message = "the file is in UTF-16 (some editors call it Unicode)"
        raise error(
            "FB1008", message, Span(good, max(0, end - 1), end), "save it as UTF-8"
        ) from None


def _those(entries: Mapping[str, EntryType], wanted: str | None) -> Iterable[EntryType]:
    """The entry of an id, if there is one; all of them without an id."""
    if wanted is None:
        return entries.values()
    return [entries[wanted]] if wanted in entries else []


def _entry(entries: Mapping[str, EntryType], name: str, kind: str) -> EntryType:
    if name in entries:
        return entries[name]
    raise error("FB1205", f"there is no {kind} '{name}'", help=nearest(name, entries))


def _of_kind(
    entry: Gateway | Protocol,
    entries: Mapping[str, Gateway] | Mapping[str, Protocol],
    kind: type[KindType],
    title: str,
) -> KindType:
    if isinstance(entry, kind):
        return entry
    others = [item.id for item in entries.values() if isinstance(item, kind)]
    raise error(
        "FB1206",
        f"'{entry.id}' is no {title}",
        help=f"a {title} is {', '.join(others) or 'not in the catalogue'}",
    )
