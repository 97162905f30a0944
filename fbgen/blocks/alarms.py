"""The alarms of a line and of its drives: which bit of which word, and what the operator reads.

One table for both sides: the block that packs the bits (TOS_Alarms) and the lists that name them
for an HMI come from it, so that a text can never belong to another bit.
"""

from collections.abc import Iterable, Sequence
from typing import Literal

from fbgen.blocks.literals import SclText, word
from fbgen.dataclass import dataclass
from fbgen.plant import DeviceNetNetwork, PlantUnit

AlarmClass = Literal["Errors", "Warnings"]
"""As WinCC calls the two classes that every project has: Errors want an acknowledgement."""


@dataclass(frozen=True, slots=True)
class Alarm:
    """One bit. `condition` is what raises it, in the block's own names.

    The texts are in English and German and name neither the line nor the drive: whoever writes a
    list puts that in front. `shows_trip` is for the alarm to which the trip in words belongs.
    `needs` says without what of its gateway it never comes: the status poll, or an access whose
    RET_VAL tells of errors.
    """

    bit: int
    name: str
    condition: str
    kind: AlarmClass
    english: str
    german: str
    english_help: str
    german_help: str
    shows_trip: bool = False
    needs: Literal["nothing", "status_poll", "dpxx_dat"] = "nothing"

    @property
    def mask(self) -> SclText:
        """The bit in its word."""
        return word(1 << self.bit)

    def can_come(self, unit: PlantUnit) -> bool:
        """Whether there is anything at this gateway, line or network that raises it."""
        if isinstance(unit, DeviceNetNetwork):
            return self.needs == "nothing"
        if self.needs == "status_poll":
            return unit.status_poll
        return self.needs == "nothing" or self.needs == getattr(unit, "access", "")

    def text(self, language: str) -> str:
        """What the operator reads."""
        return self.german if language == "de" else self.english

    def help(self, language: str) -> str:
        """What can be done about it."""
        return self.german_help if language == "de" else self.english_help


IO_ERROR = Alarm(
    1,
    "io_error",
    "#line.ioError",
    "Errors",
    "Cyclic data cannot be exchanged",
    "Zyklische Daten werden nicht ausgetauscht",
    "ioRetVal has what the access reported. Compare the addresses and the module in the "
    "hardware configuration with the plant file.",
    "ioRetVal zeigt, was der Zugriff gemeldet hat. Adressen und Modul der "
    "Hardwarekonfiguration mit der Anlagendatei vergleichen.",
    needs="dpxx_dat",
)
_IS_TO_RUN = (
    "(#drive.control.jog OR #drive.control.manual AND #drive.control.manualRun "
    "OR NOT #drive.control.manual AND #drive.control.run)"
)
"""What TOS_Drive and PBDP_Drive take for a command to run."""

DRIVE_EMERGENCY_STOP = Alarm(
    3,
    "emergency_stop",
    "#drive.control.emergencyStop",
    "Warnings",
    "Emergency stop of the drive is on",
    "Nothalt des Antriebs steht an",
    "It trips with E and needs a reset afterwards.",
    "Er schaltet mit E ab und braucht danach eine Quittierung.",
)
INHIBITED = Alarm(
    4,
    "inhibited",
    f"#drive.control.enable AND #drive.state.inhibited AND {_IS_TO_RUN}",
    "Warnings",
    "Drive waits until the run command was taken back once",
    "Antrieb wartet, bis der Laufbefehl einmal weggenommen war",
    "So it never starts by itself after a start of the PLC, a loss, a trip, an emergency stop, a "
    "missing interlock, coast, DC brake or a change of manual.",
    "So läuft er nach Neustart der Steuerung, Ausfall, Störung, Nothalt, fehlender Verriegelung, "
    "coast, dcBrake oder einem Wechsel von manual nie von selbst an.",
)
INTERLOCK = Alarm(
    5,
    "interlock",
    f"#drive.control.enable AND NOT #drive.control.interlock AND {_IS_TO_RUN}",
    "Warnings",
    "Drive is to run and its interlock is missing",
    "Antrieb soll laufen, die Verriegelung fehlt",
    "control.interlock is FALSE.",
    "control.interlock ist FALSE.",
)

