"""A series of inverters: its communication numbers, words, trips and times."""

from collections.abc import Iterable
from typing import Annotated, Literal

from pydantic import Field

from fbgen.catalog.communication import Communication, Parity, SerialPort, baud_rate_of, parity_of
from fbgen.catalog.located import Located
from fbgen.catalog.named import no_duplicates, pick, unknown_name
from fbgen.catalog.options import Option
from fbgen.catalog.scalars import Count, EntryId, Flag, HexWord, Number, Real, SnakeName, Text
from fbgen.catalog.settings import Setting, Switch
from fbgen.catalog.sourced import Duration, Sourced, unknown_fields
from fbgen.catalog.words import Word
from fbgen.diagnostics import Diagnostic, error
from fbgen.nearest import nearest

Access = Literal["r", "w", "rw"]
Storage = Literal["ram", "eeprom"]
Effect = Literal["at_once", "after_restart"]

_HEXADECIMAL = frozenset("0123456789ABCDEF")


class ComNo(Sourced):
    """A communication number: one 16-bit cell of an inverter.

    `resolution` is the physical size of one count, so value = word * resolution (in `unit`).
    `storage` says where the W command leaves the value: `eeprom` cells outlive a restart.
    `minimum`, `maximum` and `default` are physical. `limited_by` names the ComNo whose present
    value is a further upper limit. `frozen_copy_of` names the ComNo that this one repeats until a
    trip freezes it. `word` names the bit table of a bit word. `display` is the parameter's name
    on the operation panel. `values` gives the meaning of single values. `unverified` lists those
    fields that rest on no document although the number itself does.
    """

    number: HexWord
    name: SnakeName
    title: Text
    display: Text | None = None
    unit: str = ""
    resolution: Annotated[Real, Field(ge=1e-6)] = 1
    minimum: Real | None = None
    maximum: Real | None = None
    default: Real | None = None
    limited_by: SnakeName | None = None
    access: Access = "rw"
    storage: Storage = "ram"
    effect: Effect = "at_once"
    requires_stop: Flag = False
    word: SnakeName | None = None
    frozen_copy_of: SnakeName | None = None
    values: dict[Number, Text] = Field(default_factory=dict)
    unverified: tuple[SnakeName, ...] = ()
    remark: Text | None = None

    @property
    def hex(self) -> str:
        """The number as it is written everywhere: four hexadecimal digits."""
        return f"{self.number:04X}"

    @property
    def minimum_word(self) -> int:
        """The smallest word that the inverter takes."""
        return 0 if self.minimum is None else self.to_word(self.minimum)

    @property
    def maximum_word(self) -> int:
        """The greatest word that the inverter takes, apart from `limited_by`."""
        return 0xFFFF if self.maximum is None else self.to_word(self.maximum)

    @property
    def default_word(self) -> int:
        """The word of a new inverter."""
        return 0 if self.default is None else self.to_word(self.default)

    def to_word(self, value: float) -> int:
        """The word for a physical value, to the nearest count, not limited to any range."""
        return round(value / self.resolution)

    def to_value(self, word: int) -> float:
        """The physical value of a word."""
        return word * self.resolution

    def problems(self) -> Iterable[Diagnostic]:
        """FB1103 no source; FB1105 an unverified field that is none; FB1108 contradictory range."""
        yield from super().problems()
        yield from unknown_fields(self, self.unverified)
        if not 0 <= self.minimum_word <= self.maximum_word <= 0xFFFF:
            yield Diagnostic(
                "FB1108",
                f"the range {self.minimum} to {self.maximum} of '{self.name}' is no range of a "
                f"word at {self.resolution} {self.unit} a count",
                self.span_of("maximum" if self.maximum is not None else "minimum"),
                "minimum and maximum are physical values",
            )
        elif not self.minimum_word <= self.default_word <= self.maximum_word and (
            self.default is not None
        ):
            yield Diagnostic(
                "FB1108",
                f"the default {self.default} of '{self.name}' lies outside its range",
                self.span_of("default"),
            )


class Trip(Sourced):
    """A trip: the code that FC90 gives and the text that the panel shows."""

    code: HexWord
    display: Text
    meaning: Text
    cause: Text | None = None


