"""The bits of command and status word as masks, looked up once by their names in the catalogue."""

from dataclasses import fields
from typing import Self

from fbgen.catalog import Word
from fbgen.dataclass import dataclass

_NEEDED = ("network_command", "network_frequency", "fault_reset", "run", "reverse", "running")


@dataclass(frozen=True, slots=True)
class _Masks:
    @classmethod
    def of(cls, word: Word) -> Self:
        """The masks of a word of the catalogue; 0 for a bit that this series does not have.

        DiagnosticError FB1202 for one without which no inverter can be steered or watched.
        """
        masks = {bit.name: bit.mask for bit in word.bits}
        needed = (field.name for field in fields(cls) if field.name in _NEEDED)
        masks |= {name: word.field(name).mask for name in needed}
        return cls(**{field.name: masks.get(field.name, 0) for field in fields(cls)})


@dataclass(frozen=True, slots=True)
class CommandBits(_Masks):
    """Masks of the command word FA00."""

    network_command: int
    network_frequency: int
    fault_reset: int
    emergency_stop: int
    coast_stop: int
    run: int
    reverse: int
    jog: int
    dc_braking: int
    pattern_2: int
    pi_control_off: int
    motor_2: int
    preset_speed_4: int
    preset_speed_3: int
    preset_speed_2: int
    preset_speed_1: int

    def preset(self, command: int) -> int:
        """Number of the preset speed that a command word asks for, 0 for none."""
        masks = (
            self.preset_speed_1,
            self.preset_speed_2,
            self.preset_speed_3,
            self.preset_speed_4,
        )
        return sum(1 << place for place, mask in enumerate(masks) if command & mask)


@dataclass(frozen=True, slots=True)
class StatusBits(_Masks):
    """Masks of the operating status FD01."""

    standby: int
    standby_st_on: int
    emergency_stopped: int
    coast_stopped: int
    running: int
    reverse: int
    jog: int
    dc_braking: int
    pattern_2: int
    pi_control_off: int
    motor_2: int
    alarm: int
    tripped: int
    failure: int


@dataclass(frozen=True, slots=True)
class SecondBits(_Masks):
    """Masks of the second command word, FA20 and FA22 of the VF-AS1."""

    pattern: int
    quick_stop: int

    def pattern_of(self, word: int) -> int:
        """The ramp that a word asks for, 0 to 3."""
        return (word & self.pattern) // (self.pattern & -self.pattern) if self.pattern else 0


NO_SECOND_WORD = SecondBits(0, 0)
