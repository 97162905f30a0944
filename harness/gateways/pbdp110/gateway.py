"""The PBDP-110: PROFIBUS DP slave on one side, two drives at ports of their own on the other.

Behaviour after the PBDP-110 manual #10407-1.100-000: modules and cyclic data in section 9,
diagnosis in 9.3, global control and watchdog in 2, switches in 8. Sync, Freeze and Clear_Data are
the slave's; what it gives on is the outputs as they count. The interface lives on the supply of the
drive at channel A.

Inferred: the diagnosis is one device-related byte with a header of length 2.
"""

from collections.abc import Callable, Mapping
from functools import partial

from fbgen.diagnostics import error
from harness.fieldbus import DpSlave, SlaveType
from harness.gateways.pbdp110.drive_channel import DriveChannel
from harness.gateways.pbdp110.leds import Leds, Light, lit
from harness.gateways.pbdp110.settings import BusLost, ChannelPlace, PbdpSettings
from harness.kernel import Kernel
from harness.line import Line

_DIAGNOSIS_HEADER = 2
_STANDARD_DIAGNOSIS_BYTES = 6


class Pbdp110:
    """One interface, without supply at first.

    `lines` are the cables to the drives by the names of channels. `address` is what the address
    switches say; it is read at power-on. Functions in `observers` are called when something that
    can be seen at the device may have changed.
    """

    __slots__ = (
        "_cut",
        "_kernel",
        "_life",
        "_module",
        "_plugged",
        "_started",
        "_supplies",
        "address",
        "channels",
        "name",
        "observers",
        "powered",
        "settings",
        "slave",
    )

    def __init__(
        self,
        kernel: Kernel,
        settings: PbdpSettings,
        lines: Mapping[str, Line],
        address: int,
        name: str = "",
    ) -> None:
        self._kernel = kernel
        self.name = name
        self.settings = settings
        self._module = first = settings.modules[0]
        self.slave = DpSlave(
            kernel,
            self,
            SlaveType(
                settings.ident_number,
                first.configuration,
                settings.user_parameter_bytes,
                other_configurations=tuple(item.configuration for item in settings.modules[1:]),
                max_diagnosis_bytes=_STANDARD_DIAGNOSIS_BYTES + _DIAGNOSIS_HEADER,
            ),
            address,
            (first.output_length, first.input_length),
        )
        self.observers: list[Callable[[], None]] = []
        self.channels = {
            item.name: DriveChannel(kernel, settings, lines[item.name], self._changed, item.facts)
            for item in settings.channels
        }
        self._supplies = dict.fromkeys(self.channels, False)
        self._plugged = dict.fromkeys(self.channels, True)
        self._cut = False
        self.powered = self._started = False
        self._life = 0
        self.address = address
        self.set_switches(address)

    # --- supply, switches, lamps ----------------------------------------------------------------

    def set_switches(self, address: int) -> None:
        """Set the address switches; the device looks at them at its next power-on.

        Raises DiagnosticError FB7301 for an address that the switches cannot show.
        """
        highest = self.settings.highest_address
        if not 0 <= address <= highest:
            raise error(
                "FB7301",
                f"the address switches of '{self.name}' cannot be set to {address}",
                None,
                f"seven switches show 0 to {highest}",
            )
        self.address = address

    def supply(self, channel: str, present: bool) -> None:
        """The drive at a channel gives supply, or does so no more."""
        if self._supplies[channel] is not present:
            self._supplies[channel] = present
            self._look_at_supply()

    def plug(self, channel: str) -> None:
        """The cable to the drive at a channel is in its place."""
        self._plugged[channel] = True
        self._look_at_supply()

    def unplug(self, channel: str) -> None:
        """The cable to the drive at a channel is pulled, and the supply with it."""
        self._plugged[channel] = False
        self._look_at_supply()

    def power_on(self) -> None:
        """Nothing keeps the supply of the drives away any more."""
        self._cut = False
        self._look_at_supply()

    def power_off(self) -> None:
        """No supply, whatever the drives give."""
        self._cut = True
        self._look_at_supply()

    def _has_supply(self, channel: str) -> bool:
        return self._supplies[channel] and self._plugged[channel]

    def _look_at_supply(self) -> None:
        powers = [item.name for item in self.settings.channels if item.powers_gateway]
        supplied = not self._cut and any(self._has_supply(name) for name in powers)
        if supplied and not self.powered:
            self._start_up()
        elif self.powered and not supplied:
            self._shut_down()
        self._notify()

    def _start_up(self) -> None:
        self.powered = True
        if self.settings.startup_ns:
            self._kernel.after(self.settings.startup_ns, partial(self._start, self._life))
        else:
            self._start(self._life)

    def _shut_down(self) -> None:
        self.powered = self._started = False
        self._life += 1
        for channel in self.channels.values():
            channel.stop()
        self.slave.power_off()
        self._show()

    def _start(self, life: int) -> None:
        if life != self._life:
            return
        self._started = True
        self._show()
        self.slave.power_on(self.address)
        for channel in self.channels.values():
            channel.start()

    @property
    def leds(self) -> Leds:
        """What the lamps show."""
        alive = lit(self._started, Light.GREEN_FLASHING)
        ports = [lit(self._has_supply(name)) for name in self.channels]
        return Leds(lit(self.slave.online), alive, *ports)

    @property
    def diagnosis(self) -> int:
        """The user diagnosis byte: a bit for each drive that is tripped."""
        return sum(
            item.diagnosis_mask
            for item in self.settings.channels
            if self.channels[item.name].tripped
        )

    @property
    def telegrams(self) -> int:
        """How many requests went to the drives since power-on."""
        return sum(channel.telegrams for channel in self.channels.values())

    # --- PROFIBUS ---------------------------------------------------------------------------------

    def exchange_started(self) -> None:
        """The master has chosen its module and exchanges data."""
        chosen = self.slave.configuration
        self._module = next(item for item in self.settings.modules if item.configuration == chosen)
        for channel in self.channels.values():
            channel.access.reset()
        self._show()
        self._notify()

    def exchange_lost(self) -> None:
        """The master is gone: with an active watchdog the drives may go to local control."""
        parameters = self.slave.parameters
        watched = parameters is not None and parameters.watchdog_factors is not None
        for channel in self.channels.values():
            if watched and self.settings.bus_lost is BusLost.LOCAL:
                channel.to_local()
            channel.access.reset()
        self._notify()

    def outputs_received(self, outputs: bytes) -> None:
        """The outputs as they count now: commands and set-points, and the parameter channels."""
        for channel, place in self._places():
            channel.command(_word(outputs, place.command), _word(outputs, place.frequency))
            if (access := place.access) is not None:
                channel.access.outputs(
                    _word(outputs, access.action),
                    _word(outputs, access.number),
                    _word(outputs, access.data),
                )
                if channel.access.wanted is not None:
                    channel.respond()
        self._changed()

    # --- inside -----------------------------------------------------------------------------------

    def _places(self) -> list[tuple[DriveChannel, ChannelPlace]]:
        return list(zip(self.channels.values(), self._module.places, strict=False))

    def _changed(self) -> None:
        self._show()
        self._notify()

    def _show(self) -> None:
        """Put the inputs and the diagnosis together anew."""
        settings = self.settings
        inputs = bytearray(self._module.input_length)
        for channel, place in self._places():
            if not channel.online:
                continue
            values = [channel.values[0] | settings.online_mask, *channel.values[1:]]
            words = list(zip(place.inputs, values, strict=True))
            if (access := place.access) is not None:
                response = channel.access.response << settings.access.response_shift
                words += [
                    (access.response, response),
                    (access.response_number, channel.access.number),
                    (access.response_data, channel.access.data),
                ]
            for at, word in words:
                inputs[at : at + 2] = word.to_bytes(2, "big")
        self.slave.set_inputs(bytes(inputs))
        diagnosis = self.diagnosis
        if self.powered and (diagnosis or self.slave.ext_diag):
            self.slave.set_ext_diag(bool(diagnosis), bytes((_DIAGNOSIS_HEADER, diagnosis)))

    def _notify(self) -> None:
        for observer in self.observers:
            observer()


def _word(data: bytes, at: int) -> int:
    return data[at] << 8 | data[at + 1]