class DriveTimes(Located):
    """The times of an inverter.

    `reply_max`: longest time from request to reply. `boot`: silent after power-on.
    `reset_silence`: silent after a fault reset.
    """

    reply_max: Duration
    boot: Duration
    reset_silence: Duration


class CommandLink(Located):
    """Which ComNos steer the inverter and tell its state, by the ComNos' names.

    `command_source` says whether it obeys the network or its panel; not every series has it.
    """

    command: SnakeName
    setpoint: SnakeName
    status: SnakeName
    trip: SnakeName
    alarm: SnakeName
    output_frequency: SnakeName
    output_current: SnakeName
    maximum_frequency: SnakeName
    timeout: SnakeName
    inv_no: SnakeName
    command_source: SnakeName | None = None


class TerminalFunction(Sourced):
    """A function that an input terminal can be given, by its number; `inverted` acts while off."""

    name: SnakeName
    number: Count
    inverted: Count | None = None
    title: Text


CommunicationPart = Literal["ports", "blocks", "toshiba", "modbus", "inter_drive"]


class Confirmed(Sourced):
    """ComNos, words and parts of the communication that a series was found to have as well."""

    comnos: tuple[HexWord, ...] = ()
    words: tuple[SnakeName, ...] = ()
    communication: tuple[CommunicationPart, ...] = ()


def _number(key: str) -> int | None:
    """The number that four hexadecimal digits stand for, `FA00` or `0xFA00`; None for a name."""
    digits = key.upper().removeprefix("0X")
    return int(digits, 16) if len(digits) == 4 and _HEXADECIMAL.issuperset(digits) else None


