"""What telegrams mean, in words, from the catalogue."""

from fbgen.catalog import Catalog, Drive, ToshibaProtocol


def telegram_meaning(output: bytes, reply: bytes | None, drive: Drive, catalog: Catalog) -> str:
    """A telegram of the gateway's cyclic data (without padding) and its reply, as one sentence."""
    protocol = catalog.toshiba_protocol(drive.protocol)
    inv_no, cmd = output[3], output[4]
    comno, data = int.from_bytes(output[5:7], "big"), int.from_bytes(output[7:9], "big")
    command = next((item for item in protocol.commands if item.code == cmd), None)
    if command is None:
        return f"command {cmd:02X} is none of the protocol"
    name = cell_name(drive, comno)
    to = "all drives" if inv_no == _broadcast(protocol) else f"drive {inv_no}"
    if command.writes:
        return f"{to}: write {name} = {word_meaning(drive, comno, data)}"
    if reply is None:
        return f"{to}: read {name}"
    answered = int.from_bytes(reply[6:8], "big")
    return f"{to}: read {name} = {word_meaning(drive, comno, answered)}"


def cell_name(drive: Drive, comno: int) -> str:
    """A ComNo with its title, where it is known."""
    known = next((item for item in drive.comnos if item.number == comno), None)
    return f"{comno:04X} {known.title}" if known else f"{comno:04X}"


def word_meaning(drive: Drive, comno: int, data: int) -> str:
    """The value of a ComNo: set bits by name, or the physical value with its unit."""
    known = next((item for item in drive.comnos if item.number == comno), None)
    if known is None:
        return f"{data:04X}"
    if known.word is not None:
        fields = drive.word(known.word).decode(data)
        names = ", ".join(item.field.name for item in fields if item.value)
        return f"{data:04X} ({names or 'no bit set'})"
    decimals = max(0, len(f"{known.resolution:g}".partition(".")[2]))
    unit = f" {known.unit}" if known.unit else ""
    return f"{data:04X} ({known.to_value(data):.{decimals}f}{unit})"


def _broadcast(protocol: ToshibaProtocol) -> int:
    return int(protocol.inv_numbers["binary"].broadcast, 16)
