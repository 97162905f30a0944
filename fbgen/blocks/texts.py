"""Texts for people in the language of a plant.

English stands where a text is used: in templates, in the catalogue, here in the generator. Other
languages stand in `templates/texts/LANGUAGE.yaml`, each text beside its English one; folders of the
user's own templates may have such a file, too. What stands nowhere stays as it is, so a person's
own sequences speak the language in which they were written. Names do not change.
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from functools import cache
from pathlib import Path
from string import Formatter
from types import MappingProxyType
from typing import Annotated, Literal, TypeVar

from pydantic import Field

from fbgen.blocks.literals import one_line
from fbgen.catalog import Catalog, Located, load_yaml, validate
from fbgen.catalog.catalog import read_source
from fbgen.diagnostics import Diagnostic
from fbgen.resources import shipped

_TEXTS = (
    *("title", "meaning", "description", "does_not_protect"),
    *("why", "when", "where", "stands"),
)
"""Fields of the catalogue that are shown in generated blocks and in the lists beside them."""

Entry = TypeVar("Entry", bound=Located)
_LongText = Annotated[str, Field(min_length=1, max_length=4000)]


class Translation(Located):
    """A text in English and in the other language."""

    en: _LongText
    de: _LongText

    def problems(self) -> Iterable[Diagnostic]:
        """FB1112: a translation that cannot stand in the place of its text."""
        reason = ""
        if self.en.count("\n") != self.de.count("\n"):
            reason = (
                f"has {self.de.count(chr(10)) + 1} lines, its text {self.en.count(chr(10)) + 1}"
            )
        elif not self.de.isascii():
            reason = "is not plain ASCII"
        elif sorted(_filled_in(self.en)) != sorted(_filled_in(self.de)):
            reason = "does not have what is filled in into its text"
        if reason:
            yield Diagnostic(
                "FB1112",
                f"the translation {reason}",
                self.span_of("de"),
                "as many lines, ae oe ue ss, and every {...} as in English",
            )


class TranslationFile(Located):
    """All texts of one language."""

    version: Literal[1]
    texts: tuple[Translation, ...]


class Texts:
    """Gives the text in the language of the plant for one in English."""

    def __init__(self, known: Mapping[str, str] = MappingProxyType({})) -> None:
        self._known = known

    def __call__(self, english: str, **values: object) -> str:
        """The text, with the values filled in where there are any."""
        text = self._known.get(english, english)
        return text.format(**values) if values else text

    def __contains__(self, english: str) -> bool:
        return english in self._known

    def in_catalog(self, catalog: Catalog) -> Catalog:
        """The catalogue with its texts in this language; ids and names stay."""
        if not self._known:
            return catalog
        slaves = catalog.profibus_gateways
        return replace(
            catalog,
            gateways={
                **catalog.gateways,
                **{name: self._inside(item) for name, item in slaves.items()},
            },
            drives={name: self._inside(item) for name, item in catalog.drives.items()},
            sequences={name: self._inside(item) for name, item in catalog.sequences.items()},
        )

    def _inside(self, entry: Entry) -> Entry:
        changed: dict[str, object] = {}
        for name in type(entry).model_fields:
            value = getattr(entry, name)
            if name in _TEXTS and isinstance(value, str):
                changed[name] = self._known.get(one_line(value), value)
            elif isinstance(value, Located):
                changed[name] = self._inside(value)
            elif isinstance(value, tuple) and value and isinstance(value[0], Located):
                changed[name] = tuple(self._inside(item) for item in value)
        return entry.model_copy(update=changed)


ENGLISH = Texts()


def texts_in(language: str, folders: Sequence[Path] = ()) -> Texts:
    """The texts of a language: the shipped ones, and over them those of template folders.

    Raises DiagnosticError FB1001 to FB1008 and FB1112 for a file that is wrong.
    """
    if language == "en":
        return ENGLISH
    return _read(language, folders) if folders else _shipped(language)


@cache
def _shipped(language: str) -> Texts:
    return _read(language, ())


def _read(language: str, folders: Sequence[Path]) -> Texts:
    known: dict[str, str] = {}
    for path, name in _files(language, folders):
        file = validate(load_yaml(read_source(path, name)), TranslationFile)
        known |= {item.en: item.de for item in file.texts}
    return Texts(known)


def sources_of(language: str, folders: Sequence[Path] = ()) -> list[str]:
    """The files of a language as texts, for the hash of the inputs."""
    if language == "en":
        return []
    return [read_source(path, name).text for path, name in _files(language, folders)]


def _files(language: str, folders: Sequence[Path]) -> list[tuple[Path, str]]:
    inner = f"texts/{language}.yaml"
    own = [(folder / inner, (folder / inner).as_posix()) for folder in folders]
    there = [(path, name) for path, name in own if path.is_file()]
    return [(shipped("templates") / inner, f"templates/{inner}"), *there]


def _filled_in(text: str) -> list[str]:
    """What stands in braces: Jinja's, or the generator's own."""
    if "{{" in text:
        return [piece.split("}}")[0].strip() for piece in text.split("{{")[1:]]
    return [name for _, name, _, _ in Formatter().parse(text) if name is not None]
