"""The inputs and outputs of the gateways with names.

For TIA Portal as its tag tables are imported: the sheets "PLC Tags" and "TagTable Properties" of an
export, every value as a text (published exports of V16 to V20). For the other tools a table that
says what each byte is: in the symbol table of STEP 7, or to link the located variables of IEC text.
"""

from collections.abc import Iterator

from fbgen.artefacts.spreadsheet import Sheet, workbook
from fbgen.artefacts.text_table import csv_table
from fbgen.artefacts.view import PlantLists
from fbgen.catalog import CyclicField
from fbgen.dataclass import dataclass
from fbgen.emit.generated import Artefact
from fbgen.plant import PlantGateway

_TIA_COLUMNS = (
    "Name",
    "Path",
    "Data Type",
    "Logical Address",
    "Comment",
    "Hmi Visible",
    "Hmi Accessible",
    "Hmi Writeable",
    "Typeobject ID",
    "Version ID",
)
_VISIBLE = ("True", "True", "False", "", "")


@dataclass(frozen=True, slots=True)
class IoTag:
    """A field of the cyclic data in the input or the output area."""

    name: str
    area: str
    byte: int
    length: int
    comment: str
    peripheral: bool

    @property
    def type(self) -> str:
        """What it holds."""
        return "Word" if self.length == 2 else "Byte"

    @property
    def address(self) -> str:
        """As in S7: words are counted in bytes."""
        return f"{self.area}{self.type[0]}{self.byte}"

    def bytes_of(self) -> list[str]:
        """Its bytes, the high one first, as IEC text locates them."""
        return [f"{self.area}B{self.byte + index}" for index in range(self.length)]


def io_tags(lists: PlantLists) -> Iterator[IoTag]:
    """All fields of all gateways that have addresses, but what nobody explains (pads)."""
    for gateway in lists.plant.gateways:
        layout = lists.layout(gateway)
        yield from _fields(gateway, "I", gateway.input_address, layout.input)
        yield from _fields(gateway, "Q", gateway.output_address, layout.output)


def plc_tags(lists: PlantLists) -> list[Artefact]:
    """The list of the plant's dialect; none where no gateway has addresses."""
    tags = list(io_tags(lists))
    if not tags:
        return []
    if lists.plant.dialect != "tia":
        halves = (
            lists.in_words("high byte", "hohes Byte"),
            lists.in_words("low byte", "tiefes Byte"),
        )
        rows = _plain_rows(tags, halves, by_bytes=lists.plant.dialect != "step7")
        return [Artefact(lists.file_name("io.csv"), csv_table(rows))]
    table = lists.file_name("io")
    rows = [[tag.name, table, tag.type, f"%{tag.address}", tag.comment, *_VISIBLE] for tag in tags]
    properties = [["Path", "BelongsToUnit", "Accessibility"], [table, "", ""]]
    book = workbook(
        [Sheet("PLC Tags", [_TIA_COLUMNS, *rows]), Sheet("TagTable Properties", properties)]
    )
    return [Artefact(lists.file_name("plc_tags.xlsx"), book)]


def _fields(
    gateway: PlantGateway, area: str, first: int | None, fields: tuple[CyclicField, ...]
) -> Iterator[IoTag]:
    if first is None:
        return
    direction = "in" if area == "I" else "out"
    for field in fields:
        if not field.pad:
            yield IoTag(
                f"{gateway.name}_{direction}_{field.name}",
                area,
                first + field.offset,
                field.length,
                f"{gateway.name}: {field.title}",
                gateway.access != "process_image",
            )


def _plain_rows(tags: list[IoTag], halves: tuple[str, str], *, by_bytes: bool) -> list[list[str]]:
    rows = [["Name", "Address", "Type", "Comment"]]
    for tag in tags:
        if not by_bytes:
            past_the_image = "P" if tag.peripheral else ""
            rows.append([tag.name, past_the_image + tag.address, tag.type.upper(), tag.comment])
            continue
        for index, place in enumerate(tag.bytes_of()):
            which = "" if tag.length == 1 else f", {halves[index]}"
            rows.append([place, f"%{place}", "BYTE", tag.comment + which])
    return rows
