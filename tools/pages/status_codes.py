"""The page of the status codes, from their list and from the templates that set them."""

import re
from functools import cache
from pathlib import Path

from fbgen.blocks.status_codes import STATUS_CODES, StatusCodes
from fbgen.resources import shipped

TEXT = Path(__file__).parent / "texts" / "status-codes.md"


def status_codes_page() -> str:
    """The page."""
    rows = "".join(map(_row, STATUS_CODES))
    return TEXT.read_text(encoding="utf-8").replace("@ROWS@\n", rows)


def _row(item: StatusCodes) -> str:
    remedy = item.remedy or "nothing"
    blocks = ", ".join(f"`{name}`" for name in _blocks(item))
    return f"| {item.text} | {item.english} | {blocks} | {remedy} |\n"


@cache
def _templates() -> dict[str, str]:
    paths = sorted((shipped("templates") / "blocks").glob("*.scl.jinja"))
    return {path.name.partition(".")[0]: path.read_text(encoding="utf-8") for path in paths}


FAMILIES = {
    "lines": ("TOS_",),
    "serial": ("TIP_", "MB_"),
    "channels": ("PBDP_",),
    "parameters": ("PBDP_",),
    "sequences": ("TOS_Seq",),
    "devicenet": ("DEV_",),
}
"""How the names of the blocks begin that a plant must have for a code."""
PUT_TOGETHER = {
    0x8410: "TIP_Telegram",
    0x8421: "MB_Telegram",
    0x8500: "PBDP_Parameter",
    0x8564: "PBDP_Parameter",
}
"""Who puts codes together from what a drive or a gateway has said, by the first of them."""


def _blocks(item: StatusCodes) -> list[str]:
    """The blocks in whose template a code stands; those that pass on another's do not count.

    0000 is in the words of all of them.
    """
    if item.codes == (0,):
        return []
    if item.codes[0] in PUT_TOGETHER:
        return [PUT_TOGETHER[item.codes[0]]]
    families = tuple(prefix for one in item.having for prefix in FAMILIES[one]) or ("",)
    return [
        name
        for name, text in _templates().items()
        if name.startswith(families)
        and any(re.search(rf"16#{code}\b", text) for code in item.text.split(", "))
    ]
