"""The inputs and outputs of gateways and DeviceNet scanners with names.

For TIA Portal as its tag tables are imported: the sheets "PLC Tags" and "TagTable Properties" of an
export, every value as a text (published exports of V16 to V20). For the other tools a table that
says what each byte is: in the symbol table of STEP 7, or to link the located variables of IEC text.
"""

from collections.abc import Iterator

from fbgen.artefacts.spreadsheet import Sheet, workbook
from fbgen.artefacts.text_table import csv_table
from fbgen.artefacts.view import PlantLists
from fbgen.blocks.dev_assemblies import pair_of
from fbgen.catalog import Assembly, CyclicField
from fbgen.dataclass import dataclass
from fbgen.emit.generated import Artefact
from fbgen.plant import DeviceNetDrive, DeviceNetNetwork, PlantGateway

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
    """All fields of all gateways that have addresses, but what nobody explains (pads), and all
    bytes of DeviceNet."""
    for gateway in lists.plant.gateways:
        layout = lists.layout(gateway)
        yield from _fields(gateway, "I", gateway.input_address, layout.input)
        yield from _fields(gateway, "Q", gateway.output_address, layout.output)
    for network in lists.plant.devicenet:
        yield from _table(lists, network)
        for drive in network.drives:
            pair = pair_of(drive, lists.catalog.devicenet_gateway(drive.type))
            yield from _bytes(lists, drive, "I", drive.input_address, pair.input)
            yield from _bytes(lists, drive, "Q", drive.output_address, pair.output)


def plc_tags(lists: PlantLists) -> list[Artefact]:
    """The list of the plant's dialect; none where nothing has addresses."""
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


def _table(lists: PlantLists, network: DeviceNetNetwork) -> Iterator[IoTag]:
    """The bytes of the scanner's table that have a bit for a drive."""
    first = network.active_address
    assert first is not None, "checked before"
    macs = sorted(drive.mac for drive in network.drives)
    for place in dict.fromkeys(mac // 8 for mac in macs):
        there = ", ".join(str(mac) for mac in macs if mac // 8 == place)
        what = lists.in_words(
            f"who exchanges data: MAC ID {there}", f"wer teilnimmt: MAC-ID {there}"
        )
        comment = f"{network.name}: {what}"
        yield IoTag(f"{network.name}_active_{place}", "I", first + place, 1, comment, False)


def _bytes(
    lists: PlantLists, drive: DeviceNetDrive, area: str, first: int, assembly: Assembly
) -> Iterator[IoTag]:
    """The bytes of an assembly one by one: the low one of a word comes first."""
    direction = "in" if area == "I" else "out"
    halves = (
        ("low", lists.in_words("low byte", "tiefes Byte")),
        ("high", lists.in_words("high byte", "hohes Byte")),
    )
    for field in assembly.fields:
        for place, (half, in_words) in enumerate(halves):
            yield IoTag(
                f"{drive.name}_{direction}_{field.name}_{half}",
                area,
                first + field.offset + place,
                1,
                f"{drive.name}: {lists.texts(field.title)}, {in_words}",
                False,
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
