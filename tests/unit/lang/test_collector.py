"""The cycle collector at rest: what is made meanwhile is not kept for ever."""

import gc
import subprocess
import sys
import weakref

from fbgen.lang.collector import collector_at_rest


class Plant:
    """Something that knows its parts, which know it."""

    def __init__(self) -> None:
        self.part = self


def read_until_it_is_gone() -> None:
    """Program after program, in a process that has nothing else in memory."""
    with collector_at_rest():
        plant = Plant()
    gone = weakref.ref(plant)
    del plant
    trees: list[object] = []
    while gone() is not None and len(trees) < 60:
        with collector_at_rest():
            trees.append([[number] for number in range(50_000)])
    assert gone() is None
    assert gc.isenabled()


def test_what_is_cyclic_goes_in_a_process_that_reads_program_after_program() -> None:
    subprocess.run([sys.executable, "-m", "tests.unit.lang.test_collector"], check=True)


if __name__ == "__main__":
    read_until_it_is_gone()
