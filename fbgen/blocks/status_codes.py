"""What the blocks report in `status`, with the likely cause and what to do: the one list of it.

README of a plant and the pages of blocks are made of it. What a block sets stands in its template;
a test holds both against each other.
"""

from collections.abc import Collection
from typing import Literal

from fbgen.dataclass import dataclass

Having = Literal["lines", "channels", "sequences", "parameters", "serial", "devicenet"]
"""What a plant must have for a code: gateways for telegrams or process data, sequences, a parameter
channel, serial lines, DeviceNet networks."""


@dataclass(frozen=True, slots=True)
class StatusCodes:
    """Codes that belong together. Meanings in English and German, `remedy` in English.

    `having` empty: every plant has them; else those that have one of these.
    """

    codes: tuple[int, ...]
    english: str
    german: str
    remedy: str
    having: tuple[Having, ...] = ()

    @property
    def text(self) -> str:
        """`8409, 840A`, as they are printed."""
        return ", ".join(f"{code:04X}" for code in self.codes)

    def meaning(self, language: str) -> str:
        """What it says."""
        return self.german if language == "de" else self.english

    def can_come(self, found: Collection[str]) -> bool:
        """Whether a plant with all of `found` can have it."""
        return not self.having or not set(self.having).isdisjoint(found)


