"""The cyclic data of a gateway as templates see them: fields with the addresses to access."""

from collections.abc import Mapping

from fbgen.blocks.literals import SclText
from fbgen.catalog import CyclicField, Layout, origin
from fbgen.dataclass import dataclass
from fbgen.plant import Plant, PlantGateway


@dataclass(frozen=True, slots=True)
class FieldView:
    """A field of the cyclic data. `parts` are the addresses to access, the high byte first."""

    name: str
    offset: int
    size: int
    parts: tuple[SclText, ...]


@dataclass(frozen=True, slots=True)
class FrameView:
    """Both directions of a gateway's cyclic data, and how the program reaches them.

    `last` is the name of the output that goes out behind all others, because the gateway acts when
    it changes; None where nothing depends on the order.
    """

    access: str
    layout_id: str
    identifiers: str
    output_length: int
    input_length: int
    inputs: tuple[FieldView, ...]
    outputs: tuple[FieldView, ...]
    laddr_in: SclText
    laddr_out: SclText
    last: str | None = None

    @property
    def outputs_in_order(self) -> tuple[FieldView, ...]:
        """As they are written one by one: backwards, DATA first, `last` at the very end."""
        behind = tuple(item for item in self.outputs if item.name == self.last)
        return (*reversed(self.outputs_at_once), *behind)

    @property
    def outputs_at_once(self) -> tuple[FieldView, ...]:
        """Everything but `last`, in ascending order."""
        return tuple(item for item in self.outputs if item.name != self.last)

    @property
    def last_address(self) -> SclText | None:
        """Where `last` lies."""
        return next((item.parts[0] for item in self.outputs if item.name == self.last), None)


def frame_view(
    plant: Plant,
    gateway: PlantGateway,
    layout: Layout,
    members: Mapping[str, str],
    last: str | None = None,
) -> FrameView:
    """The frame of one gateway; `members` are the names of the program for those of the layout."""
    return FrameView(
        access=gateway.access,
        layout_id=layout.name,
        identifiers=layout.identifiers.hex(" ").upper(),
        output_length=layout.output_length,
        input_length=layout.input_length,
        inputs=_fields(layout, gateway, "I", members),
        outputs=_fields(layout, gateway, "Q", members),
        laddr_in=_laddr(plant, gateway, gateway.input_address),
        laddr_out=_laddr(plant, gateway, gateway.output_address),
        last=last,
    )


def _fields(
    layout: Layout, gateway: PlantGateway, area: str, members: Mapping[str, str]
) -> tuple[FieldView, ...]:
    fields = layout.output if area == "Q" else layout.input
    base = (gateway.output_address if area == "Q" else gateway.input_address) or 0
    views = []
    for item in fields:
        if item.pad:
            continue
        source = origin(f"layout {layout.name}, {item.name}", item, layout.source or "")
        words = gateway.access == "per_identifier" and _is_word(layout, item, area)
        parts = (
            (f"%{area}W{base + item.offset}",)
            if words
            else tuple(f"%{area}B{base + offset}" for offset in range(item.offset, item.end))
        )
        texts = tuple(SclText(part, source) for part in parts)
        views.append(FieldView(members[item.name], item.offset, item.length, texts))
    return tuple(views)


def _is_word(layout: Layout, item: CyclicField, area: str) -> bool:
    """Whether a unit of one identifier is just this field: then one access moves it as a whole.

    The process image is accessed by bytes: IEC 61131-3 counts words where S7 counts bytes.
    """
    for identifier in layout.parsed_identifiers:
        start = identifier.output_offset if area == "Q" else identifier.input_offset
        length = identifier.output_length if area == "Q" else identifier.input_length
        if start <= item.offset < start + length:
            inside = item.offset - start
            return item.length == 2 and identifier.unit_length == 2 and inside % 2 == 0
    return False


def _laddr(plant: Plant, gateway: PlantGateway, address: int | None) -> SclText:
    """S7-1200/1500 take the hardware identifier, S7-300/400 the start address."""
    source = origin(f"gateway {gateway.name}", gateway)
    if plant.family.classic:
        return SclText(f"W#16#{address or 0:X}", source)
    return SclText(str(gateway.hardware_identifier or 0), source)
