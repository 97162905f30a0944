"""The text and the checked program of a plant. Tests run many scenarios on one plant, and
generating, reading, checking and translating its text takes longer than simulating a minute of it:
so programs are kept while the process lasts, and texts and programs on disk for the next one."""

from collections import OrderedDict
from collections.abc import Iterator

from fbgen import cache
from fbgen.cache.objects import packed_objects, unpacked_objects
from fbgen.cache.texts import packed, unpacked
from fbgen.catalog import Catalog, load_catalog
from fbgen.lang.ast import Block
from fbgen.lang.checked import Program
from fbgen.plant import Plant, buffer_numbers, with_prefix
from fbgen.resources import shipped
from fbgen.source import Source
from harness.engine.compiled import translation
from harness.engine.loading import read_program

_KEPT = 32
_programs: OrderedDict[str, Program] = OrderedDict()
_kept: dict[str, int] = {}
"""How many translations lie on disk, by the key of the program."""


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
        program = _kept_program(key)
        if program is None:
            sources = _sources(plan, catalog, key)
            program = read_program(sources, plan.code_dialect, numbers_in(plan))
        _programs[key] = program
        while len(_programs) > _KEPT:
            _programs.popitem(last=False)
    _programs.move_to_end(key)
    return _programs[key]


def numbers_in(plan: Plant) -> dict[str, int]:
    """The data blocks of the plant that its program names by their numbers."""
    return {with_prefix(name, plan.prefix): n for name, n in buffer_numbers(plan).items()}


def _kept_program(key: str) -> Program | None:
    """The program that another process had, with what it was translated to."""
    data = cache.kept(_place(key))
    if data is None:
        return None
    program: Program
    program, known = unpacked_objects(data)
    translation.share(program, known)
    _kept[key] = len(known)
    return program


def keep_loaded(program: Program) -> None:
    """Keep a program that was generated, with its translations, if there is something new in it."""
    key = next((key for key, one in _programs.items() if one is program), None)
    known = translation.shared(program)
    if key is None or _kept.get(key, 0) >= len(known) or cache.cache_folder() is None:
        return
    _kept[key] = len(known)
    content = packed_objects((program, known), {Block: _head})
    if content is not None:
        cache.keep(_place(key), content)


def _head(syntax: Block) -> tuple[object, ...]:
    """A block as it was written, but without its declarations and statements: what runs was made
    from them, and they are half of a program."""
    return Block, (syntax.span, syntax.kind, syntax.name, None, (), (), ())


def _place(key: str) -> str:
    return f"{key}-program"


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
    yield repr(plan)  # every field; pydantic would first prepare for writing JSON
    if plan.span is not None:
        yield plan.span.source.name
        yield plan.span.source.text
    if catalog is not load_catalog():  # the shipped one is as it was written
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
