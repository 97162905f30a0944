"""Whether the names in the code of twins mean in each what they mean in the model.

They do if every exchanged name that stands in code is declared by the model, and no other unit than
those of the two gateways declares a name like it, or like what it becomes: for the declarations of
the two are alike, and all other names are the same.
"""

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence

from fbgen.emit.exchanged_words import is_address, words_of
from fbgen.emit.name_lengths import declared
from fbgen.emit.twins import GatewayModel, GatewayTwins, Parts, Twin
from fbgen.lang import ast

_NO_CODE = re.compile(
    r"//[^\n]*|\(\*.*?\*\)|'(?:[^'$\n]|\$.)*'|^[ \t]*TITLE\b[^\n]*", re.DOTALL | re.MULTILINE
)


def of_one_meaning(found: Sequence[GatewayTwins], files: Mapping[str, ast.File]) -> Iterator[Twin]:
    """The twins whose names mean what those of their models mean.

    `files` are the trees of all units but the twins, by the names of their sources.
    """
    models = {item.model.gateway: item.model for item in found}
    names = {gateway: _Names(model, files) for gateway, model in models.items()}
    owners: dict[str, set[str]] = {}
    theirs = {unit.source.name for item in found for unit in (*item.units, *item.model.units)}
    others = [file for name, file in files.items() if name not in theirs]
    for name in _lower_case(declared(others)):
        owners.setdefault(name, set()).add("")
    for model, known in names.items():
        for name in known.declared:
            owners.setdefault(name, set()).add(model)
    for item in found:
        words = {before.casefold(): after.casefold() for before, after in item.words.items()}
        for name in names[item.model.gateway].declared:
            owners.setdefault(words.get(name, name), set()).add(item.gateway)
    for item in found:
        used = names[item.model.gateway].exchanged_in_code(item.words)
        both = {item.gateway, item.model.gateway}
        if used is not None and all(owners.get(name, both) <= both for name in used):
            yield from item.twins


class _Names:
    """The names that a model declares, and those in its text without comments, in lower case."""

    def __init__(self, model: GatewayModel, files: Mapping[str, ast.File]) -> None:
        trees = [files[unit.source.name] for unit in model.units]
        self.declared = set(_lower_case(declared(trees)))
        self._used = {
            word
            for part in model.parts
            for word in words_of(_NO_CODE.sub(" ", part.declarations + part.code))
        }
        self._is_as_it_looks = all(map(_is_divided_so, trees, model.parts))

    def exchanged_in_code(self, words: Mapping[str, str]) -> set[str] | None:
        """The names that are exchanged in code, with what they become; None if one of them is not
        declared by the model."""
        used = {
            before.casefold(): after.casefold()
            for before, after in words.items()
            if before.casefold() in self._used and not is_address(before)
        }
        if not self._is_as_it_looks or not used.keys() <= self.declared:
            return None
        return {*used, *used.values()}


def _lower_case(names: Iterable[tuple[str, object]]) -> Iterator[str]:
    return (name.casefold() for name, _ in names)


def _is_divided_so(file: ast.File, parts: Parts) -> bool:
    """Whether it is one unit, and its code what looks like its code."""
    if len(file.units) != 1:
        return False
    unit = file.units[0]
    if not isinstance(unit, ast.Block):
        return not parts.code
    begin = len(parts.declarations)
    in_front = all(section.span.end < begin for section in unit.sections)
    behind = all(statement.span.start >= begin for statement in unit.body)
    return in_front and behind and not unit.members and not unit.labels