class Drive(Sourced):
    """One series of inverters.

    `like` names a series of which this one takes over what it does not have itself: words, ComNos,
    trips, terminal functions, options and parts of the communication. All of that is unverified,
    but for what is `confirmed`.
    """

    version: Literal[1]
    id: EntryId
    like: EntryId | None = None
    confirmed: tuple[Confirmed, ...] = ()
    title: Text
    protocol: EntryId
    manuals: tuple[Text, ...] = ()
    description: Text | None = None
    link: CommandLink
    times: DriveTimes
    communication: Communication | None = None
    words: tuple[Word, ...] = ()
    comnos: tuple[ComNo, ...] = ()
    trips: tuple[Trip, ...] = ()
    terminal_functions: tuple[TerminalFunction, ...] = ()
    options: tuple[Option, ...] = ()
    settings: tuple[Setting, ...] = ()
    switches: tuple[Switch, ...] = ()

    def comno(self, key: str | int) -> ComNo:
        """The ComNo of a name, of a number as text (`FA00`) or of a number.

        Raises DiagnosticError FB1105 with the nearest names.
        """
        number = key if isinstance(key, int) else _number(key)
        for comno in self.comnos:
            if comno.number == number or comno.name == key:
                return comno
        shown = f"{key:04X}" if isinstance(key, int) else key
        names = [comno.name for comno in self.comnos] + [comno.hex for comno in self.comnos]
        raise error("FB1105", f"'{self.id}' has no ComNo '{shown}'", help=nearest(shown, names))

    def word(self, name: str) -> Word:
        """The word of a name. Raises DiagnosticError FB1201 with the nearest names."""
        return pick(self.words, name, "FB1201", f"'{self.id}' has no word '{name}'")

    def setting(self, name: str) -> Setting | None:
        """How a ComNo is set for this kind of plant, by its name; None if nothing is said."""
        return next((item for item in self.settings if item.comno == name), None)

    @property
    def command_word(self) -> Word:
        """The bit table of the ComNo that starts and stops the inverter."""
        word = self.comno(self.link.command).word
        assert word is not None, "checked when the entry was read"
        return self.word(word)

    def baud_rates(self, port: SerialPort) -> dict[int, int]:
        """Value of the port's ComNo -> bit/s."""
        texts = self.comno(port.baud_rate).values
        return {value: rate for value, text in texts.items() if (rate := baud_rate_of(text))}

    def parities(self, port: SerialPort) -> dict[int, Parity]:
        """Value of the port's ComNo -> parity."""
        texts = self.comno(port.parity).values
        return {value: parity for value, text in texts.items() if (parity := parity_of(text))}

    def trip(self, code: int) -> Trip | None:
        """What a trip code means, or None where the catalogue does not say."""
        return next((trip for trip in self.trips if trip.code == code), None)

    def problems(self) -> Iterable[Diagnostic]:
        """FB1102 something twice; FB1105 a name of a ComNo or word that is not there."""
        yield from super().problems()
        if self.confirmed and self.like is None:
            message = "there is nothing to confirm: this series is like no other"
            yield Diagnostic("FB1105", message, self.span_of("confirmed"), "add like:")
        yield from no_duplicates(self.comnos, "number", lambda item: item.hex, "ComNo")
        yield from no_duplicates(self.comnos, "name", lambda item: item.name, "ComNo")
        yield from no_duplicates(self.words, "name", lambda item: item.name, "word")
        yield from no_duplicates(self.trips, "code", lambda item: f"{item.code:04X}", "trip")
        yield from no_duplicates(self.options, "id", lambda item: item.id, "option")
        yield from no_duplicates(self.settings, "comno", lambda item: item.comno, "setting")
        functions = self.terminal_functions
        yield from no_duplicates(functions, "name", lambda item: item.name, "terminal function")
        names = {comno.name for comno in self.comnos}
        for role in CommandLink.model_fields:
            yield from unknown_name(self.link, role, getattr(self.link, role), names, "ComNo")
        for setting in self.settings:
            yield from unknown_name(setting, "comno", setting.comno, names, "ComNo")
        yield from self._problems_of_comnos(names)
        yield from self._problems_of_words(names)
        if self.communication is not None:
            yield from self.communication.unknown_comnos(names)
            options = {option.id for option in self.options}
            yield from self.communication.unknown_options(options)
            for port in self.communication.ports:
                yield from self._problems_of_port(port)

    def _problems_of_comnos(self, names: set[str]) -> Iterable[Diagnostic]:
        words = {word.name for word in self.words}
        for comno in self.comnos:
            yield from unknown_name(comno, "limited_by", comno.limited_by, names, "ComNo")
            yield from unknown_name(comno, "frozen_copy_of", comno.frozen_copy_of, names, "ComNo")
            yield from unknown_name(comno, "word", comno.word, words, "word")
            if comno.name == self.link.command and comno.word is None:
                yield Diagnostic(
                    "FB1105",
                    f"the command ComNo '{comno.name}' has no bit table",
                    comno.span,
                    "add word: with the name of a word",
                )

    def _problems_of_words(self, names: set[str]) -> Iterable[Diagnostic]:
        bits = {f"{word.name}.{field.name}" for word in self.words for field in word.bits}
        functions = {item.name for item in self.terminal_functions}
        for word in self.words:
            for name in word.overridden_by:
                yield from unknown_name(word, "overridden_by", name, functions, "terminal function")
            if word.needs is not None:
                yield from unknown_name(word, "needs", _whole(word, word.needs), bits, "bit")
            for field in word.bits:
                for name in field.ored_with:
                    yield from unknown_name(field, "ored_with", _whole(word, name), bits, "bit")
                for comnos in field.parameters.values():
                    for name in comnos:
                        yield from unknown_name(field, "parameters", name, names, "ComNo")

    def _problems_of_port(self, port: SerialPort) -> Iterable[Diagnostic]:
        """FB1113: a value of F800 or F801 that does not say what it means."""
        by_name = {comno.name: comno for comno in self.comnos}
        for name, meaning, example in (
            (port.baud_rate, baud_rate_of, "4: 19200 bit/s"),
            (port.parity, parity_of, "1: even"),
        ):
            comno = by_name.get(name)
            if comno is None:
                continue
            codes = range(comno.minimum_word, comno.maximum_word + 1)
            wrong = [
                str(code)
                for code in {*comno.values, *(codes if len(codes) <= _MOST_CODES else ())}
                if code not in codes or meaning(comno.values.get(code, "")) is None
            ]
            if wrong:
                yield Diagnostic(
                    "FB1113",
                    f"{comno.hex} '{name}' does not say what {', '.join(sorted(wrong))} means",
                    comno.span_of("values"),
                    f"give each value from minimum to maximum its meaning, such as {example}",
                )


_MOST_CODES = 16


def _whole(word: Word, name: str) -> str:
    """`word.bit` of a bit that may be named without its word."""
    return name if "." in name else f"{word.name}.{name}"
