"""Explicit requests of a master to one slave, one after the other, each with its answer or none."""

from collections import deque
from collections.abc import Callable

from fbgen.dataclass import dataclass
from fbgen.wire.devicenet import BodyFormat, Frame
from fbgen.wire.devicenet_ids import Group2, group_2
from fbgen.wire.devicenet_messages import (
    ErrorResponse,
    Header,
    MessageError,
    Request,
    Response,
    encode_request,
    parse_response,
)
from harness.fieldbus.devicenet.explicit import ExplicitEnd
from harness.kernel import NS_PER_S, Event, Kernel

Answer = Response | ErrorResponse | None
Done = Callable[[Answer], None]
_LONGEST = 512
_PATIENCE_NS = NS_PER_S // 2
_FRAGMENT_NS = NS_PER_S


@dataclass(frozen=True, slots=True)
class _Job:
    request: Request
    unconnected: bool
    done: Done


class Requester:
    """The master's end. `form` is how the slave wants class and instance on its connection."""

    __slots__ = ("_end", "_header", "_job", "_jobs", "_kernel", "_mac", "_put", "_timer", "form")

    def __init__(
        self, kernel: Kernel, master: int, slave: int, send: Callable[[Frame], None]
    ) -> None:
        self._kernel = kernel
        self._mac = slave
        self._put = send
        self._header = Header(master)
        self._jobs: deque[_Job] = deque()
        self._job: _Job | None = None
        self._timer: Event | None = None
        self.form = BodyFormat.C8_I8
        identifier = group_2(Group2.EXPLICIT_REQUEST, slave)
        self._end = ExplicitEnd(
            kernel, identifier, send, self._taken, limit=_LONGEST, timeout_ns=_FRAGMENT_NS
        )

    def request(self, request: Request, done: Done, *, unconnected: bool = False) -> None:
        """Put a request in the row; `done` gets its answer, None for none. ValueError for numbers
        that the slave's form does not take."""
        encode_request(request, BodyFormat.C8_I8 if unconnected else self.form)
        self._jobs.append(_Job(request, unconnected, done))
        if self._job is None:
            self._next()

    def receive(self, data: bytes) -> None:
        """A frame of the slave's explicit responses."""
        self._end.receive(data)

    def clear(self) -> None:
        """Forget everything; nobody is told."""
        self._jobs.clear()
        self._job = None
        self._end.reset()
        self._stop()

    def _next(self) -> None:
        if not self._jobs:
            return
        job = self._job = self._jobs.popleft()
        xid = not self._header.xid
        self._header = Header(self._header.mac, xid)
        self._timer = self._kernel.after(_PATIENCE_NS, lambda: self._finish(None))
        try:
            body = encode_request(job.request, BodyFormat.C8_I8 if job.unconnected else self.form)
        except ValueError:  # the slave was allocated anew meanwhile, and has another form now
            self._finish(None)
            return
        if job.unconnected:
            identifier = group_2(Group2.UNCONNECTED_REQUEST, self._mac)
            self._put(Frame(identifier, bytes([self._header.byte]) + body))
        else:
            self._end.send(self._header, body)

    def _taken(self, header: Header, body: bytes) -> None:
        if self._job is None or header != self._header:
            return
        try:
            answer = parse_response(body)
        except MessageError:
            return
        if isinstance(answer, Response) and answer.service != self._job.request.service:
            return
        self._finish(answer)

    def _finish(self, answer: Answer) -> None:
        self._stop()
        job, self._job = self._job, None
        assert job is not None, "only a job that is under way is finished"
        job.done(answer)
        if self._job is None:
            self._next()

    def _stop(self) -> None:
        if self._timer is not None:
            self._kernel.cancel(self._timer)
            self._timer = None