STATUS_CODES = (
    StatusCodes((0x0000,), "done", "fertig", ""),
    StatusCodes(
        (0x7000, 0x7001, 0x7002),
        "no job, started, waiting",
        "kein Auftrag, gestartet, wartet",
        "",
    ),
    StatusCodes(
        (0x8201,),
        "inverter number or command not allowed",
        "Umrichternummer oder Befehl nicht erlaubt",
        "Inverter numbers are 00 to 3F, FF is a broadcast. See which value the caller gives.",
        ("lines", "serial"),
    ),
    StatusCodes(
        (0x8201,),
        "mode not allowed",
        "Modus nicht erlaubt",
        "Modes are 1 read, 2 write to the RAM, 3 write to the EEPROM; 3 only with eeprom: true of "
        "the gateway in the plant file.",
        ("channels",),
    ),
    StatusCodes(
        (0x8201,),
        "mode or number not allowed, or the drive's assemblies have no parameter channel",
        "Modus oder Nummer nicht erlaubt, oder die Assemblies des Antriebs haben keinen "
        "Parameterkanal",
        "Modes are 1 read, 2 write. 101/151 reach numbers up to 7FFF and those that begin with F; "
        "105/155 reach all.",
        ("devicenet",),
    ),
    StatusCodes(
        (0x8401,),
        "no reply",
        "keine Antwort",
        "Is the drive supplied, its number and baud rate as in the plant file, the line wired and "
        "terminated? Is the limit longer than the drive takes?",
    ),
    StatusCodes(
        (0x8402,),
        "no reply, and the gateway counted faulty telegrams: a broken line, or the drive refused",
        "keine Antwort, und das Gateway zählte fehlerhafte Telegramme: Leitung gestört oder vom "
        "Antrieb abgelehnt",
        "Check the line, its ends and its shield. If other telegrams to the same drive pass, the "
        "drive has refused this one: see whether it has the ComNo, allows the value, and whether "
        "it must stand for it.",
        ("lines",),
    ),
    StatusCodes(
        (0x8402,),
        "on a serial line: what came was damaged, or the line did not fall silent",
        "auf einer seriellen Linie: was kam, war beschädigt, oder die Linie wurde nicht still",
        "Check the line, its ends and its shield, and whether rate and parity of module and drive "
        "agree; look for something on the line that sends unasked.",
        ("serial",),
    ),
    StatusCodes(
        (0x8403,),
        "another reply came",
        "eine andere Antwort kam",
        "Two drives may have the same number, or a second program may write to the same outputs.",
    ),
    StatusCodes(
        (0x8404,),
        "no gateway",
        "kein Gateway",
        "Check its supply, the PROFIBUS plug, its address, and whether the PLC has it configured.",
        ("lines", "channels"),
    ),
    StatusCodes(
        (0x8404,),
        "no communication module",
        "kein Kommunikationsmodul",
        "line.portStatus has what the module reported: compare its place with the plant file.",
        ("serial",),
    ),
    StatusCodes(
        (0x8404,),
        "no data exchange with the drive",
        "kein Datenaustausch mit dem Antrieb",
        "Check the supply of the drive and of the network, the plug, MAC ID, rate, c203 and the "
        "scan list of the scanner.",
        ("devicenet",),
    ),
    StatusCodes(
        (0x8405,),
        "ended by abort",
        "durch abort beendet",
        "The caller gave the job up; give it again when it is wanted.",
    ),
    StatusCodes(
        (0x8406,),
        "refused: an emergency stop is on",
        "abgelehnt: Nothalt steht an",
        "Take the emergency stop back, then give the job again.",
        ("lines", "serial"),
    ),
    StatusCodes(
        (0x8407,),
        "a sequence has waited for its condition too long",
        "ein Ablauf hat zu lange auf seine Bedingung gewartet",
        "failedStep says which step waited. See why the drive does not get there, or allow more "
        "time in the sequence.",
        ("sequences",),
    ),
    StatusCodes(
        (0x8408,),
        "a sequence was aborted",
        "ein Ablauf wurde abgebrochen",
        "What was sent before stays in force: a drive that was started runs on. Stop it then.",
        ("sequences",),
    ),
    StatusCodes(
        (0x8409, 0x840A),
        "a drive has not started, or stands although told to run",
        "ein Antrieb ist nicht angelaufen, oder steht, obwohl er laufen soll",
        "Look at its panel: a trip, a missing terminal, the set-point below its start frequency. "
        "startTimeout may be shorter than it needs.",
        ("channels", "devicenet"),
    ),
    StatusCodes(
        (0x840B,),
        "zeros have reached the gateway while a drive was told to run: the master was in CLEAR",
        "Nullen haben das Gateway erreicht, während ein Antrieb laufen sollte: Der Master war in "
        "CLEAR",
        "Find out why the master was in CLEAR, then take run back and give it again.",
        ("channels",),
    ),
    StatusCodes(
        (0x840C,),
        "the DeviceNet option: not written, or not read",
        "die DeviceNet-Option: nicht geschrieben oder nicht gelesen",
        "Compare number and value with the series' list of communication numbers; some can be "
        "written at standstill only. errorCode is what the option gave with it; no document at "
        "hand says what it means.",
        ("devicenet",),
    ),
    StatusCodes(
        (0x840D,),
        "the assemblies of the drive know no reverse, no jog or no preset speed; or poles is below "
        "2",
        "die Assemblies des Antriebs kennen keinen Rückwärtslauf, kein Tippen oder keine "
        "Festfrequenz; oder poles ist unter 2",
        "Take it back. 20/70 run forward only; jog and preset speeds need a command word: 100/150, "
        "102/152 or 105/155. Speeds in 1/min need the poles of the motor.",
        ("devicenet",),
    ),
    StatusCodes(
        (0x8410, 0x8411, 0x8412, 0x8413, 0x8414),
        "the drive on a serial line: cannot be executed now, data outside the range, no such "
        "ComNo, no such command, checksum wrong",
        "der Antrieb an einer seriellen Linie: jetzt nicht ausführbar, Wert außerhalb, keine "
        "solche ComNo, kein solcher Befehl, Prüfsumme falsch",
        "Compare number and value with the series' list of communication numbers; some can be "
        "written at standstill only. After a wrong checksum look at the line.",
        ("serial",),
    ),
    StatusCodes(
        (0x8421, 0x8422, 0x8423, 0x8424),
        "the drive by MODBUS: no such function, no such ComNo, data outside the range, cannot be "
        "executed",
        "der Antrieb über MODBUS: keine solche Funktion, keine solche ComNo, Wert außerhalb, nicht "
        "ausführbar",
        "Compare number and value with the series' list of communication numbers; some can be "
        "written at standstill only.",
        ("serial",),
    ),
    StatusCodes(
        (0x8500, 0x8501, 0x8502),
        "the gateway: cannot execute, value outside its range, no such parameter",
        "das Gateway: nicht ausführbar, Wert außerhalb, kein solcher Parameter",
        "Compare number and value with the series' list of communication numbers; some can be "
        "written at standstill only.",
        ("parameters",),
    ),
    StatusCodes(
        (0x8564, 0x8565, 0x8566),
        "the gateway: parameter is read-only, is write-only, other error",
        "das Gateway: Parameter nur lesbar, nur schreibbar, anderer Fehler",
        "See the access of the number in the series' list.",
        ("parameters",),
    ),
)


def status_rows(language: str, found: Collection[str]) -> list[dict[str, str]]:
    """The rows of a table for a plant: what one code means in two ways is one row."""
    rows: dict[str, list[str]] = {}
    for item in STATUS_CODES:
        if item.can_come(found):
            rows.setdefault(item.text, []).append(item.meaning(language))
    return [{"codes": codes, "meaning": "; ".join(texts)} for codes, texts in rows.items()]


def status_codes(code: int) -> tuple[StatusCodes, ...]:
    """What the list says about a code."""
    return tuple(item for item in STATUS_CODES if code in item.codes)
