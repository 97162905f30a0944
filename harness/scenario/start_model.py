"""How gateways, PROFIBUS and PLC are when a scenario starts: phases, and what is left over.

Nothing keeps the PLC's scan, the PROFIBUS cycle and the gateway's look at the trigger together, and
a PLC is restarted while its gateways go on: what is in them then is part of the start.
"""

from typing import Annotated

from pydantic import AfterValidator, BeforeValidator, Field
from pydantic.json_schema import WithJsonSchema

from fbgen.catalog import Located
from fbgen.catalog.located import describe
from fbgen.catalog.scalars import Octets
from fbgen.lang.ast import LiteralKind
from fbgen.lang.literals import BadLiteralError, read_literal
from harness.durations import DurationNs, PositiveDurationNs
from harness.fieldbus import CycleTimes
from harness.gateways.tospbdp001 import Memory
from harness.kernel import NS_PER_MS

REPLY_BYTES = 6


def _bits(value: object) -> object:
    """254 or 16#FE. Raises ValueError."""
    if isinstance(value, str):
        try:
            literal = read_literal(value)
        except (BadLiteralError, IndexError):
            literal = None
        if literal is not None and literal.kind is LiteralKind.INTEGER:
            return literal.value
    elif isinstance(value, int) and not isinstance(value, bool):
        return value
    raise ValueError(f"found {describe(value)}, expected a whole number such as 254 or 16#FE")


def _whole_reply(value: bytes) -> bytes:
    if len(value) != REPLY_BYTES:
        raise ValueError(f"{len(value)} bytes, where a reply has {REPLY_BYTES}: 0B 47 FC 90 00 00")
    return value


_SCHEMA = {
    "type": ["integer", "string"],
    "pattern": r"^((2|8|16)#)?[0-9A-Fa-f_]+$",
    "minimum": 0,
}
_Byte = Annotated[
    int,
    BeforeValidator(_bits),
    Field(ge=0, le=0xFF),
    WithJsonSchema(_SCHEMA | {"maximum": 0xFF}),
]
_Word = Annotated[
    int,
    BeforeValidator(_bits),
    Field(ge=0, le=0xFFFF),
    WithJsonSchema(_SCHEMA | {"maximum": 0xFFFF}),
]


class GatewaySetup(Located):
    """What is in a gateway that kept its supply while the PLC was started anew."""

    trigger: _Byte = Field(default=0x00, description="The trigger byte that it has seen last")
    status: _Word = Field(
        default=0x9F00,
        description="Its status word",
        json_schema_extra={"default": "16#9F00"},
    )
    reply: Annotated[Octets, AfterValidator(_whole_reply)] = Field(
        default=bytes(REPLY_BYTES),
        description="The six bytes of the last reply: INV-NO, CMD, ComNo, data",
        json_schema_extra={"default": "00 00 00 00 00 00"},
    )

    def memory(self) -> Memory:
        """The same as the gateway takes it."""
        return Memory(self.trigger, self.status, self.reply)


class PlantTimes(Located):
    """The times of PROFIBUS and PLC that no plant file says."""

    profibus: PositiveDurationNs = Field(
        default=2 * NS_PER_MS,
        description="From one cycle of the DP master to the next",
        json_schema_extra={"default": "2 ms"},
    )
    start: DurationNs = Field(
        default=0,
        description="The PLC starts so much later than gateways and PROFIBUS",
        json_schema_extra={"default": "0 s"},
    )
    execution: PositiveDurationNs = Field(
        default=NS_PER_MS,
        description="How long the program of a scan takes until the outputs are written",
        json_schema_extra={"default": "1 ms"},
    )

    def bus(self) -> CycleTimes:
        """The cycle as the master takes it."""
        return CycleTimes(self.profibus)
