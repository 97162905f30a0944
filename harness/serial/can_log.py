"""A log of CAN frames that other tools open: Vector's ASC and BLF, and candump's, by python-can."""

from pathlib import Path

from fbgen.diagnostics import error
from fbgen.wire.devicenet import Frame
from harness.kernel import NS_PER_S

FORMATS = (".asc", ".blf", ".log", ".csv")
"""What python-can makes of a file by the end of its name: Vector ASCII and binary, candump, CSV."""

_CHANNEL = 0
"""The first one: logs show it as 1, or as can0."""


class CanLog:
    """Writes frames with their times. Used as a context manager it closes the file."""

    def __init__(self, path: Path, began_s: float = 0.0) -> None:
        """`began_s`: when the instant 0 was, in seconds since 1970.

        Raises DiagnosticError FB9030 for a name without a format, FB9031 for no right to it.
        """
        import can  # noqa: PLC0415 - an extra: only who asks for a log needs it

        if path.suffix.lower() not in FORMATS:
            raise error(
                "FB9030",
                f"'{path.name}' does not say which format of log it is",
                None,
                f"let it end with {', '.join(FORMATS)}",
            )
        try:
            self._log = can.Logger(str(path))
        except OSError as problem:
            reason = problem.strerror or type(problem).__name__
            raise error("FB9031", f"{path.as_posix()} cannot be written: {reason}") from None
        self._message = can.Message
        self._began_s = began_s

    def __enter__(self) -> "CanLog":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def write(self, at_ns: int, frame: Frame, *, received: bool = True) -> None:
        """Add a frame that was over at an instant; `received` from somebody else."""
        self._log.on_message_received(
            self._message(
                timestamp=self._began_s + at_ns / NS_PER_S,
                arbitration_id=frame.identifier,
                data=frame.data,
                is_extended_id=False,
                is_rx=received,
                channel=_CHANNEL,
            )
        )

    def close(self) -> None:
        """Write what is left."""
        self._log.stop()
