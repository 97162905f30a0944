"""What a GSD file says about a DP slave, as far as a PLC program and a master depend on it."""

from collections.abc import Sequence

from fbgen.dataclass import dataclass
from fbgen.diagnostics import Diagnostic
from fbgen.source import Source, Span
from fbgen.wire.gsd.statements import Statement
from fbgen.wire.profibus import Identifier, decode_identifiers, input_length, output_length


@dataclass(frozen=True, slots=True)
class Rate:
    """A transmission rate that the slave takes, as the keywords name it: `187.5`, `12M`.

    `max_tsdr` is the longest time until it answers, in bit times; None where the file says none.
    """

    name: str
    max_tsdr: int | None


@dataclass(frozen=True, slots=True)
class GsdModule:
    """A module that can be plugged.

    `code` are its configuration identifiers as bytes, `reference` the number by which slots name
    it, `parameters` what it adds to the user parameters. `preset`: it is plugged to begin with.
    """

    name: str
    code: bytes
    span: Span
    reference: int | None = None
    preset: bool = False
    info: str = ""
    parameters: bytes = b""

    @property
    def identifiers(self) -> tuple[Identifier, ...]:
        """The identifiers one by one; they were checked when the file was read."""
        return decode_identifiers(self.code)

    @property
    def output_length(self) -> int:
        """Bytes from the PLC to the slave."""
        return output_length(self.identifiers)

    @property
    def input_length(self) -> int:
        """Bytes from the slave to the PLC."""
        return input_length(self.identifiers)


@dataclass(frozen=True, slots=True)
class SlotDefinition:
    """What may be plugged at one place, by the references of modules: from, to, both included."""

    number: int
    name: str
    default: int
    allowed: tuple[tuple[int, int], ...]

    def takes(self, module: GsdModule) -> bool:
        """Whether the module may be plugged there."""
        wanted = module.reference
        return wanted is None or any(low <= wanted <= high for low, high in self.allowed)


@dataclass(frozen=True, slots=True)
class DiagnosisText:
    """What bits of the device's own diagnosis mean; `value` None: that the one bit is set."""

    first: int
    last: int
    value: int | None
    text: str


@dataclass(frozen=True, slots=True)
class Limits:
    """The longest data that a station takes, in bytes, and how many modules; None: not said."""

    modules: int | None
    inputs: int | None
    outputs: int | None
    data: int | None


@dataclass(frozen=True, slots=True)
class GsdStation:
    """A DP slave. Texts that the file does not have are empty.

    `min_slave_interval_us` is the least time between two cycles of this slave. With `fail_safe` it
    takes empty outputs in CLEAR. With `fixed_presets` preset modules cannot be pulled. `parameters`
    are the preset user parameters of the station alone. `unknown` are statements that fbgen has no
    use for, `warnings` what is wrong in the file and did no harm.
    """

    source: Source
    ident_number: int
    gsd_revision: int
    vendor: str
    model: str
    revision: str
    hardware_release: str
    software_release: str
    order_number: str
    implementation: str
    is_master: bool
    rates: tuple[Rate, ...]
    auto_baud: bool
    sync: bool
    freeze: bool
    set_slave_address: bool
    fail_safe: bool
    dpv1: bool
    watchdog_base_1ms: bool
    min_slave_interval_us: int
    max_diagnosis_bytes: int
    modular: bool
    fixed_presets: bool
    module_offset: int
    limits: Limits
    parameters: bytes
    modules: tuple[GsdModule, ...]
    slots: tuple[SlotDefinition, ...] = ()
    diagnosis: tuple[DiagnosisText, ...] = ()
    unknown: tuple[Statement, ...] = ()
    warnings: tuple[Diagnostic, ...] = ()

    def user_parameters(self, plugged: Sequence[GsdModule]) -> bytes:
        """User_Prm_Data of Set_Prm as the file presets them: the station's, then each module's."""
        return b"".join((self.parameters, *(module.parameters for module in plugged)))
