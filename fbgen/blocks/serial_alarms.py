"""The alarms of a serial line; those of its drives are the ones of every line."""

from fbgen.blocks.alarms import LINE_EMERGENCY_STOP, NOT_STOPPED, Alarm

SERIAL_ALARMS = (
    Alarm(
        0,
        "port_lost",
        "NOT #line.online",
        "Errors",
        "Communication module does not take part",
        "Kommunikationsmodul nimmt nicht teil",
        "portStatus has what it reported. Compare port and module with the plant file.",
        "portStatus zeigt, was es gemeldet hat. Anschluss und Modul mit der Anlagendatei "
        "vergleichen.",
    ),
    LINE_EMERGENCY_STOP,
    NOT_STOPPED,
)
"""The alarms of typeTipLine.alarms."""
