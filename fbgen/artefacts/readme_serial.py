"""What README.md says about serial lines: modules and what is set at them, times."""

from collections.abc import Iterator, Mapping

from fbgen.artefacts.readme_wiring import in_milliseconds
from fbgen.artefacts.view import PlantLists
from fbgen.blocks.serial_lines import instructions_of, port_kind
from fbgen.blocks.serial_times import READS_A_DRIVE, serial_times
from fbgen.plant import SerialLine, buffer_numbers, module_of, place_of

MODULE_TITLES = {
    "cm_ptp": "CM PtP RS422/485",
    "cm_1241": "CM 1241 RS422/485",
    "cp_340": "CP 340",
    "cp_341": "CP 341",
    "cp_440": "CP 440",
    "adapter": "adapter",
}
_DELAY_BITS = 44
_PROTOCOLS = {
    "toshiba_binary": ("Toshiba, binary", "Toshiba, binär"),
    "toshiba_ascii": ("Toshiba, ASCII", "Toshiba, ASCII"),
    "modbus": ("MODBUS-RTU", "MODBUS-RTU"),
}
_MODULES = {
    "freeport": (
        "Set the module to freeport. Start of a message: any character; end of a message: "
        "character delay time of 44 bit times, and nothing else; no flow control; {wires}. "
        "Initial state of the receive line: R(A) 0 V, R(B) 5 V, no wire break detection: while no "
        "drive replies, nobody drives that pair. A CM 1241 needs firmware V2.1 for Send_P2P and "
        "Receive_P2P. The character delay time is four characters; at 38400 bit/s and more set "
        "100 bit times, as the help of TIA Portal advises. `portStatus` 81xx: what came was "
        "damaged; 82xx, 8Fxx: the module does not answer.",
        "Das Modul auf Freeport stellen. Beginn einer Nachricht: beliebiges Zeichen; Ende: "
        "Zeichenverzugszeit von 44 Bitzeiten, sonst nichts; keine Flusskontrolle; {wires}. "
        "Vorbelegung der Empfangsleitung: R(A) 0 V, R(B) 5 V, keine Drahtbrucherkennung: Solange "
        "kein Antrieb antwortet, treibt niemand dieses Paar. Ein CM 1241 braucht für Send_P2P und "
        "Receive_P2P Firmware V2.1. Die Zeichenverzugszeit sind vier Zeichen; ab 38400 bit/s 100 "
        "Bitzeiten einstellen, wie es die Hilfe von TIA Portal rät. `portStatus` 81xx: Was kam, "
        "war beschädigt; 82xx, 8Fxx: Das Modul antwortet nicht.",
    ),
    "modbus_master": (
        "The program sets the module by Modbus_Comm_Load: rate, parity, {wires}; in the device "
        "configuration its protocol stays Freeport. Modbus_Master sends and receives. A CM PtP "
        "must be an HF, a CM 1241 needs firmware V2.1. For a module without MODBUS write "
        "`modbus_frames: own` into the plant file: then the blocks build the frames.",
        "Das Modul stellt das Programm mit Modbus_Comm_Load ein: Geschwindigkeit, Parität, "
        "{wires}; in der Gerätekonfiguration bleibt sein Protokoll Freeport. Modbus_Master sendet "
        "und empfängt. Ein CM PtP muss ein HF sein, ein CM 1241 braucht Firmware V2.1. Für ein "
        "Modul ohne MODBUS `modbus_frames: own` in die Anlagendatei schreiben: dann bauen die "
        "Bausteine die Telegramme.",
    ),
    "cp34x": (
        "Set the CP to the ASCII driver, end of a message: after the character delay time, of "
        "four characters ({delays}); no flow control; {wires}. Initial state of the receive line: "
        "R(A) 0 V, R(B) 5 V, not the default with break detection: while no drive replies, nobody "
        "drives that pair. {instructions} {library} {buffers} `portStatus` 08xx: what came was "
        "damaged (0810 parity); 1Exx: the CP does not answer.",
        "Den CP auf den ASCII-Treiber stellen, Ende einer Nachricht: nach der Zeichenverzugszeit "
        "von vier Zeichen ({delays}); keine Flusskontrolle; {wires}. Vorbelegung der "
        "Empfangsleitung: R(A) 0 V, R(B) 5 V, nicht die Voreinstellung mit Break-Erkennung: "
        "Solange kein Antrieb antwortet, treibt niemand dieses Paar. {instructions} {library} "
        "{buffers} `portStatus` 08xx: Was kam, war beschädigt (0810 Parität); 1Exx: Der CP "
        "antwortet nicht.",
    ),
    "adapter": (
        "Your own program sends and receives, by the serial library of the PLC: when `sendCount` "
        "of `{adapters}.LINE` changes, it sends `sendLength` bytes of `outBytes` and then sets "
        "`sentCount` to that number. Where the line was silent for four characters it puts what "
        "came, 32 bytes at most, into `inBytes`, its number into `receiveLength`, and counts "
        "`receiveCount` up; the next message only when `takenCount` has followed. With `damaged` "
        "a message has an error of parity or frame, with `failed` the port cannot be used.",
        "Ihr eigenes Programm sendet und empfängt mit der seriellen Bibliothek der Steuerung: "
        "Wenn sich `sendCount` von `{adapters}.LINIE` ändert, sendet es `sendLength` Byte von "
        "`outBytes` und setzt danach `sentCount` auf diese Zahl. Wo die Linie vier Zeichen lang "
        "still war, legt es, was kam, höchstens 32 Byte, in `inBytes`, die Anzahl in "
        "`receiveLength`, und zählt `receiveCount` weiter; die nächste Nachricht erst, wenn "
        "`takenCount` gefolgt ist. Mit `damaged` hat eine Nachricht einen Fehler der Parität oder "
        "des Rahmens, mit `failed` ist der Anschluss nicht zu gebrauchen.",
    ),
}
_TWO_WIRES = ("half duplex (RS485), two-wire", "Halbduplex (RS485), zwei Adern")
_FOUR_WIRES = {
    "cm_ptp": (
        "full duplex (RS422), four-wire, point-to-point (multipoint master is offered by the CM "
        "PtP of an ET 200SP alone; this module is the only one that sends on its pair)",
        "Vollduplex (RS422), vier Adern, Punkt-zu-Punkt (Mehrpunkt-Master bietet nur das CM PtP "
        "einer ET 200SP; auf seinem Paar sendet ja nur dieses Modul)",
    ),
    "cm_1241": (
        "full duplex (RS422), four-wire, point-to-point",
        "Vollduplex (RS422), vier Adern, Punkt-zu-Punkt",
    ),
    "cp_440": (
        "full duplex (RS422), four-wire, multipoint master",
        "Vollduplex (RS422), vier Adern, Mehrpunkt-Master",
    ),
}
_OTHER_FOUR_WIRES = ("full duplex (RS422), four-wire", "Vollduplex (RS422), vier Adern")


