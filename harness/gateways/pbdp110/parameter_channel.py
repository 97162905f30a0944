"""The parameter channel of one drive: request bits, number and data against response bits and data.

PBDP-110 manual #10407-1.100-000, section 10.3. Each access begins from idle; a request is taken
once, and until the master has gone back to idle everything else is ignored. While idle, number and
data come back as they are sent.

Inferred: after power-on and after the master was away nothing is taken before idle was seen once;
while the interface works, number and data stay as they came back last; a master that goes back to
idle before the response gets none.
"""

from enum import Enum

from fbgen.dataclass import dataclass
from fbgen.wire.toshiba import ErrorReply
from harness.gateways.pbdp110.drive_link import Answer
from harness.gateways.pbdp110.settings import AccessCodes, DriveFacts


class _State(Enum):
    """How far the procedure is."""

    LOCKED = "waiting for idle"
    IDLE = "idle"
    BUSY = "working"
    DONE = "response given"


@dataclass(frozen=True, slots=True)
class Access:
    """A request for the drive that has been taken and waits for its turn."""

    request: int
    number: int
    data: int


class ParameterChannel:
    """The procedure. `wanted` is what the drive is to be asked, None if there is nothing.

    `response`, `number` and `data` are what the master sees.
    """

    __slots__ = (
        "_codes",
        "_facts",
        "_local",
        "_state",
        "data",
        "number",
        "response",
        "wanted",
    )

    def __init__(self, codes: AccessCodes, facts: DriveFacts, local: dict[int, int]) -> None:
        self._codes = codes
        self._facts = facts
        self._local = local
        self.reset()

    def reset(self) -> None:
        """As after power-on."""
        self._state = _State.LOCKED
        self.response = self._codes.response_idle
        self.number = self.data = 0
        self.wanted: Access | None = None

    def outputs(self, action: int, number: int, data: int) -> None:
        """The master's words of this channel."""
        codes = self._codes
        request = action >> codes.request_shift & 3
        if request == codes.idle:
            self._state = _State.IDLE
            self.wanted = None
            self.response, self.number, self.data = codes.response_idle, number, data
        elif self._state is _State.IDLE:
            self._state = _State.BUSY
            self.wanted = Access(request, number, data)

    def answer_alone(self) -> bool:
        """Answer what needs no drive: local numbers, and what the drive is known not to allow.

        True if there was such a request and it has its response now.
        """
        access, codes = self.wanted, self._codes
        if access is None:
            return False
        reads = access.request == codes.read
        if access.number in self._local:
            if reads:
                self._respond(codes.response_read, access.number, self._local[access.number])
            else:
                self._respond(codes.response_error, access.number, codes.read_only)
        elif reads and access.number in self._facts.write_only:
            self._respond(codes.response_error, access.number, codes.write_only)
        elif not reads and access.number in self._facts.read_only:
            self._respond(codes.response_error, access.number, codes.read_only)
        else:
            return False
        return True

    def answered(self, access: Access, answer: Answer) -> None:
        """The drive has answered a request, or has not; too late for one that was given up."""
        codes = self._codes
        if access is not self.wanted:
            return
        if answer is None:
            self._respond(codes.response_error, access.number, codes.other)
        elif isinstance(answer, ErrorReply):
            code = codes.refusals.get(answer.error, codes.other)
            self._respond(codes.response_error, access.number, code)
        else:
            reads = access.request == codes.read
            done = codes.response_read if reads else codes.response_written
            self._respond(done, access.number, answer.data)

    def _respond(self, response: int, number: int, data: int) -> None:
        self._state = _State.DONE
        self.wanted = None
        self.response, self.number, self.data = response, number, data
