"""A mutant as text: the whole file with the change, and the difference as a patch."""

import difflib
from collections.abc import Sequence

from harness.verify.mutation.mutant import Edit, Mutant


def with_edits(text: str, edits: Sequence[Edit]) -> str:
    """The text with all edits made."""
    done: list[str] = []
    place = 0
    for edit in sorted(edits, key=lambda one: one.span.start):
        done += (text[place : edit.span.start], edit.text)
        place = edit.span.end
    return "".join((*done, text[place:]))


def mutated_text(mutant: Mutant) -> str:
    """The text of the file of the block with the change in it."""
    return with_edits(mutant.place.source.text, mutant.change.edits)


def difference(mutant: Mutant, context: int = 1) -> str:
    """A unified diff between the text of the block and that of the mutant."""
    name = mutant.place.source.name
    lines = difflib.unified_diff(
        mutant.place.source.text.splitlines(),
        mutated_text(mutant).splitlines(),
        f"{name}",
        f"{name} ({mutant.id})",
        n=context,
        lineterm="",
    )
    return "\n".join(lines)


def changed_lines(mutant: Mutant) -> tuple[str, str]:
    """The lines that a mutant changes, as they are and as it has them; spaces do not count."""
    text, edits = mutant.place.source.text, mutant.change.edits
    begin = text.rfind("\n", 0, min(edit.span.start for edit in edits)) + 1
    end = text.find("\n", max(edit.span.end for edit in edits))
    changed = with_edits(text, edits)
    behind = len(text) - end if end >= 0 else 0
    before, after = text[begin : len(text) - behind], changed[begin : len(changed) - behind]
    return " ".join(before.split()), " ".join(after.split())
