"""What must hold in every run, whatever the phase: the rules of a sweep.

They look at what was asked and what came of it, and at the line; not into the blocks.
"""

from collections.abc import Iterator

from fbgen.dataclass import dataclass
from harness.kernel import NS_PER_MS
from harness.rules.answers import belongs
from harness.rules.repeats_allowed import most_attempts
from harness.sweep.requests import BROADCAST, READ, Outcome
from harness.sweep.rig import Frame, Observation

NO_REPLY, FAULTY, OTHER_REPLY = 0x8401, 0x8402, 0x8403
NAMED = {NO_REPLY, FAULTY, OTHER_REPLY}
"""What a request may end with where nothing disturbs gateway and PROFIBUS."""

_RETRIES = 2
_PROCESSING_NS = 5 * NS_PER_MS
"""The way of a reply from the line to the PLC takes at least this (TOSPBDP001 manual v1.1, 9)."""


@dataclass(frozen=True, slots=True)
class Violation:
    """A rule that did not hold: its name, and what was seen."""

    rule: str
    text: str


@dataclass(frozen=True, slots=True)
class Expected:
    """What the rules need to know beside a run.

    `unanswered` are requests to which a living drive gives no answer that passes the gateway;
    `bound_ns` is how long one request may take once it is its turn, `first_read_ns` how long the
    line is kept by the read that goes out before everything else.
    """

    bound_ns: int
    first_read_ns: int
    unanswered: frozenset[bytes]
    spacers: frozenset[int]
    inv_nos: tuple[int, ...]


def violations(seen: Observation, expected: Expected) -> list[Violation]:
    """Every rule that this run breaks."""
    if seen.stopped:
        return [Violation("the PLC runs", seen.stopped)]
    found = list(_ends(seen, expected))
    if not seen.finished:
        found.append(Violation("everything is asked", "the line was not ready for all requests"))
    found += _done_or_not(seen, expected)
    found += _values(seen, expected)
    found += _telegrams(seen, expected)
    found += _repetitions(seen, expected)
    return found


def _ends(seen: Observation, expected: Expected) -> Iterator[Violation]:
    """Every request ends, within its bound, with done or a named error."""
    for outcome in seen.outcomes:
        if outcome.ended_ns is None:
            yield Violation("every request ends", f"{outcome.request} did not")
            continue
        at_once = [other for other in seen.outcomes if other.posted_ns == outcome.posted_ns]
        took_ns = outcome.ended_ns - outcome.posted_ns
        bound_ns = len(at_once) * expected.bound_ns
        if outcome.posted_ns == seen.outcomes[0].posted_ns:
            bound_ns += expected.first_read_ns
        if took_ns > bound_ns:
            took = f"{outcome.request} took {took_ns / NS_PER_MS:g} ms"
            yield Violation("within its bound", f"{took} of {bound_ns / NS_PER_MS:g} ms")
        if not outcome.done and outcome.status not in NAMED:
            text = f"{outcome.request} ended with {outcome.status:04X}"
            yield Violation("named errors", text)


def _done_or_not(seen: Observation, expected: Expected) -> Iterator[Violation]:
    """A drive that answers in time is heard; one that does not is never said to have answered.

    Drive 0 answers the gateway's heartbeat and hears nothing meanwhile: what goes out only once may
    be lost there.
    """
    for outcome, silent in zip(seen.outcomes, seen.silent, strict=True):
        request = outcome.request
        answerer = 0 if request.inv_no == BROADCAST else request.inv_no
        answers = answerer not in silent and request.telegram not in expected.unanswered
        heard = answerer != 0 or request.repeatable
        if outcome.done and request.reply_expected and not answers:
            yield Violation("no answer, no done", f"{request} is done, and nobody has answered")
        in_time = seen.conditions.in_time or not request.reply_expected
        failed = outcome.ended_ns is not None and not outcome.done
        if failed and answers and heard and in_time:
            text = f"{request} ended with {outcome.status:04X}, and the drive answers in time"
            yield Violation("an answer in time is heard", text)


def _values(seen: Observation, expected: Expected) -> Iterator[Violation]:
    """What a request gives was answered to a telegram that went out for this request."""
    for outcome in seen.outcomes:
        request = outcome.request
        if not outcome.done or not request.reply_expected or outcome.ended_ns is None:
            continue
        since_ns, until_ns = outcome.posted_ns, outcome.ended_ns - _PROCESSING_NS
        if not belongs(seen.answers, request.telegram, outcome.data, since_ns, until_ns):
            text = f"{request} gives {outcome.data:04X}, which nobody answered to it"
            yield Violation("the value belongs to the request", text)


def _telegrams(seen: Observation, expected: Expected) -> Iterator[Violation]:
    """Each attempt is one telegram on the line, whole, and belongs to what is asked just then."""
    if len(seen.frames) != len(seen.triggers):
        text = f"{len(seen.triggers)} attempts, {len(seen.frames)} telegrams on the line"
        yield Violation("an attempt is a telegram", text)
    for frame, tried_ns in _attempts(seen):
        if not _is_spacer(frame, expected) and not _asked(frame, tried_ns, seen):
            text = f"{frame.telegram.hex(' ').upper()} at {frame.start_ns / NS_PER_MS:g} ms"
            yield Violation("telegrams belong to requests", text)


def _is_spacer(frame: Frame, expected: Expected) -> bool:
    """A read that the blocks themselves put in between."""
    inv_no, cmd, com_no = frame.telegram[0], frame.telegram[1], frame.telegram[2:4]
    wanted = inv_no in expected.inv_nos and cmd == READ
    return wanted and int.from_bytes(com_no, "big") in expected.spacers


def _attempts(seen: Observation) -> Iterator[tuple[Frame, int]]:
    """Each telegram with the instant of the attempt that it is: its trigger.

    It may go out after the request has ended: the reply to an earlier attempt came meanwhile. Where
    telegrams and triggers are not one for one, which is a violation, its own instant.
    """
    paired = len(seen.frames) == len(seen.triggers)
    for at, frame in enumerate(seen.frames):
        yield frame, seen.triggers[at] if paired else frame.start_ns


def _asked(frame: Frame, tried_ns: int, seen: Observation) -> bool:
    return any(
        _meanwhile(tried_ns, outcome) and frame.telegram == outcome.request.telegram
        for outcome in seen.outcomes
    )


def _meanwhile(time_ns: int, outcome: Outcome) -> bool:
    last_ns = outcome.ended_ns
    return outcome.posted_ns <= time_ns and (last_ns is None or time_ns <= last_ns)


def _repetitions(seen: Observation, expected: Expected) -> Iterator[Violation]:
    """Nothing goes out more often than the blocks say; what must not be repeated, once."""
    for outcome in seen.outcomes:
        count = _count(outcome, seen)
        telegram, expected_reply = outcome.request.telegram, outcome.request.reply_expected
        limit = most_attempts(telegram, _RETRIES, expected.spacers, reply_expected=expected_reply)
        if count > limit:
            text = f"{outcome.request} went out {count} times"
            yield Violation("only what may be is repeated", text)
        if count == 0 and outcome.done:
            yield Violation("done means sent", f"{outcome.request} never went out")


def _count(outcome: Outcome, seen: Observation) -> int:
    telegram = outcome.request.telegram
    return sum(
        frame.telegram == telegram and _meanwhile(tried_ns, outcome)
        for frame, tried_ns in _attempts(seen)
    )
