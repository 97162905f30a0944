"""From a Python exception in generated code to the diagnostic with its place in the PLC text.

Nothing is recorded while the program runs. The traceback has the line, and Python's positions the
very expression that failed; `Listing` says what both were in the PLC text.
"""

from collections.abc import Callable, Iterator, Mapping
from functools import partial
from itertools import islice
from types import CodeType, FrameType, TracebackType
from typing import TypeAlias

from fbgen.diagnostics import DiagnosticError
from fbgen.lang.checked import AddressRef, Dereference, Expression, IndexRef, Place, VariableRef
from fbgen.lang.types import BOOL, ArrayType, Subrange, Type
from fbgen.source import Span
from harness.engine import faults
from harness.engine.compiled.code import Listing, Site
from harness.engine.compiled.library import stops
from harness.engine.fault_values import can_be_shown, is_inside, with_values
from harness.engine.interface import Limits, Value

_Frame: TypeAlias = tuple[FrameType, int, int]
"""A frame of generated code, the line in it, and the offset of the instruction."""


class Stopper:
    """Turns exceptions into diagnostics; `listings` is keyed by the file name of the code."""

    __slots__ = ("_limits", "_listings")

    def __init__(self, listings: Mapping[str, Listing], limits: Limits) -> None:
        self._listings = listings
        self._limits = limits

    def diagnostic(self, exception: Exception) -> DiagnosticError | None:
        """The diagnostic for an exception; None if generated code did not cause it."""
        frames = self._frames(exception.__traceback__)
        if not frames or not self._is_ours(exception.__traceback__):
            return None
        if isinstance(exception, stops.TooDeep):
            # The innermost frame is the counting one of the callee; the call is in the one before.
            span = self._place(*frames[-2])[1] if len(frames) > 1 else None
            depth = self._limits.call_depth
            return faults.nesting_too_deep(span, exception.block, depth)
        frame, line, offset = frames[-1]
        stopped = self._stopped(exception, frame, line, offset)
        return stopped and with_values(stopped, self._values(stopped, frame, line))

    def _stopped(
        self, exception: Exception, frame: FrameType, line: int, offset: int
    ) -> DiagnosticError | None:
        site, span = self._place(frame, line, offset)
        if span is None:
            return None
        if isinstance(exception, stops.Endless):
            return faults.endless_loop(self._line_span(frame, line), self._limits.loop_passes)
        if isinstance(exception, stops.CannotRun):
            return faults.cannot_run(self._line_span(frame, line), exception.what)
        if isinstance(exception, stops.StepZero):
            return faults.step_is_zero(self._line_span(frame, line))
        if isinstance(exception, AttributeError) and site and isinstance(site.node, Dereference):
            return faults.null_reference(span)
        if isinstance(exception, AttributeError) and isinstance(site, Site):
            return faults.reference_not_set(span, exception.name or "")
        if isinstance(exception, ZeroDivisionError | stops.ZeroDivisor):
            return faults.division_by_zero(span)
        return None if site is None else _of_site(exception, site, frame)

    def _values(
        self, stopped: DiagnosticError, frame: FrameType, line: int
    ) -> Iterator[tuple[Place, Callable[[], Value]]]:
        """How to read, in the frame that stopped, the places that stand in what failed."""
        failed = stopped.diagnostics[0].span
        names = dict(frame.f_locals)
        for place, text in self._listings[frame.f_code.co_filename].reads.get(line, ()):
            if failed is not None and can_be_shown(place) and is_inside(place.span, failed):
                yield place, partial(_read, text, frame.f_globals, names, place.type)

    def _line_span(self, frame: FrameType, line: int) -> Span:
        span = self._listings[frame.f_code.co_filename].spans[line - 1]
        assert span is not None
        return span

    def _is_ours(self, traceback: TracebackType | None) -> bool:
        """False if a stub of the user raised it: then it is none of the PLC program."""
        while traceback is not None and traceback.tb_next is not None:
            traceback = traceback.tb_next
        if traceback is None or traceback.tb_frame.f_code.co_filename in self._listings:
            return True
        return str(traceback.tb_frame.f_globals.get("__name__", "")).startswith("harness.")

    def _frames(self, traceback: TracebackType | None) -> list[_Frame]:
        frames: list[_Frame] = []
        while traceback is not None:
            frame = traceback.tb_frame
            if frame.f_code.co_filename in self._listings:
                frames.append((frame, traceback.tb_lineno, traceback.tb_lasti))
            traceback = traceback.tb_next
        return frames

    def _place(self, frame: FrameType, line: int, offset: int) -> tuple[Site | None, Span | None]:
        """The site that failed, and its span; the span of the statement if there is no site."""
        listing = self._listings[frame.f_code.co_filename]
        sites = listing.sites.get(line, [])
        failed = _failed_text(frame.f_code, offset, listing.lines[line - 1])
        site = next((one for one in sites if one.text == failed), None)
        if failed is None and len(sites) == 1:
            site = sites[0]
        return site, site.node.span if site is not None else listing.spans[line - 1]


def _read(text: str, module: dict[str, object], names: dict[str, object], kind: Type) -> Value:
    value: Value = eval(text, module, names)
    return bool(value) if kind == BOOL else value


def _failed_text(code: CodeType, offset: int, line: str) -> str | None:
    _, _, start, end = next(islice(code.co_positions(), offset // 2, None), (None,) * 4)
    return None if start is None or end is None else line[start:end]


def _of_site(exception: Exception, site: Site, frame: FrameType) -> DiagnosticError | None:
    node = site.node
    match exception:
        case stops.IndexOutside():
            return _index(node, exception.index, exception.dimension, exception.bounds)
        case IndexError():
            # Python says that the index is too large, not which one it was.
            index = eval(site.position, frame.f_globals, dict(frame.f_locals))
            return _index(node, index, 1)
        case stops.NoFit():
            return faults.value_out_of_range(node.span, exception.value, node.type)
        case stops.OutsideLimits():
            assert isinstance(node.type, Subrange)
            return faults.outside_subrange(node.span, exception.value, node.type)
        case stops.NoArea():
            return faults.no_such_area(node.span, exception.pattern, exception.reason)
        case stops.NullReference():
            return faults.null_reference(node.span)
        case stops.NoDate():
            return faults.no_date(node.span)
        case stops.NoNumber():
            return faults.not_a_number(node.span, exception.text, node.type)
        case stops.NoDecimal():
            return faults.not_decimal(node.span, exception.value)
        case stops.NoSuchDate():
            return faults.no_such_date(node.span, exception.text)
        case stops.NoInput():
            return faults.selector_out_of_range(node.span, exception.selector, exception.count)
        case stops.NoAddress():
            return faults.address_out_of_range(node.span, _spelled(node), exception.size)
        case stops.NoBlock():
            return faults.no_data_block(node.span, exception.number)
        case _:
            return None


def _spelled(node: Expression) -> str:
    if isinstance(node, VariableRef):
        assert node.variable.address is not None
        return node.variable.address.spelled
    assert isinstance(node, AddressRef)
    return node.address.spelled


def _index(
    node: Expression, index: int, dimension: int, bounds: tuple[int, int] | None = None
) -> DiagnosticError:
    assert isinstance(node, IndexRef)
    if bounds is None:
        kind = node.base.type
        assert isinstance(kind, ArrayType)
        bounds = kind.bounds[dimension - 1]
    first, last = bounds
    return faults.index_out_of_range(node.span, index, first, last, dimension)
