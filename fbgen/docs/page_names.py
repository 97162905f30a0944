"""How pages and their anchors are called, so that one can lead to the other."""

from fbgen.catalog import ComNo, Trip
from fbgen.docs.document import Link


def device_page(device: str) -> str:
    """The page of a gateway or of a series."""
    return device


def word_page(device: str, word: str) -> str:
    """The page of a word."""
    return f"{device}.{word}"


def comno_page(series: str) -> str:
    """The page with all ComNos of a series."""
    return f"{series}-comnos"


def trip_page(series: str) -> str:
    """The page with all trips and alarms of a series."""
    return f"{series}-trips"


def protocol_page(protocol: str) -> str:
    """The page of a protocol."""
    return f"protocol-{protocol}"


def block_page(block: str) -> str:
    """The page of a block."""
    return f"block-{block}"


def manual_page(manual: str) -> str:
    """The page of a manual."""
    return manual


def comno_link(series: str, comno: ComNo) -> Link:
    """To the row of a ComNo."""
    return Link(comno.hex, comno_page(series), comno_anchor(comno))


def comno_anchor(comno: ComNo) -> str:
    """The row of a ComNo."""
    return comno.hex


def trip_anchor(trip: Trip) -> str:
    """The row of a trip."""
    return f"trip-{trip.code:02X}"
