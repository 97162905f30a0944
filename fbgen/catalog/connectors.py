"""Connectors of a device, pin by pin."""

from collections.abc import Iterable

from pydantic import Field

from fbgen.catalog.located import Located
from fbgen.catalog.scalars import SnakeName, Text
from fbgen.catalog.sourced import Sourced
from fbgen.diagnostics import Diagnostic


class Pin(Located):
    """What a pin carries; `wire` is what goes there, such as the colour in a ready-made cable."""

    pin: Text
    signal: Text
    wire: Text | None = None


class Connector(Sourced):
    """A connector with its pins; those that are not named are not connected."""

    name: SnakeName
    title: Text
    pins: tuple[Pin, ...] = Field(min_length=1)
    remark: Text | None = None

    def problems(self) -> Iterable[Diagnostic]:
        """FB1102 a pin twice; FB1103 no source."""
        yield from super().problems()
        seen: set[str] = set()
        for item in self.pins:
            if item.pin in seen:
                message = f"pin {item.pin} stands twice in the connector '{self.name}'"
                yield Diagnostic("FB1102", message, item.span_of("pin"))
            seen.add(item.pin)
