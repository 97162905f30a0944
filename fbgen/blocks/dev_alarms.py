"""The alarms of a DeviceNet network and of its drives, as those of a line in `alarms`."""

from dataclasses import replace

from fbgen.blocks.alarms import DRIVE_EMERGENCY_STOP, INHIBITED, INTERLOCK, Alarm
from fbgen.blocks.pbdp_alarms import NOT_RUNNING, NOT_STOPPED, TRIPPED

NETWORK_ALARMS = (
    Alarm(
        0,
        "network_lost",
        "NOT #line.online",
        "Errors",
        "Scanner finds no drive of the network",
        "Scanner findet keinen Antrieb des Netzes",
        "Check the scanner, the 24 V of the network, its two ends and the rate of all nodes.",
        "Scanner, 24 V des Netzes, seine beiden Enden und die Geschwindigkeit aller Teilnehmer "
        "prüfen.",
    ),
    Alarm(
        3,
        "emergency_stop",
        "#line.emergencyStop",
        "Warnings",
        "Emergency stop of the network is on",
        "Nothalt des Netzes steht an",
        "No drive of this network runs until it is taken back; those that trip by it need a reset.",
        "Kein Antrieb dieses Netzes läuft, bis er weggenommen ist; wer dabei abschaltet, braucht "
        "eine Quittierung.",
    ),
    NOT_STOPPED,
)
"""The alarms of typeDevLine.alarms; a cause that a gateway has too has the same bit."""

DEV_DRIVE_ALARMS = (
    TRIPPED,
    Alarm(
        1,
        "lost",
        "NOT #drive.state.online AND NOT #drive.state.resetting",
        "Errors",
        "Scanner does not exchange data with the drive",
        "Scanner tauscht mit dem Antrieb keine Daten aus",
        "Check its supply, its plug, its MAC ID, its rate and its assemblies (c203). Until then it "
        "does what c101 says.",
        "Versorgung, Stecker, MAC-ID, Geschwindigkeit und Assemblies (c203) prüfen. Bis dahin tut "
        "er, was c101 sagt.",
    ),
    NOT_RUNNING,
    replace(
        DRIVE_EMERGENCY_STOP,
        english_help="By a command word (100, 102, 105) it trips with E and needs a reset "
        "afterwards; by the other assemblies it stops along its ramp.",
        german_help="Mit Steuerwort (100, 102, 105) schaltet er mit E ab und braucht danach eine "
        "Quittierung; mit den anderen Assemblies hält er an der Rampe an.",
    ),
    INHIBITED,
    INTERLOCK,
    Alarm(
        6,
        "warning",
        "#drive.state.warning",
        "Warnings",
        "Drive warns",
        "Antrieb warnt",
        "Its panel shows the alarm, FC91 has it as a word.",
        "Die Anzeige zeigt den Alarm, FC91 hat ihn als Wort.",
    ),
)
"""The alarms of typeDevDrive.alarms; a cause that another drive has too has the same bit."""
