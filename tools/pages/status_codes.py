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


def _blocks(item: StatusCodes) -> list[str]:
    """The blocks in whose template a code stands; those that pass on another's do not count.

    0000 is in the words of all of them, and 85xx is put together from what the gateway says.
    """
    if item.codes == (0,):
        return []
    wanted = ["8500"] if item.codes[0] >= 0x8500 else item.text.split(", ")
    family = {("lines",): "TOS_", ("channels",): "PBDP_"}.get(item.having, "")
    return [
        name
        for name, text in _templates().items()
        if name.startswith(family) and any(re.search(rf"16#{code}\b", text) for code in wanted)
    ]
