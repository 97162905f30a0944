"""Whole objects as bytes, and back: models, trees, and Python that was compiled.

That is what Python's own `__pycache__` is for modules: reading it runs what lies there. So these
bytes are for a folder that belongs to the user alone, under a key with everything that wrote them.
"""

import copyreg
import io
import marshal
import pickle
from collections.abc import Callable, Mapping
from types import CodeType, MappingProxyType
from typing import Any, TypeAlias

_PROTOCOL = 5


_Reduce: TypeAlias = Callable[[Any], tuple[Any, ...]]
"""What an object is made from again, as `__reduce__` tells it."""


def packed_objects(
    content: object, instead: Mapping[type, _Reduce] = MappingProxyType({})
) -> bytes | None:
    """The bytes; None for what Python cannot pack, or what is nested deeper than it can follow.

    `instead` says of which types less is enough, and what that is.
    """
    stream = io.BytesIO()
    pickler = pickle.Pickler(stream, _PROTOCOL)
    own: dict[type, _Reduce] = {CodeType: _code, MappingProxyType: _proxy}
    pickler.dispatch_table = {**copyreg.dispatch_table, **own, **instead}
    try:
        pickler.dump(content)
    except (RecursionError, pickle.PicklingError, AttributeError, TypeError):
        return None
    return stream.getvalue()


def unpacked_objects(data: bytes) -> Any:
    """The objects that `packed_objects` made these bytes from."""
    return pickle.loads(data)


def _code(code: CodeType) -> tuple[Any, ...]:
    return marshal.loads, (marshal.dumps(code),)


def _proxy(proxy: MappingProxyType[Any, Any]) -> tuple[Any, ...]:
    return _proxied, (dict(proxy),)


def _proxied(content: dict[Any, Any]) -> MappingProxyType[Any, Any]:
    return MappingProxyType(content)
