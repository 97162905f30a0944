"""What a run leaves: every change with its time, and who wrote it.

recorder = installation.record()
installation.start()
installation.run_for(2 * NS_PER_S)
for change in recorder.finish().changes_of("drive.pump.frequency"):
    print(change.time_ns, change.value)
"""

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
