"""Looks on at serial lines of the PLC: ComNos, their bits, and the refusals of the drives."""

from collections.abc import Mapping

from fbgen.catalog import Catalog, Drive
from fbgen.plant import SerialLine
from fbgen.wire import modbus, modbus_rtu, toshiba_stream
from fbgen.wire.single_words import Wanted, said_in, wanted_in
from fbgen.wire.toshiba import ErrorReply
from harness.installation import Installation
from harness.line import Transmission
from harness.verify.coverage.catalogue import (
    READ,
    READ_WORDS,
    REFUSALS,
    WRITTEN,
    WRITTEN_WORDS,
    CatalogueCoverage,
)
from harness.verify.coverage.comnos import know_comnos, see_comno


class SerialLineWatch:
    """Telegrams of the module and replies of the drives of one line.

    What the words of a MODBUS reply are of, the request before it says.
    """

    def __init__(self, plant: Installation, coverage: CatalogueCoverage, line: SerialLine) -> None:
        self._coverage = coverage
        self._line = line
        self._port = plant.devices.modules[line.name].port
        self._series: Mapping[int, Drive] = {
            item.inv_no: plant.catalog.drive(item.series) for item in line.drives
        }
        self._asked: Wanted | None = None
        self._errors = _errors(line, plant.catalog)
        coverage.know(REFUSALS, self._errors.values())
        for drive in self._series.values():
            know_comnos(coverage, drive)
        plant.lines[line.name].taps.append(self._heard)

    def _heard(self, transmission: Transmission) -> None:
        family, data = self._line.family, transmission.data
        if transmission.sender is self._port:
            self._asked = wanted_in(family, data)
            if self._asked is not None and self._asked.writes:
                self._tell(WRITTEN, WRITTEN_WORDS, self._asked.com_no, self._asked.data)
            return
        if transmission.sender is None:
            return
        said = said_in(family, data)
        if said is None:
            self._coverage.see(REFUSALS, self._errors.get(_refusal(family, data), ""))
        elif self._asked is not None and not self._asked.writes:
            self._tell(READ, READ_WORDS, self._asked.com_no, said.data)

    def _tell(self, group: str, words: str, number: int, data: int) -> None:
        """A broadcast is told of all drives, as each hears it."""
        asked = self._asked
        assert asked is not None, "only what was asked is told"
        one = self._series.get(asked.inv_no)
        for drive in self._series.values() if one is None else (one,):
            see_comno(self._coverage, (group, words), drive, number, data)


def _errors(line: SerialLine, catalog: Catalog) -> dict[int, str]:
    if line.family == "modbus":
        protocol = catalog.modbus_protocol("modbus")
        return {one.code: f"modbus {one.code:02X} {one.name}" for one in protocol.exceptions}
    errors = catalog.toshiba_protocol("toshiba").errors
    return {one.code: f"toshiba {one.code:04X} {one.name}" for one in errors}


def _refusal(family: str, data: bytes) -> int:
    """The code of a refusal; -1 for what is none."""
    if family == "modbus":
        reply = modbus_rtu.parse_reply(data)
        return reply.code if isinstance(reply, modbus.ExceptionReply) else -1
    answer = toshiba_stream.parse_reply(data)
    return int(answer.error) if isinstance(answer, ErrorReply) else -1
