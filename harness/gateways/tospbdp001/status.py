"""The status word of the TOSPBDP001: handshake bits, status code, counter of faulty telegrams.

Bit 15 is toggled for new status information and the PLC copies it to control bit 15; control bit 14
is copied to status bit 14 when a control command has been processed; bit 13 is 0; bits 12 to 8 are
the status code, 1F without error; the low byte counts faulty telegrams until the next valid one
(TOSPBDP001 manual v1.1, section 8 A; codes: HMS manual HMSI-27-314, printed page 105).
"""

from harness.gateways.tospbdp001.settings import ErrorCode, ErrorCounter, StatusToggle, TosSettings

NO_ERROR = 0x1F
INVALID_TELEGRAMS = 0x00
OFFLINE_TIMEOUT = 0x02
_CHANGED = 0x8000
_COMMAND_DONE = 0x4000
_HANDSHAKE = _CHANGED | _COMMAND_DONE
_TAKEN = 0x8000
_COMMAND_NEW = 0x4000


class StatusWord:
    """The word that the PLC reads, and the device's own view behind it.

    `word` is what is posted. `code` and `data` are up to date at any time, `data` counts.
    """

    __slots__ = ("_counted", "_news", "_settings", "_taken", "code", "data", "timeouts", "word")

    def __init__(self, settings: TosSettings, word: int | None = None) -> None:
        """With the word after power-on, or with another that it had already."""
        self._settings = settings
        self.word = settings.power_on_status if word is None else word
        self.code = self.word >> 8 & 0x1F
        self.data = self.word & 0xFF
        self.timeouts = 0
        self._counted = self.data
        self._taken = 0
        self._news = False

    @property
    def faulty(self) -> bool:
        """True from the first faulty telegram or timeout until the next valid telegram."""
        return self.code != NO_ERROR or self.data != 0

    def control(self, control: int) -> None:
        """A control word has been processed: take over bit 14, and see what the PLC has taken."""
        self._taken = control & _TAKEN
        self.word = self.word & ~_COMMAND_DONE | control & _COMMAND_NEW
        if self._news and self._is_taken:
            self._post()

    def valid_telegram(self) -> None:
        """A telegram as expected: all is well again."""
        if self.faulty:
            if self._settings.error_counter is ErrorCounter.RESTART:
                self._counted = self.timeouts = 0
            self._change(NO_ERROR, 0)

    def invalid_telegram(self) -> None:
        """A telegram that is no valid reply: counts, in 8 bits."""
        self._counted = self._counted + 1 & 0xFF
        unchanged = self._settings.error_code is ErrorCode.UNCHANGED
        self._change(NO_ERROR if unchanged else INVALID_TELEGRAMS, self._counted)

    def offline_timeout(self) -> None:
        """No valid telegram within the offline timeout: counts apart from faulty telegrams."""
        self.timeouts = self.timeouts + 1 & 0xFF
        self._change(OFFLINE_TIMEOUT, self.timeouts)

    def report(self, code: int) -> None:
        """Something that only the device knows of, told by its status code."""
        self._change(code, 0)

    @property
    def _is_taken(self) -> bool:
        return self.word & _CHANGED == self._taken

    def _change(self, code: int, data: int) -> None:
        self.code, self.data = code, data
        toggle = self._settings.status_toggle
        if toggle is StatusToggle.ALWAYS or self._is_taken:
            self._post()
            return
        self._news = True
        if toggle is StatusToggle.WHEN_TAKEN:
            self.word = self.word & _HANDSHAKE | self.code << 8 | self.data

    def _post(self) -> None:
        self._news = False
        self.word = (self.word ^ _CHANGED) & _HANDSHAKE | self.code << 8 | self.data
