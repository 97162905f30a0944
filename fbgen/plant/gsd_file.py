"""The GSD file that a plant file names, and the modules that are plugged."""

from collections.abc import Sequence
from hashlib import sha256
from pathlib import Path
from typing import TYPE_CHECKING, Any

from pydantic import GetCoreSchemaHandler
from pydantic_core import CoreSchema, core_schema

from fbgen.catalog import Layout, ProfibusGateway
from fbgen.dataclass import dataclass
from fbgen.diagnostics import Diagnostic, DiagnosticError, error
from fbgen.source import Span

if TYPE_CHECKING:
    from fbgen.plant.plant import PlantGateway
    from fbgen.wire.gsd import Configuration, GsdStation

# What reads GSD files is imported where one is read: few plants name one.


@dataclass(frozen=True, slots=True, eq=False)
class GsdFile:
    """A GSD file as a plant file names it, from the folder of that.

    It is read when the plant is: `station` is None where `findings` say why.
    """

    path: str
    station: "GsdStation | None"
    findings: tuple[Diagnostic, ...] = ()

    @property
    def content_hash(self) -> str:
        """Stands for what is in the file: the plant's hash changes with it."""
        if self.station is None:
            return ""
        return sha256(self.station.source.text.encode("utf-8", "surrogatepass")).hexdigest()

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, GsdFile):
            return NotImplemented
        return (self.path, self.content_hash) == (other.path, other.content_hash)

    def __hash__(self) -> int:
        return hash((self.path, self.content_hash))

    def __str__(self) -> str:
        return f"{self.path} (content {self.content_hash[:8]})"

    @classmethod
    def __get_pydantic_core_schema__(cls, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        return core_schema.no_info_plain_validator_function(
            cls._given,
            json_schema_input_schema=core_schema.str_schema(min_length=1),
            serialization=core_schema.plain_serializer_function_ser_schema(
                lambda file: {"path": file.path, "content": file.content_hash}
            ),
        )

    @classmethod
    def _given(cls, value: object) -> "GsdFile":
        if isinstance(value, GsdFile):
            return value
        raise ValueError("the GSD file is named by a text: its path from the plant file")


def read_gsd_file(path: Path, name: str, place: Span | None = None) -> "GsdStation":
    """The station in a file, called `name` in messages; `place` is where a plant file names it.

    Raises DiagnosticError FB1008 for a file that cannot be read, FB1301 to FB1306 as `read_gsd`.
    """
    from fbgen.wire.gsd import MAX_BYTES, read_gsd  # noqa: PLC0415

    try:
        with path.open("rb") as file:
            data = file.read(MAX_BYTES + 1)
    except (OSError, ValueError) as problem:
        reason = getattr(problem, "strerror", None) or str(problem)
        help_text = "name the GSD file of the device, beside the plant file or below it"
        raise error("FB1008", f"{name} cannot be read: {reason}", place, help_text) from None
    return read_gsd(data, name)


def gsd_file(path: str, folder: Path, place: Span | None) -> GsdFile:
    """The file that a plant file in this folder names."""
    try:
        return GsdFile(path, read_gsd_file(folder / path, path, place))
    except DiagnosticError as wrong:
        return GsdFile(path, None, wrong.diagnostics)


def layout_named_by(station: "GsdStation", modules: Sequence[str], entry: ProfibusGateway) -> str:
    """The layout of a gateway that these modules carry: the same identifiers, or as many bytes.

    The usual layout where there is none, "" where the modules cannot be plugged or nothing says
    which: checks of the plant tell what is wrong then.
    """
    from fbgen.wire.gsd import choose  # noqa: PLC0415

    try:
        chosen = choose(station, modules)
    except DiagnosticError:
        return ""
    same = [one.name for one in entry.layouts if one.identifiers == chosen.code]
    alike = [one.name for one in entry.layouts if _lengths(one) == _lengths(chosen)]
    return (*same, *alike, entry.default_layout)[0]


def configuration_of(part: "PlantGateway", layout: Layout | None) -> "Configuration":
    """The modules that are plugged at a gateway whose plant file names a GSD file that was read.

    A layout that the plant file says helps to choose among them. Raises
    DiagnosticError FB1310, FB1311 at the places in the plant file.
    """
    from fbgen.wire.gsd import choose  # noqa: PLC0415

    assert part.gsd is not None, "the caller has asked"
    assert part.gsd.station is not None, "the caller has asked"
    places = [part.item_span_of("modules", index) for index in range(len(part.modules))]
    of_all = part.span_of("modules") if part.modules else part.span_of("gsd")
    written = layout is not None and (part.span is None or part.span_of("layout") != part.span)
    lengths = _lengths(layout) if layout is not None and written else None
    return choose(part.gsd.station, part.modules, (*places, of_all), lengths)


def plugged(part: "PlantGateway", entry: ProfibusGateway) -> "Configuration | None":
    """As `configuration_of` for the gateway's layout; None without a GSD file, or where it does not
    fit, which checks of the plant tell."""
    if part.gsd is None or part.gsd.station is None:
        return None
    layout = entry.layout(part.layout)
    try:
        found = configuration_of(part, layout)
    except DiagnosticError:
        return None
    return found if _lengths(found) == _lengths(layout) else None


def _lengths(carrier: "Configuration | Layout") -> tuple[int, int]:
    return carrier.output_length, carrier.input_length
