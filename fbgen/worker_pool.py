"""Processes that work for this one, and end with it."""

import multiprocessing
import os
import signal
from collections.abc import Callable, Generator, Sequence
from concurrent.futures import ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from multiprocessing.synchronize import Event
from threading import Thread
from typing import TypeVar

from fbgen.diagnostics import error

_Item = TypeVar("_Item")
_Result = TypeVar("_Result")
_LOOKS_UP_EVERY_S = 0.2
"""How often a process looks whether it is still wanted."""


class Pool:
    """Processes that are kept until `end`."""

    def __init__(self, processes: int) -> None:
        self._stop = multiprocessing.Event()
        self._broken = False
        self._pool = ProcessPoolExecutor(processes, initializer=_begin, initargs=(self._stop,))

    def in_order(
        self, work: Callable[[_Item], _Result], items: Sequence[_Item]
    ) -> Generator[_Result, None, None]:
        """See `fbgen.workers.Workers`."""
        try:
            yield from self._pool.map(work, items)
        except BrokenProcessPool:
            self._broken = True
            raise error(
                "FB9020",
                "the system has ended a process that worked for this command",
                help="most often the memory was used up: take fewer processes with -j",
            ) from None

    def end(self, *, at_once: bool) -> None:
        """Let them go; with `at_once` in the middle of their work.

        The rest of a broken pool is ended already, and nobody can be told anything: one of its
        processes may have been ended while it looked whether it was still wanted.
        """
        if at_once and not self._broken:
            self._stop.set()
        self._pool.shutdown(cancel_futures=True)


def _begin(stop: Event) -> None:
    """In a new process: Ctrl-C is the business of the one that has started it, and so is whatever
    else that one does when it is asked to end."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    Thread(target=_end_with, args=(stop,), daemon=True).start()


def _end_with(stop: Event) -> None:
    """End this process when nobody wants its results any more."""
    parent = multiprocessing.parent_process()
    while not stop.wait(_LOOKS_UP_EVERY_S):
        if parent is not None and not parent.is_alive():
            break
    os._exit(0)
