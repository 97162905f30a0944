"""A function block with its own state, as it is handled from outside."""

from collections.abc import Callable, Mapping
from typing import Any

from fbgen.lang.checked import AnyBlock, Block
from harness.engine.compiled.data.memory import Location, Memory
from harness.engine.compiled.data.model import Record
from harness.engine.interface import Convert, FunctionResult, State, Value
from harness.engine.paths import parse_path


class CompiledInstance:
    """One instance. `make_call` makes the function that calls it, when it is called first.

    `call_on` calls a method of some instance.
    """

    __slots__ = ("_call", "_call_on", "_data", "_make_call", "_memory", "_record")

    def __init__(
        self,
        record: Record,
        data: Any,
        memory: Memory,
        *,
        make_call: Callable[[Record, Any, Convert], Callable[..., None]],
        call_on: Callable[[Any, Block, Mapping[str, Value]], FunctionResult],
    ) -> None:
        self._record = record
        self._data = data
        self._memory = memory
        self._call: Callable[..., None] | None = None
        self._make_call = make_call
        self._call_on = call_on

    @property
    def block(self) -> AnyBlock:
        """The block of which this is an instance."""
        assert self._record.block is not None
        return self._record.block

    def call(self, inputs: Mapping[str, Value]) -> None:
        """One call. Inputs and in-outs by name; what is not given keeps its value."""
        if self._call is None:
            self._call = self.keyword_call(dict)
        self._call(**inputs)

    def keyword_call(self, convert: Convert) -> Callable[..., None]:
        """A function that calls the block with inputs and in-outs as keywords, the fastest way."""
        return self._make_call(self._record, self._data, convert)

    def get(self, path: str) -> Value:
        """The value of a variable or of a part of it; an in-out as the last call left it."""
        location = self.location(path)
        return self._memory.export(location.kind, location.read())

    def set(self, path: str, value: Value) -> None:
        """Write a variable or a part of it. Parts of a structure that are not named stay."""
        self._memory.load(path, self.location(path), value)

    def location(self, path: str) -> Location:
        """Where the data at a path is."""
        return self._memory.find_in(path, self._data, self._record, parse_path(path))

    def call_method(
        self, path: str, method: Block, arguments: Mapping[str, Value]
    ) -> FunctionResult:
        """Call a method of the instance, or of the one at a path."""
        return self._call_on(self.location(path).read() if path else self._data, method, arguments)

    def snapshot(self) -> State:
        """Everything that the next call depends on, without what its in-outs refer to."""
        return self._memory.snapshot(self._record, self._data)

    def restore(self, state: State) -> None:
        """Go back to a snapshot of this instance, or of another one of the same block."""
        self._memory.restore(self._record, self._data, state, remanent_too=True)
