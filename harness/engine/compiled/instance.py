"""A function block with its own state, as it is handled from outside."""

from collections.abc import Callable, Mapping
from typing import Any

from fbgen.lang.checked import AnyBlock
from harness.engine.compiled.memory import Location, Memory
from harness.engine.compiled.model import Record
from harness.engine.interface import State, Value
from harness.engine.paths import parse_path


class CompiledInstance:
    """One instance. `call` runs its generated method, `stopped` says what to raise if it fails."""

    __slots__ = ("_call", "_data", "_make_keyword_call", "_memory", "_record", "_stopped")

    def __init__(
        self,
        record: Record,
        data: Any,
        memory: Memory,
        *,
        call: Callable[[Mapping[str, Value]], None],
        stopped: Callable[[Exception], Exception],
        make_keyword_call: Callable[[Record, Any], Callable[..., None]],
    ) -> None:
        self._record = record
        self._data = data
        self._memory = memory
        self._call = call
        self._stopped = stopped
        self._make_keyword_call = make_keyword_call

    @property
    def block(self) -> AnyBlock:
        """The block of which this is an instance."""
        assert self._record.block is not None
        return self._record.block

    def call(self, inputs: Mapping[str, Value]) -> None:
        """One call. Inputs and in-outs by name; what is not given keeps its value."""
        try:
            self._call(inputs)
        except Exception as exception:
            stopped = self._stopped(exception)
            if stopped is exception:
                raise
            raise stopped from None

    def keyword_call(self) -> Callable[..., None]:
        """A function that calls the block, with its single-valued inputs as keywords.

        It does what `call` does and costs less: for those who call one instance very often.
        """
        return self._make_keyword_call(self._record, self._data)

    def get(self, path: str) -> Value:
        """The value of a variable or of a part of it; an in-out as the last call left it."""
        location = self._find(path)
        return self._memory.export(location.kind, location.read())

    def set(self, path: str, value: Value) -> None:
        """Write a variable or a part of it. Parts of a structure that are not named stay."""
        self._memory.load(path, self._find(path), value)

    def _find(self, path: str) -> Location:
        return self._memory.find_in(path, self._data, self._record, parse_path(path))

    def snapshot(self) -> State:
        """Everything that the next call depends on, without what its in-outs refer to."""
        return self._memory.snapshot(self._record, self._data)

    def restore(self, state: State) -> None:
        """Go back to a snapshot of this instance, or of another one of the same block."""
        self._memory.restore(self._record, self._data, state, remanent_too=True)
