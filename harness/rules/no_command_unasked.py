"""No run command goes out that nobody asks for in the PLC.

Who asks: `control` with enable and run, manualRun, jog or preset, or a sequence of the drive that
is executed. What was asked for up to 500 ms ago counts, as a telegram may have waited and been
repeated; a restart of the CPU ends it. Of a gateway for process data counts what the master sends
to it: what it does with the drives by itself is not the PLC's doing.
"""

from collections.abc import Callable, Iterator

from fbgen.catalog import Catalog
from fbgen.plant import layout_of
from fbgen.wire.toshiba import Command
from harness.drives.word_bits import CommandBits
from harness.fieldbus import Station, Transfer
from harness.installation import Installation
from harness.kernel import NS_PER_MS
from harness.line import Transmission
from harness.plc import CpuMode
from harness.rules.drive_variables import drive_reader
from harness.rules.rule import Rule, Watch

_REMEMBERED_NS = 500 * NS_PER_MS
_CONTROL = ("enable", "run", "manualRun", "jog", "preset")
_WRITES = (Command.P, Command.W)
_FRAME_BYTES = 8


def _watch(plant: Installation) -> Watch:
    found: list[str] = []
    asked: dict[str, int] = {}
    variables = [f"control.{name}" for name in _CONTROL]
    read_interfaces = drive_reader(plant, plant.interface_entries, variables)
    for name in _sequences(plant, plant.catalog):
        variables += [f"{name}.execute", f"{name}.busy"]
    read_lines = drive_reader(plant, plant.telegram_entries, variables)

    def changed(mode: CpuMode) -> None:
        if mode is not CpuMode.RUN:
            asked.clear()

    plant.cpu.on_mode.append(changed)
    for gateway in plant.telegram_entries:
        port = plant.gateways[gateway.name].port
        names = {drive.inv_no: drive.name for drive in gateway.drives}

        def heard(sent: Transmission, port: object = port, names: dict[int, str] = names) -> None:
            data = sent.data
            if sent.sender is not port or len(data) != _FRAME_BYTES or data[1] not in names:
                return
            drive = plant.drives[names[data[1]]]
            command = drive.series.comno(drive.series.link.command).number
            word = int.from_bytes(data[5:7], "big")
            run = CommandBits.of(drive.series.command_word).run
            if data[2] in _WRITES and int.from_bytes(data[3:5], "big") == command and word & run:
                since_ns = asked.get(drive.name)
                if since_ns is None or sent.start_ns - since_ns > _REMEMBERED_NS:
                    found.append(f"a run command ({word:04X}) went out to {drive.name}, unasked")

        plant.lines[gateway.name].taps.append(heard)

    def sent_to(name: str, word: int) -> None:
        since_ns = asked.get(name)
        if since_ns is None or plant.kernel.now_ns - since_ns > _REMEMBERED_NS:
            found.append(f"a run command ({word:04X}) went out to {name}, unasked")

    _watch_interfaces(plant, sent_to)

    def broken() -> Iterator[str]:
        now_ns = plant.kernel.now_ns
        for name, (enable, *values) in (*read_lines(), *read_interfaces()):
            controls, executed = values[: len(_CONTROL) - 1], values[len(_CONTROL) - 1 :]
            if any(executed) or (enable and any(controls)):
                asked[name] = now_ns
        yield from found
        found.clear()

    return broken


def _watch_interfaces(plant: Installation, told: Callable[[str, int], None]) -> None:
    """Tell each command word with its run bit that goes to a gateway for process data."""
    places: dict[Station, list[tuple[str, int, int]]] = {}
    for entry in plant.interface_entries:
        known = plant.catalog.process_data_gateway(entry.type)
        run = known.word("command").field("run").mask
        offsets = {field.name: field.offset for field in layout_of(entry, known).output}
        places[plant.stations[entry.name]] = [
            (drive.name, offsets[f"{(drive.channel or '').lower()}_command"], run)
            for drive in entry.drives
        ]

    def transferred(transfer: Transfer) -> None:
        for name, at, run in places.get(transfer.station, ()):
            word = int.from_bytes(transfer.outputs[at : at + 2], "big")
            if word & run:
                told(name, word)

    if places:
        plant.master.taps.append(transferred)


def _sequences(plant: Installation, catalog: Catalog) -> tuple[str, ...]:
    """The sequences of the plant that write the command word with its run bit."""
    return tuple(
        name
        for name in plant.plan.sequences
        if any(
            "run" in (getattr(step, "bits", None) or ()) for step in catalog.sequences[name].steps
        )
        or catalog.sequences[name].telegrams
    )


RULE = Rule("no_command_unasked", "No run command goes out that nobody asks for", _watch)
