"""The cells of an inverter: working memory and EEPROM, access rights, ranges, write cycles.

Which cells there are, what they take and which of them outlive a restart stands in the catalogue.
Facts about writing: VF-AS1 RS485 manual E6581315, pp. 17-20; TOSPBDP001 manual, sections 6 and 8 D
(an EEPROM cell stands about 10,000 writes).
"""

from collections.abc import Mapping

from fbgen.catalog import ComNo, Drive
from fbgen.wire.toshiba import ErrorCode


class Registers:
    """All cells of one inverter, by communication number.

    `ram` is what works and what a read gives; `eeprom` is what a restart loads; `write_cycles`
    counts the writes of each EEPROM cell. `latched` holds those cells that act only after a
    restart, with the word that acts. With `eeprom_faulty` no EEPROM cell takes a value for good,
    with `locked` no parameter can be written at all; commands and set-points can.
    """

    __slots__ = (
        "_numbers",
        "_ranges",
        "cells",
        "eeprom",
        "eeprom_faulty",
        "latched",
        "locked",
        "ram",
        "write_cycles",
    )

    def __init__(self, series: Drive, delivered: Mapping[int, int]) -> None:
        """`delivered`: words by number that differ from the defaults of the series."""
        self.cells: dict[int, ComNo] = {comno.number: comno for comno in series.comnos}
        self._numbers: dict[str, int] = {comno.name: comno.number for comno in series.comnos}
        self._ranges: dict[int, tuple[int, int]] = {
            comno.number: (comno.minimum_word, comno.maximum_word) for comno in series.comnos
        }
        self.eeprom: dict[int, int] = {
            comno.number: comno.default_word for comno in series.comnos if comno.storage == "eeprom"
        } | dict(delivered)
        self.write_cycles: dict[int, int] = dict.fromkeys(self.eeprom, 0)
        self.eeprom_faulty = self.locked = False
        self.ram: dict[int, int] = {}
        self.latched: dict[int, int] = {}
        self.restart()

    def restart(self) -> None:
        """Load the working memory anew: what was only in RAM is lost, what waited acts."""
        self.ram = {number: comno.default_word for number, comno in self.cells.items()}
        self.ram.update(self.eeprom)
        self.latched = {
            number: self.ram[number]
            for number, comno in self.cells.items()
            if comno.effect == "after_restart"
        }

    def factory_setting(self) -> None:
        """Give every EEPROM cell the value of a new inverter; it acts with the next restart."""
        for number in self.eeprom:
            self.eeprom[number] = self.cells[number].default_word

    def number(self, name: str) -> int:
        """The communication number of a name of the catalogue."""
        return self._numbers[name]

    def cell(self, name: str) -> ComNo:
        """What the catalogue says of a name."""
        return self.cells[self._numbers[name]]

    def word(self, name: str) -> int:
        """The word of a cell as it acts now."""
        number = self._numbers[name]
        return self.latched.get(number, self.ram[number])

    def value(self, name: str) -> float:
        """The value of a cell as it acts now, in the unit of the catalogue."""
        return self.cell(name).to_value(self.word(name))

    def refusal(self, number: int, word: int, running: bool) -> ErrorCode | None:
        """Why a write would be refused, or None.

        A cell that can only be read refuses with 0000: no document says which code it gives.
        """
        comno = self.cells.get(number)
        if comno is None:
            return ErrorCode.COM_NO
        if "w" not in comno.access or (running and comno.requires_stop):
            return ErrorCode.CANNOT_EXECUTE
        if self.locked and number in self.eeprom:
            return ErrorCode.CANNOT_EXECUTE
        lowest, greatest = self._ranges[number]
        if comno.limited_by is not None:
            greatest = min(greatest, comno.to_word(self.value(comno.limited_by)))
        if not lowest <= word <= greatest:
            return ErrorCode.DATA
        return None

    def write_ram(self, number: int, word: int) -> None:
        """Take a value until the next restart."""
        self.ram[number] = word

    def write_eeprom(self, number: int, word: int) -> ErrorCode | None:
        """Take a value for good; a cell that has no place in the EEPROM takes it in RAM only."""
        if number in self.eeprom:
            if self.eeprom_faulty:
                return ErrorCode.CANNOT_EXECUTE
            self.eeprom[number] = word
            self.write_cycles[number] += 1
        self.ram[number] = word
        return None
