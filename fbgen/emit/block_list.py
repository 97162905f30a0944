"""Which blocks were generated, and what became of those of the last time.

A block that keeps its template and its subject (a gateway, a sequence) is the same block, whatever
it is called: so a new prefix renames all of them. One whose subject is gone was renamed if another
one of the template says the same about a subject of another name; otherwise it was removed.
"""

import re
from collections.abc import Sequence
from dataclasses import asdict
from hashlib import sha256

from fbgen.dataclass import dataclass
from fbgen.emit.rendering import RenderedUnit
from fbgen.lang.origins import MARK
from fbgen.plant import with_prefix


@dataclass(frozen=True, slots=True)
class GeneratedBlock:
    """A block, data block or data type: its name, its template, what it is made for ("" the plant).

    `content` is a hash of its text in which the name of the subject does not count.
    """

    name: str
    template: str
    subject: str
    content: str

    def as_json(self) -> dict[str, str]:
        """As it stands in the list of generated files."""
        return asdict(self)


@dataclass(frozen=True, slots=True)
class BlockChanges:
    """What became of the blocks of the last time: old and new names, and names that are gone."""

    renamed: tuple[tuple[str, str], ...] = ()
    removed: tuple[str, ...] = ()

    def __bool__(self) -> bool:
        return bool(self.renamed or self.removed)


def generated_block(unit: RenderedUnit, prefix: str) -> GeneratedBlock:
    """What the list says about a unit."""
    spec = unit.spec
    text = MARK.sub("", unit.marked)
    if spec.subject:
        text = re.sub(rf"(?<![A-Za-z0-9]){re.escape(spec.subject)}(?![A-Za-z0-9])", "*", text)
    content = sha256(text.encode()).hexdigest()[:16]
    return GeneratedBlock(with_prefix(spec.name, prefix), spec.template, spec.subject, content)


def block_changes(
    before: Sequence[GeneratedBlock], after: Sequence[GeneratedBlock]
) -> BlockChanges:
    """Which blocks were renamed and which removed, in the order that they had."""
    now = {(block.template, block.subject): block for block in after}
    then = {(block.template, block.subject) for block in before}
    free = {
        (block.template, block.content): block
        for block in reversed(after)
        if (block.template, block.subject) not in then
    }
    renamed: list[tuple[str, str]] = []
    removed: list[str] = []
    for block in before:
        same = now.get((block.template, block.subject))
        if same is None:
            same = free.pop((block.template, block.content), None)
        if same is None:
            removed.append(block.name)
        elif same.name != block.name:
            renamed.append((block.name, same.name))
    kept = {block.name.casefold() for block in after}
    return BlockChanges(
        tuple(renamed), tuple(name for name in removed if name.casefold() not in kept)
    )
