"""Stubs: Python in the place of a block that the program calls and the harness does not have.

    program.stub("GET_DIAG", lambda **inputs: {"RET_VAL": 0, "CNT_DIAG": 3})

A function gets the inputs of the call by name, as they are written there. It gives the outputs by
name (any case), or just the result of a function. A class stands for a function block with state:
each instance of the program gets an object of its own, which is called.
"""

from collections.abc import Callable

from harness.engine.block_models import BlockModel, ModelFactory

Stub = Callable[..., object]
"""A function, or a class whose objects can be called."""


class StubState:
    """What one instance of a stubbed block has in Python: the object that is called."""

    __slots__ = ("_action", "_made_by", "_model", "_modelled_by")

    def __init__(self) -> None:
        self._made_by: Stub | None = None
        self._modelled_by: ModelFactory | None = None
        self._model: BlockModel | None = None
        self._action: Stub | None = None

    def action_of(self, stub: Stub) -> Stub:
        """The function itself, or this instance's object of the class."""
        if not isinstance(stub, type):
            return stub
        if self._made_by is not stub or self._action is None:
            self._made_by, self._action = stub, stub()
        return self._action

    def model_of(self, factory: ModelFactory) -> BlockModel:
        """What stands for this instance in the controller: another controller has another."""
        if self._modelled_by is not factory or self._model is None:
            self._modelled_by, self._model = factory, factory()
        return self._model


class Stubs:
    """The stubs of one controller by casefolded name, and the blocks that it has itself.

    `models` has those by the name that the checker gives them; a stub comes before a model.
    """

    __slots__ = ("_by_key", "models")

    def __init__(self) -> None:
        self._by_key: dict[str, Stub] = {}
        self.models: dict[str, ModelFactory] = {}

    def add(self, name: str, stub: Stub) -> None:
        """From now on calls of that name go to the stub."""
        self._by_key[name.casefold()] = stub

    def find(self, name: str) -> Stub | None:
        """The stub of that name."""
        return self._by_key.get(name.casefold())