def serial_row(line: SerialLine, lists: PlantLists) -> dict[str, str]:
    """A line in the table of the hardware configuration."""
    plant = lists.plant
    number = place_of(line, plant)
    place = lists.in_words("bound by you", "von Ihnen gebunden")
    if number is not None:
        by_identifier = plant.family.hardware_identifiers
        place = f"{'HW-ID' if by_identifier else lists.in_words('address', 'Adresse')} {number}"
    return {
        "name": line.name,
        "module": MODULE_TITLES[module_of(line, plant.plc)],
        "place": place,
        "protocol": lists.in_words(*_PROTOCOLS[line.protocol]),
        "baud": str(line.baud),
        "parity": lists.texts(line.parity),
        "wires": str(line.wires),
    }


def serial_notes(lists: PlantLists) -> Iterator[str]:
    """What is set at the modules; once for each way of setting."""
    plant = lists.plant
    found = {
        (port_kind(plant, line), module_of(line, plant.plc), line.wires) for line in plant.serial
    }
    for kind, module, wires in sorted(found):
        delays = [
            in_milliseconds(lists, line, _DELAY_BITS)
            for line in plant.serial
            if (module_of(line, plant.plc), line.wires) == (module, wires)
        ]
        four = _FOUR_WIRES.get(module, _OTHER_FOUR_WIRES)
        yield lists.in_words(*_MODULES[kind]).format(
            wires=lists.in_words(*(four if wires == 4 else _TWO_WIRES)),
            delays=", ".join(delays),
            instructions=", ".join(instructions_of(module)),
            library=_library(lists),
            buffers=_buffers(lists),
            adapters=lists.name("TIP_Adapters"),
        )


def _library(lists: PlantLists) -> str:
    """Where the instructions of a CP are."""
    if lists.plant.dialect == "tia":
        return lists.in_words(
            "are instructions of the communication processor: if the import does not know them, "
            "call each once in a block of your own first, so that it is in the project.",
            "sind Anweisungen des Kommunikationsprozessors: Kennt der Import sie nicht, erst jede "
            "einmal in einem eigenen Baustein aufrufen, damit sie im Projekt ist.",
        )
    return lists.in_words("come from the library of the CP.", "stehen in der Bibliothek des CP.")


def _buffers(lists: PlantLists) -> str:
    """Which numbers the data blocks must have that the instructions take by number."""
    numbers = buffer_numbers(lists.plant)
    listed = ", ".join(f"`{lists.name(name)}` DB{number}" for name, number in numbers.items())
    text = lists.in_words(
        f"The instructions take data blocks by number: {listed}.",
        f"Die Anweisungen nehmen Datenbausteine nach Nummer: {listed}.",
    )
    if lists.plant.dialect != "tia":
        return text
    by_hand = lists.in_words(
        "**The import gives other numbers**: set these by hand, in the properties of the block.",
        "**Der Import vergibt andere Nummern**: diese von Hand einstellen, in den Eigenschaften "
        "des Bausteins.",
    )
    return f"{text} {by_hand}"


def serial_poll(line: SerialLine, lists: PlantLists) -> dict[str, object]:
    """One line in the table of the poll cycle."""
    times = serial_times(lists.plant, line, lists.catalog)
    return {
        "gateway": line.name,
        "drives": len(line.drives),
        "reads": READS_A_DRIVE * len(line.drives),
        "read_ms": f"{times.read_ms:g}",
        "round_ms": f"{times.round_ms:g}",
    }


def serial_worst(line: SerialLine, lists: PlantLists) -> Mapping[str, str]:
    """One line in the table of the worst cases."""
    times = serial_times(lists.plant, line, lists.catalog)
    return {
        "gateway": line.name,
        "telegram": f"{times.telegram_ms:.0f}",
        "wait": f"{times.wait_ms:.0f}",
        "emergency_stop": f"{times.emergency_stop_ms:.0f}",
    }
