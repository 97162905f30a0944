"""The ComNos of a series and the bits of their words as items of catalogue coverage."""

from collections.abc import Iterator

from fbgen.catalog import ComNo, Drive
from harness.verify.coverage.catalogue import (
    READ,
    READ_WORDS,
    WRITTEN,
    WRITTEN_WORDS,
    CatalogueCoverage,
)
from harness.verify.coverage.left_out import is_counted
from harness.verify.coverage.word_items import values_in, values_of


def know_comnos(coverage: CatalogueCoverage, drive: Drive) -> None:
    """Say what there is of a series."""
    coverage.know(WRITTEN, _comnos(drive, "w"))
    coverage.know(READ, _comnos(drive, "r"))
    for comno in drive.comnos:
        if comno.word is not None and is_counted(drive.word(comno.word)):
            items = list(values_of(f"{drive.id}.{comno.word}", drive.word(comno.word)))
            for group, access in ((WRITTEN_WORDS, "w"), (READ_WORDS, "r")):
                if access in comno.access:
                    coverage.know(group, items)


def see_comno(
    coverage: CatalogueCoverage, groups: tuple[str, str], drive: Drive, number: int, data: int
) -> None:
    """A ComNo was read or written, as `groups` say: that of ComNos, and that of bits. Nothing for
    one that is unknown."""
    group, words = groups
    comno = next((one for one in drive.comnos if one.number == number), None)
    if comno is None:
        return
    coverage.see(group, _comno(drive, comno))
    if comno.word is not None:
        for item in values_in(f"{drive.id}.{comno.word}", drive.word(comno.word), data):
            coverage.see(words, item)


def _comnos(drive: Drive, access: str) -> Iterator[str]:
    return (_comno(drive, one) for one in drive.comnos if access in one.access)


def _comno(drive: Drive, comno: ComNo) -> str:
    return f"{drive.id} {comno.hex} {comno.name}"
