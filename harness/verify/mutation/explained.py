"""Whether the reasons of the user fit to what a run has found."""

from collections.abc import Iterator

from fbgen.diagnostics import Diagnostic
from harness.verify.mutation.equivalents import MOST_PERCENT, Equivalents
from harness.verify.mutation.session import MutationRun, Tried
from harness.verify.mutation.stage import Stage
from harness.verify.mutation.verdict import Fate


def wrong_reasons(run: MutationRun, stage: Stage, reasons: Equivalents) -> list[Diagnostic]:
    """FB8068 for entries that explain nothing, FB8069 if too many mutants are only explained.

    Entries of blocks that were not changed in this run are not looked at.
    """
    if run.interrupted or not reasons.equivalents:
        return []
    tried: dict[tuple[str, str], list[Tried]] = {}
    for one in run.tried:
        tried.setdefault((_block(one), one.fingerprint), []).append(one)
    known = _known(stage, {block for block, _ in tried})
    found = []
    for entry in reasons.equivalents:
        if entry.key[0] not in known:
            continue
        if entry.mutant not in known[entry.key[0]]:
            found.append(entry.stale("belongs to no mutant"))
        found += [entry.stale(why) for one in tried.get(entry.key, ()) for why in _against(one)]
    return [*found, *_too_many(run)]


def _block(one: Tried) -> str:
    return one.target.subject.block.name.casefold()


def _known(stage: Stage, blocks: set[str]) -> dict[str, set[str]]:
    """The fingerprints of all mutants of blocks, in whichever plant."""
    known: dict[str, set[str]] = {name: set() for name in blocks}
    seen: set[tuple[str, str]] = set()
    for case in range(len(stage.cases)):
        for name in blocks:
            subject = stage.subject(case, name)
            if subject is not None and (name, subject.key) not in seen:
                seen.add((name, subject.key))
                known[name].update(subject.fingerprints)
    return known


def _against(one: Tried) -> Iterator[str]:
    """What speaks against a reason."""
    verdict = one.verdict
    if verdict.fate is Fate.KILLED:
        yield f"does not hold: {one.id} is noticed by '{verdict.scenario}'"
    elif verdict.fate is Fate.SURVIVED:
        yield f"does not hold: with {one.id} {verdict.effect}"
    elif verdict.fate is Fate.PROVED:
        yield f"is not needed: {one.id} is proved to be equivalent"


def _too_many(run: MutationRun) -> Iterator[Diagnostic]:
    """Counted of all mutants of the blocks, so that a part of them can be looked at, too."""
    explained = sum(one.verdict.fate is Fate.EXPLAINED for one in run.tried)
    subjects = {id(one.target): one.target.subject for one in run.tried}
    every = sum(len(subject.mutants) for subject in subjects.values())
    if 100 * explained > MOST_PERCENT * every:
        message = (
            f"{explained} of {every} mutants are equivalent by a reason alone, "
            f"more than {MOST_PERCENT} %"
        )
        yield Diagnostic("FB8069", message, help="prove them with --prove, or notice them")
