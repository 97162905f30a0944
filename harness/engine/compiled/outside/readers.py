"""Reading several single values by one call, as fast as Python can: one tuple of attributes.

The objects that hold the data of a program are made when it is loaded and stay, so they are looked
up once.
"""

from collections.abc import Callable, Sequence
from typing import Any

from harness.engine.compiled.data.memory import Location
from harness.engine.interface import Reader


def written_reader(places: Sequence[Location | Callable[[], Any]]) -> Reader:
    """A function that gives the values at these places, in their order.

    A place is a location or, for what Python has no attribute for, a function that reads it.
    """
    names: dict[str, Any] = {}
    known: dict[int, str] = {}
    texts = [_text(place, names, known) for place in places]
    parameters = ", ".join(f"{name}={name}" for name in names)
    exec(f"def read({parameters}):\n    return ({''.join(f'{text}, ' for text in texts)})", names)
    read: Reader = names["read"]
    return read


def _text(place: Location | Callable[[], Any], names: dict[str, Any], known: dict[int, str]) -> str:
    if not isinstance(place, Location) or place.key is None:
        name = f"read_{len(names)}"
        names[name] = place.read if isinstance(place, Location) else place
        return f"{name}()"
    name = known.setdefault(id(place.owner), f"held_{len(names)}")
    names[name] = place.owner
    return f"{name}.{place.key}" if isinstance(place.key, str) else f"{name}[{place.key}]"
