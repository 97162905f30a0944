"""The variables of one call of a block."""

from fbgen.lang.checked import Variable
from fbgen.source import Span
from harness.engine.faults import reference_not_set
from harness.engine.reference.storage import Storage


class Frame:
    """The variables of one call of a block: their storages, by declaration.

    `instance` is there in the body of a block that keeps its variables.
    """

    __slots__ = ("instance", "storages")

    def __init__(self) -> None:
        self.instance: Storage | None = None
        self.storages: dict[Variable, Storage] = {}

    def find(self, variable: Variable, span: Span) -> Storage:
        """The storage of a variable of the block. Raises FB6012."""
        storage = self.storages.get(variable)
        if storage is None:
            raise reference_not_set(span, variable.name)
        return storage
