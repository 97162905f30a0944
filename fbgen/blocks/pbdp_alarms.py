"""The alarms of a gateway for process data and of its drives, as those of a line in `alarms`."""

from fbgen.blocks.alarms import DRIVE_EMERGENCY_STOP, INHIBITED, INTERLOCK, IO_ERROR, Alarm

NOT_STOPPED = Alarm(
    4,
    "not_stopped",
    "#line.emergencyStop AND NOT #line.stopped",
    "Errors",
    "Emergency stop: not every drive is known to stand",
    "Nothalt: nicht von jedem Antrieb ist bekannt, dass er steht",
    "A drive that still runs or is offline: switch it off.",
    "Ein Antrieb läuft noch oder ist nicht erreichbar: abschalten.",
)

GATEWAY_ALARMS = (
    Alarm(
        0,
        "gateway_lost",
        "NOT #line.online",
        "Errors",
        "Gateway and its drives do not take part",
        "Gateway und seine Antriebe nehmen nicht teil",
        "Check the drive at channel A (it supplies the gateway), the PROFIBUS plug and the address "
        "switches.",
        "Antrieb an Kanal A (er versorgt das Gateway), PROFIBUS-Stecker und Adressschalter prüfen.",
    ),
    IO_ERROR,
    Alarm(
        3,
        "emergency_stop",
        "#line.emergencyStop",
        "Warnings",
        "Emergency stop of the gateway is on",
        "Nothalt des Gateways steht an",
        "No drive of this gateway runs until it is taken back and the drives are reset.",
        "Kein Antrieb dieses Gateways läuft, bis er weggenommen und jeder Antrieb quittiert ist.",
    ),
    NOT_STOPPED,
)
"""The alarms of typePbdpLine.alarms; a cause that a line has too has the same bit."""

TRIPPED = Alarm(
    0,
    "tripped",
    "#drive.state.tripped",
    "Errors",
    "Drive has tripped",
    "Antrieb hat abgeschaltet",
    "state.trip has the trip in words. Remove the cause, then reset it.",
    "state.trip zeigt die Störung in Worten. Ursache beseitigen, dann quittieren.",
    shows_trip=True,
)
NOT_RUNNING = Alarm(
    2,
    "not_running",
    "#drive.state.error",
    "Errors",
    "Drive does not run although it is told to",
    "Antrieb läuft nicht, obwohl er soll",
    "state.status has the reason. Start it again by taking run back once.",
    "state.status zeigt den Grund. Zum Starten den Laufbefehl einmal wegnehmen.",
)

PBDP_DRIVE_ALARMS = (
    TRIPPED,
    Alarm(
        1,
        "lost",
        "NOT #drive.state.online AND NOT #drive.state.resetting",
        "Errors",
        "Gateway does not find the drive",
        "Gateway findet den Antrieb nicht",
        "Check its supply, the cable to its channel and the settings of its serial port.",
        "Versorgung, Kabel zum Kanal und Einstellungen der seriellen Schnittstelle prüfen.",
    ),
    NOT_RUNNING,
    DRIVE_EMERGENCY_STOP,
    INHIBITED,
    INTERLOCK,
    Alarm(
        7,
        "parameter_failed",
        "#drive.parameter.error",
        "Errors",
        "Reading or writing a parameter has failed",
        "Lesen oder Schreiben eines Parameters ist fehlgeschlagen",
        "parameter.status and parameter.errorCode say why.",
        "parameter.status und parameter.errorCode zeigen den Grund.",
    ),
)
"""The alarms of typePbdpDrive.alarms; a cause that the drive of a line has too has the same bit."""
