"""The units to generate: which template, under which name, and what only this unit is told."""

from collections.abc import Mapping
from dataclasses import field

from fbgen.blocks.gateways import UnitView
from fbgen.blocks.sequences import SequenceView
from fbgen.dataclass import dataclass


@dataclass(frozen=True, slots=True)
class BlockSpec:
    """One unit to generate: its name, its template and what only this unit is told.

    `kind` is "udt", "scl" or "db", as TIA Portal calls its source files.
    """

    name: str
    kind: str
    template: str
    context: Mapping[str, object] = field(default_factory=dict)

    @property
    def subject(self) -> str:
        """The gateway, line or sequence that it is made for, "" where it is made for the plant."""
        made_for = self.context.get("gateway") or self.context.get("sequence")
        if isinstance(made_for, UnitView):
            return made_for.name
        return made_for.id if isinstance(made_for, SequenceView) else ""


def data_type(
    name: str, template: str = "", context: Mapping[str, object] | None = None
) -> BlockSpec:
    """A data type; its template is called like it if no other is named."""
    return BlockSpec(name, "udt", f"types/{template or name}.udt.jinja", context or {})


def block(name: str, template: str = "", context: Mapping[str, object] | None = None) -> BlockSpec:
    """A block; its template is called like it if no other is named."""
    return BlockSpec(name, "scl", f"blocks/{template or name}.scl.jinja", context or {})


def data_block(
    name: str, template: str = "", context: Mapping[str, object] | None = None
) -> BlockSpec:
    """A data block; its template is called like it if no other is named."""
    return BlockSpec(name, "db", f"data/{template or name}.db.jinja", context or {})
