"""Processes that work for this one, and end with it.

Each has a pipe of its own and shares nothing with the others, so that it may be ended at any
moment. The pools of the standard library take all results through one queue: a process that ends
while it writes there leaves whoever reads waiting forever.
"""

import multiprocessing
import os
import signal
import traceback
from collections.abc import Callable, Generator, Sequence
from multiprocessing.connection import wait
from threading import Thread
from typing import TYPE_CHECKING, Any, TypeVar

from fbgen.diagnostics import error

if TYPE_CHECKING:
    from multiprocessing.connection import Connection

_Item = TypeVar("_Item")
_Result = TypeVar("_Result")


class Pool:
    """Up to so many processes, started as there is work for them and kept until `end`."""

    def __init__(self, processes: int) -> None:
        self._most = processes
        self._workers: list[_Worker] = []

    def in_order(
        self, work: Callable[[_Item], _Result], items: Sequence[_Item]
    ) -> Generator[_Result, None, None]:
        """See `fbgen.workers.Workers`. A process gets its next item when its result was fetched
        whole: nobody waits for somebody who waits for him."""
        while len(self._workers) < min(self._most, len(items)):
            self._workers.append(_Worker())
        at_work: dict[_Worker, int] = {}
        rest = iter(enumerate(items))

        def give_next(worker: _Worker) -> None:
            for number, item in rest:
                at_work[worker] = number
                worker.give(work, item)
                return

        try:
            for worker in self._workers:
                give_next(worker)
            done: dict[int, _Result] = {}
            for wanted in range(len(items)):
                while wanted not in done:
                    for worker in _ready(at_work):
                        done[at_work[worker]] = worker.result()
                        del at_work[worker]
                        give_next(worker)
                yield done.pop(wanted)
        finally:
            for worker in at_work:
                worker.end()
                self._workers.remove(worker)

    def end(self) -> None:
        """End them all, in the middle of their work too."""
        for worker in self._workers:
            worker.end()
        self._workers.clear()


def _ready(at_work: "dict[_Worker, int]") -> "list[_Worker]":
    """Those with a result, or ended by the system; waits for the first."""
    ready = wait([worker.pipe for worker in at_work])
    return [worker for worker in at_work if worker.pipe in ready]


class _Worker:
    """One process and this end of its pipe."""

    def __init__(self) -> None:
        self.pipe, other = multiprocessing.Pipe()
        self._process = multiprocessing.Process(target=_serve, args=(other,), daemon=True)
        self._process.start()
        other.close()

    def give(self, work: Callable[[_Item], _Result], item: _Item) -> None:
        """Let it work on an item."""
        try:
            self.pipe.send((work, item))
        except ConnectionError:
            raise self._ended() from None

    def result(self) -> Any:
        """What has come of the item given last; what it raised is raised here."""
        try:
            failed, result = self.pipe.recv()
        except (EOFError, ConnectionError):
            raise self._ended() from None
        if failed:
            raise result
        return result

    def end(self) -> None:
        """End it, whatever it does."""
        self._process.kill()
        self._process.join()
        self.pipe.close()

    def _ended(self) -> Exception:
        return error(
            "FB9020",
            "the system has ended a process that worked for this command",
            help="most often the memory was used up: take fewer processes with -j",
        )


def _serve(pipe: "Connection") -> None:
    """In a new process: do what comes through the pipe.

    Ctrl-C is the business of the one that has started it, and so is whatever else that one does
    when it is asked to end.
    """
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    Thread(target=_end_with_parent, daemon=True).start()
    while True:
        work, item = pipe.recv()
        try:
            pipe.send((False, work(item)))
        except Exception as failure:
            failure.add_note(f"In the process that did the work:\n{traceback.format_exc()}")
            pipe.send((True, failure))


def _end_with_parent() -> None:
    """End this process when nobody wants its results any more."""
    parent = multiprocessing.parent_process()
    if parent is not None:
        parent.join()
    os._exit(0)
