"""The text and the checked program of a plant. Tests run many scenarios on one plant, and
generating, reading and checking its text takes longer than simulating a minute of it: so programs
are kept while the process lasts, and texts on disk for the next one."""

from collections import OrderedDict
from collections.abc import Iterator

from fbgen import cache
from fbgen.cache.texts import packed, unpacked
from fbgen.catalog import Catalog
from fbgen.lang.checked import Program
from fbgen.plant import Plant
from fbgen.resources import shipped
from fbgen.source import Source
from harness.engine.loading import read_program

_KEPT = 32
_programs: OrderedDict[str, Program] = OrderedDict()


def generated_sources(plan: Plant, catalog: Catalog) -> list[Source]:
    """What fbgen generates for a plant, in the plant's dialect; lines know where they are from.

    Raises DiagnosticError for what is wrong in the plant; that is never kept.
    """
    return _sources(plan, catalog, _key(plan, catalog))


def generated_program(plan: Plant, catalog: Catalog) -> Program:
    """The program that the generated text of a plant is. Programs never change, so they are shared.

    Raises DiagnosticError for what is wrong in the plant or the text.
    """
    key = _key(plan, catalog)
    if key not in _programs:
        _programs[key] = read_program(_sources(plan, catalog, key), plan.code_dialect)
        while len(_programs) > _KEPT:
            _programs.popitem(last=False)
    _programs.move_to_end(key)
    return _programs[key]


def _sources(plan: Plant, catalog: Catalog, key: str) -> list[Source]:
    if (known := cache.kept(key)) is not None:
        return unpacked(known)
    # A text that is kept needs neither the generator nor the templates.
    from fbgen.emit.generator import generate  # noqa: PLC0415

    sources = [file.source for file in generate(plan, catalog).files if file.is_program]
    cache.keep(key, packed(sources))
    return sources


def _key(plan: Plant, catalog: Catalog) -> str:
    return cache.key_of(_inputs(plan, catalog))


def _inputs(plan: Plant, catalog: Catalog) -> Iterator[str | bytes]:
    """Everything that the text of a plant and the places of its lines depend on.

    Plant and catalogue count twice: as they are, for they may have been changed after they were
    read, and as they were written, for the lines in which something stands.
    """
    yield "text of a plant"
    yield plan.model_dump_json()
    if plan.span is not None:
        yield plan.span.source.name
        yield plan.span.source.text
    for entries in (catalog.drives, catalog.gateways, catalog.protocols, catalog.sequences):
        for entry in entries.values():
            yield entry.model_dump_json()
    for source in catalog.sources:
        yield source.name
        yield source.text
    templates = shipped("templates")
    for path in sorted(templates.rglob("*")):
        if path.is_file():
            yield path.relative_to(templates).as_posix()
            yield path.read_bytes()
