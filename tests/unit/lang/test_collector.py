"""The cycle collector at rest: what is made meanwhile is not kept for ever."""

import gc
import weakref

from fbgen.lang.collector import collector_at_rest


class Plant:
    """Something that knows its parts, which know it."""

    def __init__(self) -> None:
        self.part = self


def test_what_is_cyclic_goes_in_a_process_that_reads_program_after_program() -> None:
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
