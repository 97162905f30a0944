"""Traces for the HTML report, made by hand: a short one with everything, and a long one."""

from collections.abc import Iterator

from harness.trace import Change, Channel, Frame, Mark, Place, Telegram, Trace, TraceWord, WordField

MS = 1_000_000
STATUS = TraceWord(
    "tospbdp001.status",
    "Status word",
    (
        WordField("data_taken", "the gateway has taken the data", 15, 15),
        WordField("status_changed", "the status is another one", 14, 14),
        WordField("status_code", "what went wrong", 8, 12, {0: "no error", 3: "no reply"}),
        WordField("error_count", "counter of faulty telegrams", 0, 7),
    ),
)
PLACES = (
    Place("start.scenario.yaml", 5, 14, "- expect: {drive.pump.running: true}"),
    Place("TOS_Line.scl", 61, 5, "#trigger := #next;", "TOS_Line", "TOS_Gateway_gw1_DB.line"),
)
CHANNELS = (
    Channel("cpu.mode", "operating mode", "text", "cpu"),
    Channel("gateway.gw1.status", "status word", "word", "gateway", "gw1", word=STATUS.name),
    Channel("gateway.gw1.trigger", "trigger byte", "integer", "gateway", "gw1"),
    Channel("drive.pump.frequency", "output frequency", "real", "drive", "pump", "Hz"),
    Channel("drive.pump.running", "the output turns the motor", "bool", "drive", "pump"),
    Channel("plc.TOS_Plant.gw1.pump.stop.busy", "gw1 pump stop busy", "bool", "plc", "TOS_Plant"),
    Channel("plc.TOS_Plant.huge", "huge", "word", "plc", "TOS_Plant"),
)
_FIRST = ("STOP", 0x0000, 0, 0.0, False, False, 2**63 + 1)


def short_trace() -> Trace:
    """100 ms: the CPU starts, a telegram goes out and back, a fault, a check that fails."""
    changes = (
        *(Change(0, number, value) for number, value in enumerate(_FIRST)),
        Change(10 * MS, 0, "RUN"),
        Change(20 * MS, 2, 255, 1),
        Change(40 * MS, 1, 0x8301, 1),
        Change(50 * MS, 3, 12.5),
        Change(50 * MS, 4, True),
        Change(60 * MS, 3, float("nan")),
        Change(70 * MS, 3, 40.0),
        Change(80 * MS, 4, False),
    )
    request = bytes.fromhex("2F0B47FC900000")
    frames = (
        Frame(22 * MS, 26 * MS, "gw1", "gw1", True, "request", request, None, False, False, "ask"),
        Frame(30 * MS, 34 * MS, "gw1", "pump", False, "reply", request, b"\x00", True, True, ""),
    )
    telegrams = (
        Telegram(20 * MS, "gw1", bytes(9), 40 * MS, bytes(8), "drive 11: read FC90", 1),
        Telegram(90 * MS, "gw1", bytes(9)),
    )
    marks = (
        Mark(0, "step", "wait 10 ms", 10 * MS, "", 0, "passed"),
        Mark(40 * MS, "fault", "line_broken", None, "gw1", 0),
        Mark(
            45 * MS, "check", "drive.pump.running: true", 85 * MS, "drive.pump.running", 0, "failed"
        ),
    )
    return Trace(
        *("A <b>drive</b> starts", "start.scenario.yaml", 7, "compiled", "tia", True),
        *(0, 100 * MS, (STATUS,), PLACES, CHANNELS, changes, frames, telegrams, marks),
    )


def network_trace() -> Trace:
    """100 ms of a serial line and of DeviceNet."""
    channels = (
        Channel("line.line1.available", "the module answers the CPU", "bool", "line", "line1"),
        Channel("devicenet.net1.mode", "what the scanner does", "text", "devicenet", "net1"),
        Channel("devicenet.infeed.scanner", "its state", "text", "devicenet", "infeed"),
    )
    changes = (
        *(Change(0, number, value) for number, value in enumerate((True, "IDLE", "waiting"))),
        Change(10 * MS, 1, "RUN"),
        Change(20 * MS, 2, "running"),
        Change(60 * MS, 2, "lost"),
    )
    reply, polled = bytes.fromhex("2F0B47FC90000E1B"), bytes.fromhex("00C4D007")
    frames = (
        Frame(22 * MS, 26 * MS, "line1", "line1", True, "request", reply[:5], meaning="ask"),
        Frame(30 * MS, 34 * MS, "line1", "pump", False, "reply", reply, meaning="say"),
        Frame(
            *(40 * MS, 44 * MS, "net1", "net1", True, "output", polled),
            meaning="infeed: command = C400",
            identifier=0x42D,
        ),
        Frame(46 * MS, 50 * MS, "net1", "infeed", False, "input", b"", identifier=0x3C5),
    )
    return Trace(
        *("Networks", "networks.scenario.yaml", 0, "compiled", "tia", False, 0, 100 * MS),
        channels=channels,
        changes=changes,
        frames=frames,
    )


def long_trace(events: int) -> Trace:
    """So many changes, spread over the channels, a millisecond apart, without a failure."""
    return Trace(
        *("A long run", "long.scenario.yaml", 0, "compiled", "tia", True),
        *(0, (events + 1) * MS, (STATUS,), PLACES, CHANNELS, tuple(_changes(events))),
    )


def _changes(events: int) -> Iterator[Change]:
    for number, value in enumerate(_FIRST):
        yield Change(0, number, value)
    for count in range(1, events - len(_FIRST) + 1):
        channel = 1 + count % 5
        values = (
            count % 0x10000,
            count % 256,
            count % 500 / 10,
            count // 5 % 2 == 0,
            count // 5 % 2 == 0,
        )
        yield Change(count * MS, channel, values[channel - 1], 1)
