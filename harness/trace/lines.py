"""The lines of a trace file as models: `schemas/trace.schema.json`, and what the reader accepts.

`docs/reference/trace.md` describes them. A key whose value is the default is left out.
"""

from typing import Annotated, Literal, TypeAlias

from pydantic import BaseModel, ConfigDict, Field, RootModel

from fbgen.wire.devicenet import MAX_IDENTIFIER
from harness.trace.model import ChannelKind, FrameKind, Group, MarkKind, Verdict

TimeNs = Annotated[int, Field(ge=0, description="Nanoseconds of the plant's own clock.")]
Number = Annotated[int, Field(ge=0)]
Octets = Annotated[
    str, Field(pattern="^([0-9A-F]{2}( [0-9A-F]{2})*)?$", description="Bytes in hexadecimal.")
]
PlaceNumber = Annotated[int, Field(ge=0, description="Number of a place line.")]


class _Line(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True, strict=True)


class TraceLine(_Line):
    """The first line of a run. A file may hold several runs, one behind the other."""

    type: Literal["trace"]
    version: Literal[1] = Field(description="Version of this format.")
    title: str = Field(description="Title of the scenario with its variation.")
    scenario: str = Field("", description="The scenario file; missing without one.")
    seed: int
    engine: str = Field(description="compiled or reference.")
    dialect: str = Field(description="Dialect of the PLC text.")
    writers: bool = Field(description="Whether the run knew which statement wrote what.")
    start_ns: TimeNs = Field(description="When recording began.")
    end_ns: TimeNs = Field(description="When recording ended.")


class FieldPart(_Line):
    """A bit, or a row of bits, of a word."""

    name: str
    title: str
    low: int = Field(ge=0, le=63)
    high: int = Field(ge=0, le=63)
    meanings: dict[str, str] = Field(
        default_factory=dict, description="What values mean; the keys are decimal numbers."
    )


class WordLine(_Line):
    """How the bits of a word are called."""

    type: Literal["word"]
    name: str = Field(description="As in the catalogue, such as tospbdp001.status.")
    title: str
    fields: list[FieldPart] = Field(description="Highest bit first.")


class PlaceLine(_Line):
    """A place in PLC text or in the scenario file. They are numbered from 0 in their order."""

    type: Literal["place"]
    id: Number
    file: str
    line: int = Field(ge=1)
    column: int = Field(ge=1)
    text: str = Field(description="The line, without blanks around it.")
    block: str = Field("", description="The PLC block that the line stands in.")
    instance: str = Field("", description="Which instance of the block ran.")


class ChannelLine(_Line):
    """Something with one value at any time. They are numbered from 0 in their order."""

    type: Literal["channel"]
    id: Number
    path: str = Field(description="As scenario files name it.")
    title: str
    kind: ChannelKind
    group: Group
    owner: str = Field("", description="Gateway, line, network, drive, or data block.")
    unit: str = ""
    bits: int = Field(0, ge=0, le=64, description="How many a word has.")
    word: str | None = Field(None, description="Name of the word that decodes it.")


class ChangeLine(_Line):
    """A channel has another value from now on."""

    type: Literal["change"]
    t: TimeNs
    c: Number = Field(description="Number of the channel.")
    v: bool | int | float | str = Field(
        description="By the kind of the channel: true or false; a whole number; a number, or one "
        "of the texts NaN, Infinity, -Infinity; a text; bytes in hexadecimal."
    )
    w: PlaceNumber | None = Field(None, description="Number of the place that wrote the value.")


class FrameLine(_Line):
    """Bytes on a line, or a CAN frame on a DeviceNet network."""

    type: Literal["frame"]
    t: TimeNs = Field(description="When the first byte began.")
    end_ns: TimeNs = Field(description="When the last byte was over.")
    line: str = Field(description="The gateway whose line it is, the serial line, or the network.")
    sender: str | None = Field(None, description="Missing for bytes that come from outside.")
    to_drives: bool
    kind: FrameKind
    identifier: int | None = Field(
        None, ge=0, le=MAX_IDENTIFIER, description="Of a CAN frame: what its data are."
    )
    data: Octets = Field(description="What was sent.")
    heard: Octets | None = Field(None, description="What arrived, if that is something else.")
    damaged: bool = Field(False, description="Characters have a parity or framing error.")
    collided: bool = Field(False, description="Somebody else sent at the same time.")
    meaning: str = ""


class TelegramLine(_Line):
    """A telegram of a gateway's cyclic data, without padding, with its reply."""

    type: Literal["telegram"]
    t: TimeNs = Field(description="When the gateway got the trigger.")
    gateway: str
    output: Octets = Field(description="Control word, trigger, INV-NO, command, ComNo, data.")
    received_ns: TimeNs | None = Field(None, description="When the master had the reply.")
    input: Octets | None = Field(None, description="Status word, INV-NO, command, ComNo, data.")
    meaning: str = ""
    w: PlaceNumber | None = Field(None, description="Number of the place that wrote the trigger.")


class MarkLine(_Line):
    """A step, a check or a fault of the scenario."""

    type: Literal["mark"]
    t: TimeNs = Field(description="When it began.")
    end_ns: TimeNs | None = Field(None, description="Missing for what was still there at the end.")
    kind: MarkKind
    title: str
    target: str = Field("", description="A gateway, a drive, a path; missing for the whole plant.")
    place: PlaceNumber | None = Field(None, description="Number of its place in the scenario.")
    verdict: Verdict | None = None


Line: TypeAlias = (
    TraceLine
    | WordLine
    | PlaceLine
    | ChannelLine
    | ChangeLine
    | FrameLine
    | TelegramLine
    | MarkLine
)


class TraceFileLine(RootModel[Annotated[Line, Field(discriminator="type")]]):
    """One line of a trace file (JSON Lines)."""
