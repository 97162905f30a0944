"""How scenarios are run, whatever their files say."""

from pathlib import Path

from fbgen.dataclass import dataclass
from harness.scenario.observers import ObserverMaker
from harness.scenario.temporaries import Temporaries


@dataclass(frozen=True, slots=True)
class RunOptions:
    """What is asked for beside the files.

    `seed`, `dialect` and `temporaries` take the place of those of the files. `select` is an
    expression over titles, files, variations and tags, see `harness.scenario.selection`. `jobs`
    processes run scenarios at the same time; the results are the same, in the same order.
    `observers` look on at each run. `catalog` has the folders that lie over the shipped catalogue.
    """

    seed: int | None = None
    select: str = ""
    dialect: str | None = None
    jobs: int = 1
    observers: tuple[ObserverMaker, ...] = ()
    temporaries: Temporaries | None = None
    catalog: tuple[Path, ...] = ()
