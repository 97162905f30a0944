"""What the points of a sweep depend on, as one digest: a journal counts for nothing else."""

from collections.abc import Sequence
from hashlib import sha256
from pathlib import Path

import fbgen
from fbgen.resources import shipped
from harness.sweep.conditions import Conditions
from harness.sweep.sweeping import Sweep


def contents(sweep: Sweep, plan: str, conditions: Sequence[Conditions]) -> str:
    """The digest of the emitted text, the plant, the catalogue, the product and the combinations.

    `plan` is the plant file's text. The product is its source: a version number tells nothing of
    two states of a working copy.
    """
    digest = sha256(plan.encode())
    for item in conditions:
        digest.update(repr(item).encode())
    for program in dict.fromkeys(item.program for item in conditions):
        for source in sweep.sources(Conditions(*program)):
            digest.update(source.text.encode())
    folders = {
        "*.py": [Path(fbgen.__file__).parent, Path(__file__).parents[1]],
        "*.yaml": [shipped("catalog")],
    }
    for pattern, places in folders.items():
        for folder in places:
            for path in sorted(folder.rglob(pattern)):
                digest.update(path.relative_to(folder).as_posix().encode() + path.read_bytes())
    return digest.hexdigest()
