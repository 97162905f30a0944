"""Each run command that goes out to a drive, however the drive is reached."""

from collections.abc import Callable

from fbgen.catalog import Drive
from fbgen.plant import PlantGateway, SerialLine, layout_of
from fbgen.wire.devicenet import Frame
from fbgen.wire.devicenet_ids import Group2, group_2
from fbgen.wire.single_words import wanted_in
from fbgen.wire.toshiba import BROADCAST, Command
from harness.drives.word_bits import CommandBits
from harness.fieldbus import Station, Transfer
from harness.fieldbus.devicenet import CanPort
from harness.gateways.dev003z import Dev003z
from harness.gateways.dev003z.commands import COMMAND
from harness.installation import Installation
from harness.installation.devicenet import DeviceNet
from harness.installation.serial_lines import port_at
from harness.line import Transmission

Told = Callable[[str, int, int], None]
"""Gets the name of the drive, the command word, and when its frame began."""
_WRITES = (Command.P, Command.W)
_FRAME_BYTES = 8
_RUN_WORDS = ("basic_control", "extended_control", "command")
_RUN_BITS = ("run", "run_forward", "run_reverse")


def tell_run_commands(plant: Installation, told: Told) -> None:
    """Tell every run command from now on.

    Of a gateway for process data it is what the master sends to it: what that does with the drives
    by itself is not the PLC's doing. On DeviceNet it is what the scanner polls with.
    """
    for gateway in plant.telegram_entries:
        _on_a_gateways_line(plant, gateway, told)
    for line in plant.plan.serial:
        _on_a_serial_line(plant, line, told)
    _at_interfaces(plant, told)
    for network in plant.networks.values():
        _on_a_network(plant, network, told)


def _run_of(series: Drive) -> int:
    return CommandBits.of(series.command_word).run


def _on_a_gateways_line(plant: Installation, gateway: PlantGateway, told: Told) -> None:
    port = plant.gateways[gateway.name].port
    names = {drive.inv_no: drive.name for drive in gateway.drives}

    def heard(sent: Transmission) -> None:
        data = sent.data
        if sent.sender is not port or len(data) != _FRAME_BYTES or data[1] not in names:
            return
        series = plant.drives[names[data[1]]].series
        command = series.comno(series.link.command).number
        word = int.from_bytes(data[5:7], "big")
        is_command = data[2] in _WRITES and int.from_bytes(data[3:5], "big") == command
        if is_command and word & _run_of(series):
            told(names[data[1]], word, sent.start_ns)

    plant.lines[gateway.name].taps.append(heard)


def _on_a_serial_line(plant: Installation, line: SerialLine, told: Told) -> None:
    """Broadcasts are for all drives of the line."""
    port = plant.devices.modules[line.name].port

    def heard(sent: Transmission) -> None:
        wanted = wanted_in(line.family, sent.data) if sent.sender is port else None
        if wanted is None or not wanted.writes:
            return
        for entry in line.drives:
            series = plant.drives[entry.name].series
            command = series.comno(port_at(line, series).command).number
            is_for_it = wanted.inv_no in (entry.inv_no, BROADCAST)
            if is_for_it and wanted.com_no == command and wanted.data & _run_of(series):
                told(entry.name, wanted.data, sent.start_ns)

    plant.lines[line.name].taps.append(heard)


def _at_interfaces(plant: Installation, told: Told) -> None:
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
                told(name, word, plant.kernel.now_ns)

    if places:
        plant.master.taps.append(transferred)


def _on_a_network(plant: Installation, network: DeviceNet, told: Told) -> None:
    """What stands in the data of a poll, each time that the scanner sends them."""
    watched = {
        group_2(Group2.POLL, item.mac): (
            item.name,
            network.scanner.slaves[item.mac],
            run_bits_of(network.options[item.name]),
        )
        for item in network.entry.drives
    }

    def passed(end_ns: int, frame: Frame, port: CanPort) -> None:
        found = watched.get(frame.identifier)
        if found is None or port is not network.trunk or not frame.data:
            return
        name, slave, (offset, run) = found
        word = int.from_bytes((slave.sent or b"")[offset : offset + 2], "little")
        if word & run:
            told(name, word, end_ns)

    network.bus.taps.append(passed)


def run_bits_of(option: Dev003z) -> tuple[int, int]:
    """Where in the data of an option the word stands that lets it run, and its bits that do; none
    where its commands do not carry that word."""
    pair = option.assemblies.chosen
    command = next(item.code for item in option.gateway.commands if item.comno == COMMAND)
    for field in pair.output.fields:
        chosen = field.parameter is not None and option.own[field.parameter] == command
        if chosen or field.word in _RUN_WORDS:
            word = option.gateway.word("command" if chosen else field.word or "")
            masks = [bit.mask for bit in word.bits if bit.name in _RUN_BITS]
            return field.offset, sum(masks)
    return 0, 0