LINE_EMERGENCY_STOP = Alarm(
    3,
    "emergency_stop",
    "#line.emergencyStop",
    "Warnings",
    "Emergency stop of the line is on",
    "Nothalt der Linie steht an",
    "No drive of this line takes a command until it is taken back.",
    "Kein Antrieb dieser Linie nimmt einen Befehl an, bis er weggenommen ist.",
)
NOT_STOPPED = Alarm(
    4,
    "not_stopped",
    "#line.emergencyStop AND NOT #line.stopping AND NOT #line.stopped",
    "Errors",
    "Emergency stop: not every drive has acknowledged it",
    "Nothalt: nicht jeder Antrieb hat ihn quittiert",
    "unreached has how many. Such a drive may still run: switch it off.",
    "unreached zeigt, wie viele. Ein solcher Antrieb kann noch laufen: abschalten.",
)

LINE_ALARMS = (
    Alarm(
        0,
        "gateway_lost",
        "NOT #line.online",
        "Errors",
        "Gateway does not take part",
        "Gateway nimmt nicht teil",
        "Check its 24 V supply, PROFIBUS plug and address switches. Its drives keep running until "
        "their own time-out (F803) trips them.",
        "24-V-Versorgung, PROFIBUS-Stecker und Adressschalter prüfen. Die Antriebe laufen weiter, "
        "bis ihre eigene Zeitüberwachung (F803) auslöst.",
    ),
    IO_ERROR,
    Alarm(
        2,
        "telegram_errors",
        "#line.gatewayFault",
        "Errors",
        "Gateway reports faulty telegrams",
        "Gateway meldet fehlerhafte Telegramme",
        "errorCount counts them. Check the RS-485 line: wires, termination, shield, F800 and F801 "
        "of the drives; a refused write counts as well.",
        "errorCount zählt sie. RS-485-Leitung prüfen: Adern, Abschluss, Schirm, F800 und F801 "
        "der Antriebe; auch ein abgelehnter Schreibauftrag zählt.",
    ),
    LINE_EMERGENCY_STOP,
    NOT_STOPPED,
)
"""The alarms of typeTosLine.alarms."""

_DRIVE_ALARMS = (
    Alarm(
        0,
        "tripped",
        "#drive.polled.tripped",
        "Errors",
        "Drive has tripped",
        "Antrieb hat abgeschaltet",
        "state.trip has the trip in words. Remove the cause, then reset it.",
        "state.trip zeigt die Störung in Worten. Ursache beseitigen, dann quittieren.",
        shows_trip=True,
        needs="status_poll",
    ),
    Alarm(
        1,
        "lost",
        "#drive.polled.lost",
        "Errors",
        "Drive does not answer",
        "Antrieb antwortet nicht",
        "Check its supply, its inverter number (F802) and the line.",
        "Versorgung, Umrichternummer (F802) und Leitung prüfen.",
        needs="status_poll",
    ),
    Alarm(
        2,
        "not_acknowledged",
        "#drive.state.error",
        "Errors",
        "Last command was not acknowledged",
        "Letzter Befehl wurde nicht quittiert",
        "state.status has the reason. Start it again by taking run back once.",
        "state.status zeigt den Grund. Zum Starten den Laufbefehl einmal wegnehmen.",
    ),
    DRIVE_EMERGENCY_STOP,
    INHIBITED,
    INTERLOCK,
)

SEQUENCE_FAILED = 6
"""The bit of typeTosDrive.alarms that says that a sequence of the drive has failed."""


def drive_alarms(sequences: Sequence[str]) -> tuple[Alarm, ...]:
    """The alarms of typeTosDrive.alarms, with these sequences."""
    if not sequences:
        return _DRIVE_ALARMS
    failed = " OR ".join(f"#drive.{name}.error" for name in sequences)
    sequence = Alarm(
        SEQUENCE_FAILED,
        "sequence_failed",
        failed,
        "Errors",
        "A sequence has ended with an error",
        "Ein Ablauf hat mit Fehler geendet",
        "failedStep and status of the sequence say where and why.",
        "failedStep und status des Ablaufs zeigen, wo und warum.",
    )
    return (*_DRIVE_ALARMS, sequence)


def that_can_come(alarms: Iterable[Alarm], units: Sequence[PlantUnit]) -> tuple[Alarm, ...]:
    """The alarms that at least one of these gateways, lines or networks can raise."""
    return tuple(one for one in alarms if any(one.can_come(unit) for unit in units))
