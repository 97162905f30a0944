"""The fields of a frame as `fbgen encode` takes them: name=value, each with its own check."""

from collections.abc import Mapping, Sequence

from fbgen.catalog import ComNo, parse_word
from fbgen.cli.frames.cell_texts import CellTexts
from fbgen.diagnostics import Diagnostic, DiagnosticError
from fbgen.nearest import nearest


class Fields:
    """Fields by name. What is wrong with them is collected and raised by `close`, all together.

    FB9042: a field that is missing, unknown, given twice or no field at all. FB9043: a value that
    cannot be read or does not fit. A value that is wrong reads as 0, so that the work can go on.
    """

    def __init__(self, arguments: Sequence[str], cells: CellTexts) -> None:
        self._cells = cells
        self._found: list[Diagnostic] = []
        self._given: dict[str, str] = {}
        self._asked: set[str] = set()
        for argument in arguments:
            name, equals, value = argument.partition("=")
            if not equals or not value:
                self._field(f"'{argument}' says no value", "write name=value")
            elif name in self._given:
                self._field(f"'{name}' is given twice", "give it once")
            else:
                self._given[name] = value

    def has(self, name: str) -> bool:
        """True if a field is given."""
        self._asked.add(name)
        return name in self._given

    def text(self, name: str, default: str | None = None) -> str:
        """The value as it is written. Without a default it has to be there."""
        if self.has(name):
            return self._given[name]
        if default is None:
            self._field(f"'{name}' is missing", f"add {name}=...")
        return default or ""

    def choice(self, name: str, choices: Mapping[str, object], default: str | None = None) -> str:
        """One of some texts; upper and lower case are the same if only one of them is there."""
        text = self.text(name, default)
        for spelled in (text, text.upper(), text.lower()):
            if spelled in choices:
                return spelled
        if text:
            self.wrong(name, "is none of these", f"use {', '.join(choices)}")
        return next(iter(choices))

    def number(self, name: str, values: range, default: int | None = None) -> int:
        """A decimal number, or one with 0x or 0b."""
        text = self.text(name, None if default is None else str(default))
        return self._number(name, text, values) if text else values.start

    def flag(self, name: str, default: str) -> bool:
        """Yes or no."""
        return self.choice(name, {"yes": True, "no": False}, default) == "yes"

    def com_no(self, name: str = "com_no") -> int:
        """A ComNo by its number, or by its name in the series."""
        text = self.text(name)
        drive = self._cells.drive
        known = None if drive is None else next((c for c in drive.comnos if c.name == text), None)
        if known is not None:
            return known.number
        digits = text.upper().removeprefix("0X").removeprefix("16#")
        if text and (len(digits) > 4 or not set(digits) <= set("0123456789ABCDEF")):
            if drive is None:
                help_ = "write four hexadecimal digits, or name the series with --series"
            else:
                help_ = nearest(text, [item.name for item in drive.comnos])
            self.wrong(name, "is no ComNo", help_)
            return 0
        return int(digits, 16) if digits else 0

    def word(self, name: str, com_no: int) -> int:
        """A word as it stands in the frame (`name`), or as `value` in the unit of the series."""
        if not self.has("value"):
            return self._word(name, self.text(name))
        if self.has(name):
            self._field(f"'{name}' and 'value' are given", "give one of them")
        known = self._cells.comno(com_no)
        if known is None:
            self.wrong("value", "has no unit without a known ComNo", f"write {name}=, a word")
            return 0
        return self._physical(known, self._given["value"])

    def words(self, name: str, most: int, least: int = 1) -> tuple[int, ...]:
        """Words with commas between them."""
        text = self.text(name, None if least else "")
        found = tuple(self._word(name, part) for part in text.split(",")) if text else ()
        if text and not least <= len(found) <= most:
            self.wrong(name, f"has {len(found)} words", f"give {least} to {most}")
        return found

    def wrong(self, name: str, what: str, help_: str) -> None:
        """FB9043: a value that cannot be."""
        text = self._given.get(name, "")
        self._found.append(Diagnostic("FB9043", f"'{text}' of '{name}' {what}", help=help_))

    def close(self) -> None:
        """Raises DiagnosticError with everything that was wrong, unknown fields included."""
        for name in self._given:
            if name not in self._asked:
                self._field(f"this frame has no '{name}'", nearest(name, self._asked))
        if self._found:
            raise DiagnosticError(self._found)

    def _field(self, message: str, help_: str) -> None:
        self._found.append(Diagnostic("FB9042", message, help=help_))

    def _number(self, name: str, text: str, values: range) -> int:
        try:
            number = int(text, 0)
        except ValueError:
            number = values.start - 1
        if number in values:
            return number
        self.wrong(name, "does not fit", f"use {values.start} to {values.stop - 1}")
        return values.start

    def _word(self, name: str, text: str) -> int:
        try:
            return parse_word(text) if text else 0
        except DiagnosticError as problem:
            self.wrong(name, "is no word", problem.diagnostics[0].help)
            return 0

    def _physical(self, known: ComNo, text: str) -> int:
        try:
            word = known.to_word(float(text))
        except (ValueError, OverflowError):
            word = -1
        if 0 <= word <= 0xFFFF:
            return word
        limit = f"{known.to_value(0xFFFF):g} {known.unit}".rstrip()
        self.wrong("value", f"is no value of {known.hex} {known.name}", f"use 0 to {limit}")
        return 0
