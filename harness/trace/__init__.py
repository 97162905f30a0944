"""What a run leaves: every change with its time, and who wrote it.

recorder = installation.record()
installation.start()
installation.run_for(2 * NS_PER_S)
for change in recorder.finish().changes_of("drive.pump.frequency"):
    print(change.time_ns, change.value)

Nothing is imported before it is asked for: most runs record telegrams only.
"""

from typing import TYPE_CHECKING

from fbgen.faces import member

if TYPE_CHECKING:
    from harness.trace.model import (
        Change,
        Channel,
        Frame,
        Mark,
        Place,
        Telegram,
        Trace,
        TraceWord,
        Verdict,
        WordField,
    )
    from harness.trace.reading import read_traces
    from harness.trace.recorder import Recorder
    from harness.trace.writing import trace_lines, trace_text

__all__ = [
    "Change",
    "Channel",
    "Frame",
    "Mark",
    "Place",
    "Recorder",
    "Telegram",
    "Trace",
    "TraceWord",
    "Verdict",
    "WordField",
    "read_traces",
    "trace_lines",
    "trace_text",
]

_HOMES = {
    "Change": "model",
    "Channel": "model",
    "Frame": "model",
    "Mark": "model",
    "Place": "model",
    "Recorder": "recorder",
    "Telegram": "model",
    "Trace": "model",
    "TraceWord": "model",
    "Verdict": "model",
    "WordField": "model",
    "read_traces": "reading",
    "trace_lines": "writing",
    "trace_text": "writing",
}


def __getattr__(name: str) -> object:
    return member(__name__, _HOMES, name)
