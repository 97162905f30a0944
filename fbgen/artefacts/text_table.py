"""Tables as text: CSV after RFC 4180, UTF-8 with the mark by which spreadsheets know it."""

import csv
from collections.abc import Iterable, Sequence
from io import StringIO


def csv_table(rows: Iterable[Sequence[str]]) -> bytes:
    """The bytes of a table; fields with commas, quotes or line ends are quoted."""
    target = StringIO(newline="")
    csv.writer(target, lineterminator="\r\n").writerows(rows)
    return target.getvalue().encode("utf-8-sig")
