"""What README.md says about the wires of serial lines, and what is set at their drives.

Sources: TOSPBDP001 manual v1.1, 5 (RXA and TXA are the positive wires, resistors, sockets of VF-A7
and VF-P7); TIA Portal Information System, "RS422 mode", "RS485 mode", "Interface operating modes",
"Initial state of receive line" (names and pins of a CM PtP, modes, default of a CP); S7-1200 System
Manual A5E02486680, 13.3.4 (bias, wire break). Recalled, and said to be so: the pins of the others.
"""

from collections.abc import Iterator

from fbgen.artefacts.view import PlantLists
from fbgen.blocks.drive_settings import drive_settings
from fbgen.catalog import ComNo, Setting
from fbgen.plant import SerialLine, module_of

_PINS = {
    4: {
        "cm_ptp": "T(A) 2, T(B) 9, R(A) 4, R(B) 11, GND 8",
        "cm_1241": "T(B) 2, T(A) 9, R(B) 3, R(A) 8, GND 5",
    },
    2: {
        "cm_ptp": "R(A)/T(A) 4, R(B)/T(B) 11, GND 8",
        "cm_1241": "R(B)/T(B) 3, R(A)/T(A) 8, GND 5",
    },
}
_AS_CM_PTP = ("cp_340", "cp_341", "cp_440")
_KNOWN = "cm_ptp"
_SEVEN = ("vf-a7", "vf-p7")
_PAIRS = {
    4: (
        "T(B) to RXA and T(A) to RXB of all drives, R(B) to TXA and R(A) to TXB of all drives",
        "T(B) an RXA und T(A) an RXB aller Antriebe, R(B) an TXA und R(A) an TXB aller Antriebe",
    ),
    2: (
        "R(B)/T(B) to A and R(A)/T(A) to B of all drives",
        "R(B)/T(B) an A und R(A)/T(A) an B aller Antriebe",
    ),
}


def wiring(lists: PlantLists) -> Iterator[str]:
    """A paragraph for each kind of module and number of wires, and what is the same for all."""
    plant = lists.plant
    if not plant.serial:
        return
    yield lists.in_words(
        "**Wires**: one cable from drive to drive, no star; its screen on earth, never on GND; "
        "signal ground (SG) of the drives to GND of the module; what else is on the socket of a "
        "drive (P24, P5, P11) to nothing at all. **Toshiba calls the positive wire of a pair A, "
        "Siemens B.** Terminate each pair at its far ends, with 100 to 120 Ohm, and only where it "
        "has bias (initial state of the receive line at the module, or 500 to 700 Ohm); for one "
        "or two drives and less than 2 m, both may be left out.",
        "**Leitungen**: ein Kabel von Antrieb zu Antrieb, kein Stern; sein Schirm an Erde, nie an "
        "GND; Signalmasse (SG) der Antriebe an GND des Moduls; was sonst an der Buchse eines "
        "Antriebs liegt (P24, P5, P11), an nichts. **Toshiba nennt die positive Ader eines Paars "
        "A, Siemens B.** Jedes Paar an seinen Enden mit 100 bis 120 Ohm abschließen, aber nur, wo "
        "es Bias hat (Vorbelegung der Empfangsleitung am Modul oder 500 bis 700 Ohm); bei einem "
        "oder zwei Antrieben und weniger als 2 m darf beides fehlen.",
    )
    for module, wires in sorted(
        {(module_of(line, plant.plc), line.wires) for line in plant.serial}
    ):
        if module != "adapter":
            yield f"{lists.in_words(*_PAIRS[wires])}. {_pins(lists, module, wires)}"
    if any(drive.series in _SEVEN for line in plant.serial for drive in line.drives):
        yield lists.in_words(
            "RJ-45 of a VF-A7 and VF-P7, as the drive names its signals: RXA 4, RXB 5, TXA 3, TXB "
            "6, SG 2 and 8; P24 on 1 and P5 on 7 stay free.",
            "RJ-45 von VF-A7 und VF-P7, wie der Antrieb seine Signale nennt: RXA 4, RXB 5, TXA 3, "
            "TXB 6, SG 2 und 8; P24 an 1 und P5 an 7 bleiben frei.",
        )


def _pins(lists: PlantLists, module: str, wires: int) -> str:
    of = _KNOWN if module in _AS_CM_PTP else module
    text = lists.in_words(f"Pins: {_PINS[wires][of]}", f"Stifte: {_PINS[wires][of]}")
    if module == _KNOWN:
        return f"{text} (D-Sub 15)."
    doubt = lists.in_words(
        "from memory, look it up in the manual of the module",
        "aus dem Gedächtnis, im Handbuch des Moduls nachsehen",
    )
    return f"{text} ({'D-Sub 15' if module in _AS_CM_PTP else 'D-Sub 9'}; {doubt})."


def settings_of_drives(lists: PlantLists) -> Iterator[str]:
    """One sentence for each series on each line: what is set at its inverters."""
    plant, catalog = lists.plant, lists.catalog
    for line in plant.serial:
        for name in dict.fromkeys(drive.series for drive in line.drives):
            series = catalog.drive(name)
            known = drive_settings(plant, line, series, catalog, lists.in_words)
            said = ", ".join(
                _said(lists, series.comno(one.comno), one) for one in known if one.always
            )
            who = lists.in_words(f"Each {name} on `{line.name}`", f"Jeder {name} an `{line.name}`")
            then = lists.in_words(
                "switch it off until the display is dark, and on again",
                "danach ausschalten, bis die Anzeige dunkel ist, und wieder ein",
            )
            yield f"{who}: {said}; {then}."


def _said(lists: PlantLists, comno: ComNo, setting: Setting) -> str:
    name = comno.display or comno.hex
    if setting.plant == "inv_no":
        return lists.in_words(f"{name} = its inverter number", f"{name} = seine Umrichternummer")
    if setting.plant == "max_frequency_hz":
        return lists.in_words(f"{name} = its highest frequency", f"{name} = seine höchste Frequenz")
    value = setting.value or 0.0
    meaning = lists.texts(comno.values.get(comno.to_word(value), "")) or comno.unit
    return f"{name} = {value:g} ({meaning})"


def in_milliseconds(lists: PlantLists, line: SerialLine, bits: int) -> str:
    """A time in bit times as a CP takes it: whole milliseconds, not shorter."""
    whole = -(-bits * 1000 // line.baud)
    return lists.in_words(f"{whole} ms at `{line.name}`", f"{whole} ms an `{line.name}`")
