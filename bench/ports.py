"""How far from its specified time a reply comes over a pseudo terminal, from another process.

The time is that of a real wire: the bytes of the request, the reply time, the bytes of the reply.
What other work on the machine does to it shows in the greatest of them, not in the median.
"""

import os
import select
import signal
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from statistics import median
from time import perf_counter_ns

from bench.measuring import Figure

_ROOT = Path(__file__).parents[1]
_EXCHANGES = 200
_REPLY_MS = 12.0
_READ = bytes.fromhex("2F 01 52 FD 01 80")
_ANSWER_BYTES = 8
_BIT_MS = 1000 / 19_200


def figures() -> Iterator[Figure]:
    """Median and greatest distance, for one drive and for thirty."""
    if sys.platform != "linux":
        return
    specified_ms = _REPLY_MS + (len(_READ) * 11 + _ANSWER_BYTES * 12) * _BIT_MS
    for count in (1, 30):
        late_ms = [took - specified_ms for took in _times_ms(count)]
        what = f"reply over a pseudo terminal, {count} on the line: later than specified, "
        yield Figure(what + "median", median(late_ms) / 1000, 0, "at most 2 ms")
        yield Figure(what + "greatest", max(late_ms) / 1000, 0, "")


def _times_ms(count: int) -> list[float]:
    command = [sys.executable, "-m", "fbgen.cli", "sim", "drive", "--pty", "--baud", "19200"]
    options = ["--inv-no", f"1-{count}", "--reply-time", f"{_REPLY_MS:g} ms"]
    process = subprocess.Popen(
        [*command, *options],
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
        cwd=_ROOT,
    )
    assert process.stdout is not None
    end = os.open(process.stdout.readline().strip(), os.O_RDWR | os.O_NOCTTY)
    try:
        return [_exchange_ms(end) for _ in range(_EXCHANGES)]
    finally:
        os.close(end)
        process.send_signal(signal.SIGINT)
        process.wait()


def _exchange_ms(end: int) -> float:
    begin_ns, heard = perf_counter_ns(), b""
    os.write(end, _READ)
    while len(heard) < _ANSWER_BYTES:
        select.select([end], [], [])
        heard += os.read(end, 100)
    return (perf_counter_ns() - begin_ns) / 1e6
