"""Scenario files: a plant, what is done to it, and what must come of it. Format version 1.

    version: 1
    title: Forward at 50 Hz
    plant: plant.yaml
    steps:
      - set: {plc.TOS_Plant.gw1.pump.start_forward.execute: true}
      - expect: {drive.pump.frequency: 50.0}
        within: 12 s

Steps run one after the other. Names in `set` and `expect` are paths, see `harness.scenario.paths`.
The whole format stands in `docs/reference/scenario-files.md`.
"""

from collections.abc import Iterable
from typing import Annotated, Any, Literal

from pydantic import ConfigDict, Discriminator, Field, Tag
from pydantic.json_schema import WithJsonSchema

from fbgen.catalog import Located
from fbgen.catalog.scalars import Count, Real, SnakeName, Text
from fbgen.diagnostics import Diagnostic
from fbgen.plant import PlantDialect, PlcFamily
from harness.drives import Load, LoadShape
from harness.durations import DurationNs, PositiveDurationNs
from harness.installation import DriveConditions
from harness.kernel import NS_PER_MS
from harness.rules import RULES
from harness.scenario.expectations import Conditions
from harness.scenario.fault_model import FaultName, ScenarioFault
from harness.scenario.fault_schema import with_places_and_settings
from harness.scenario.kind_tags import tag_by_key
from harness.scenario.property_model import Property
from harness.scenario.scalars import ScalarValue
from harness.scenario.schema_places import with_places
from harness.scenario.seeds import Seeds
from harness.scenario.start_model import GatewaySetup, PlantTimes
from harness.scenario.stub_tables import StubValue
from harness.scenario.temporaries import Temporaries

RuleName = Annotated[Text, WithJsonSchema({"enum": ["all", *sorted(RULES)]})]
"""A rule of the plant; which ones there are is checked with the plant at hand."""


class SetStep(Located):
    """Write variables of the PLC or parameters of the drives, now and in the order written."""

    set: dict[str, ScalarValue] = Field(min_length=1, description="Path: value")


class WaitStep(Located):
    """Let time pass."""

    wait: PositiveDurationNs = Field(description="How long, such as 500 ms")


class ExpectStep(Located):
    """All of it must hold at one instant: now, or at the latest after `within`."""

    expect: Conditions = Field(
        description="Path: value, or path: {min: ..., max: ...} and the like"
    )
    within: DurationNs = Field(
        default=0,
        description="It need not hold at once but must at some instant of this time",
        json_schema_extra={"default": "0 s"},
    )
    stays_for: DurationNs = Field(
        default=0,
        description="From the instant at which it holds it must go on holding for this time",
        json_schema_extra={"default": "0 s"},
    )


class WaitUntilStep(Located):
    """Let time pass until all of it holds at one instant."""

    wait_until: Conditions = Field(
        description="Path: value, or path: {min: ..., max: ...} and the like"
    )
    within: PositiveDurationNs = Field(description="The limit: the scenario fails if it is over")


class CallStep(Located):
    """Call the block under test, once each cycle."""

    call: Annotated[int, Field(ge=1, le=1_000_000, strict=True)] = Field(
        description="How many cycles"
    )


class InjectStep(Located):
    """Start a fault. It lasts until a step clears it."""

    model_config = ConfigDict(json_schema_extra=with_places_and_settings)

    inject: FaultName = Field(description="What goes wrong")
    on: Text | None = Field(default=None, description="The gateway or drive that it happens to")
    settings: dict[str, ScalarValue] = Field(
        default_factory=dict, description="Settings of the fault; each has a default"
    )


class ClearStep(Located):
    """End a fault that a step before has started."""

    clear: FaultName = Field(description="What ends")
    on: Text | None = Field(
        default=None, description="The gateway or drive, as where it was injected"
    )


class ExpectedTelegram(Located):
    """A telegram as it must have been: bytes in hexadecimal, `xx` for any."""

    output: Text = Field(description="The 9 bytes to the gateway: control, trigger, telegram")
    input: Text | None = Field(
        default=None, description="The 8 bytes from it with the reply: status, telegram"
    )


class TelegramsStep(Located):
    """A gateway's telegrams since the start or the last such step: these, in order, no others."""

    telegrams: tuple[ExpectedTelegram, ...] = Field(description="The first one first")
    gateway: Text = Field(description="Whose telegrams")


class SequenceStep(Located):
    """A gateway's telegrams since the start or the last such step: those of a sequence."""

    of_sequence: SnakeName = Field(description="A sequence of the catalogue, such as start_forward")
    gateway: Text = Field(description="Whose telegrams")


_KINDS: dict[str, type[Located]] = {
    "set": SetStep,
    "wait": WaitStep,
    "wait_until": WaitUntilStep,
    "call": CallStep,
    "expect": ExpectStep,
    "inject": InjectStep,
    "clear": ClearStep,
    "telegrams": TelegramsStep,
    "of_sequence": SequenceStep,
}

Step = Annotated[
    Annotated[SetStep, Tag("set step")]
    | Annotated[WaitStep, Tag("wait step")]
    | Annotated[WaitUntilStep, Tag("wait_until step")]
    | Annotated[CallStep, Tag("call step")]
    | Annotated[ExpectStep, Tag("expect step")]
    | Annotated[InjectStep, Tag("inject step")]
    | Annotated[ClearStep, Tag("clear step")]
    | Annotated[TelegramsStep, Tag("telegrams step")]
    | Annotated[SequenceStep, Tag("of_sequence step")],
    Discriminator(
        tag_by_key(_KINDS, "step"),
        custom_error_type="step",
        custom_error_message="a step has exactly one of the keys " + ", ".join(_KINDS),
    ),
]
"""One step; its first key says which."""


class LoadSetup(Located):
    """The driven machine."""

    torque: Real = Field(
        default=0.0, description="In percent of the motor's rated torque, at `at_hz`"
    )
    shape: Literal["constant", "linear", "quadratic"] = Field(
        default="constant", description="How the torque depends on the speed"
    )
    at_hz: Annotated[Real, Field(gt=0)] = Field(
        default=50.0, description="The speed at which it is so"
    )
    inertia: Annotated[Real, Field(ge=0)] = Field(
        default=0.0,
        description="Torque in percent that it takes to change the speed by 1 Hz in a second",
    )

    def load(self) -> Load:
        """The same as the drive takes it."""
        return Load(self.torque, LoadShape(self.shape), self.at_hz, self.inertia)


class DriveSetup(Located):
    """How a drive is set before the start."""

    load: LoadSetup | None = Field(
        default=None, description="The driven machine; none if not given"
    )
    parameters: dict[str, Real] = Field(
        default_factory=dict,
        description="ComNo or its name: value in its unit, on top of those of the gateway's manual",
    )
    reply_time: DurationNs | None = Field(
        default=None, description="Every reply after this time; else 10 to 20 ms, drawn by the seed"
    )
    port: Text | None = Field(
        default=None, description="The port at the line, for series with several; else the first"
    )

    def conditions(self) -> DriveConditions:
        """The same as the plant takes it."""
        return DriveConditions(
            load=self.load.load() if self.load is not None else None,
            parameters=self.parameters,
            reply_time_ns=self.reply_time,
            port=self.port,
        )


def _or_column(schema: dict[str, Any]) -> None:
    """In the JSON Schema a column of `cases` may stand there."""
    schema["anyOf"].append({"pattern": r"^\$\{\w+\}$", "type": "string"})


class Variation(Located):
    """The scenario once more with changes to the plant file; {} is the plant as it is."""

    dialect: PlantDialect | None = Field(default=None, description="Language of the text")
    plc: PlcFamily | None = Field(
        default=None, description="Family of the CPU", json_schema_extra=_or_column
    )
    prefix: Text | None = Field(default=None, description="How the names of blocks begin")
    layout: Text | None = Field(default=None, description="Cyclic data of all gateways")
    access: Literal["per_identifier", "dpxx_dat", "process_image"] | None = Field(
        default=None, description="How the program reaches the cyclic data of all gateways"
    )
    cycle_time_ms: Annotated[Real, Field(gt=0, le=6000)] | None = Field(
        default=None, description="Cycle of the PLC in milliseconds"
    )
    options: dict[SnakeName, ScalarValue] = Field(
        default_factory=dict, description="Options of all gateways, by the catalogue's names"
    )
    error_obs: Literal["generate", "mine"] | None = Field(
        default=None, description="Whether the error blocks of an S7-300/400 are generated"
    )


class Scenario(Located):
    """One scenario file."""

    version: Literal[1] = Field(description="Version of this format")
    title: Text = Field(description="What is shown, in one sentence")
    plant: Text | None = Field(
        default=None, description="The plant file, as seen from the folder of this file"
    )
    block: Text | None = Field(
        default=None,
        description="Only this block is tested, called once each cycle, with nothing around it",
    )
    sources: tuple[Text, ...] = Field(
        default=(),
        description="PLC texts, as seen from the folder of this file, in the place of what is "
        "generated for the plant",
    )
    dialect: Literal["tia", "step7", "iec", "twincat"] | None = Field(
        default=None, description="Language of the sources, tia if not said; a plant has its own"
    )
    cycle: PositiveDurationNs = Field(
        default=10 * NS_PER_MS,
        description="Time from one call of the block to the next",
        json_schema_extra={"default": "10 ms"},
    )
    stubs: dict[Text, dict[Text, StubValue]] = Field(
        default_factory=dict,
        description="Instructions and blocks that are not there: name, and the outputs of each "
        "call by name, RET_VAL for the result of a function; a list has a value for each call, "
        "a mapping from times to values one from each time on",
    )
    seed: Count = Field(default=0, description="Seed of everything random, such as reply times")
    engine: Literal["compiled", "reference"] = Field(
        default="compiled", description="How the PLC text is run; both give the same"
    )
    temporaries: Temporaries = Field(
        default="initial",
        description="What temporary variables hold before they are written: their defaults, or "
        "anything, where the controller does not clear them",
    )
    variations: tuple[Variation, ...] = Field(default=(), description="Run once for each of these")
    drives: dict[str, DriveSetup] = Field(
        default_factory=dict, description="Drives of the plant as they are set before the start"
    )
    gateways: dict[str, GatewaySetup] = Field(
        default_factory=dict, description="What is in gateways at the start, by their names"
    )
    times: PlantTimes = Field(
        default_factory=PlantTimes, description="Times of PROFIBUS and PLC that no plant file says"
    )
    tags: tuple[SnakeName, ...] = Field(default=(), description="Names for `fbgen test -k`")
    facts: tuple[Text, ...] = Field(default=(), description="Ids of behaviour rows that this shows")
    seeds: Seeds = Field(
        default=(), description="Run once with each: how many, from `seed` on, or a list of them"
    )
    cases: dict[SnakeName, dict[SnakeName, ScalarValue]] = Field(
        default_factory=dict,
        description="A table: run once for each row, by name, with its values for ${column}",
    )
    expect_failure: Text | None = Field(
        default=None, description="Why a check fails; the scenario fails if none does"
    )
    properties: tuple[Property, ...] = Field(
        default=(), description="What must hold during the whole run"
    )
    faults: tuple[ScenarioFault, ...] = Field(
        default=(), description="Faults that come by the clock, beside those of the steps"
    )
    rules: tuple[RuleName, ...] = Field(
        default=(), description="Rules of the plant that hold in every scan; all: every one of them"
    )
    steps: tuple[Step, ...] = Field(min_length=1, description="What is done and expected")

    @classmethod
    def model_json_schema(cls, *arguments: Any, **settings: Any) -> dict[str, Any]:
        """As editors take it, with the places of a table of cases."""
        return with_places(super().model_json_schema(*arguments, **settings))

    def problems(self) -> Iterable[Diagnostic]:
        """FB8008: nothing is checked. FB8018: what is said of the plant or block does not fit."""
        checks = (ExpectStep, TelegramsStep, SequenceStep)
        watched = self.properties or self.rules
        if not watched and not any(isinstance(step, checks) for step in self.steps):
            yield Diagnostic(
                "FB8008",
                "the scenario checks nothing, so it can not fail",
                self.span_of("steps"),
                "add a step with expect:, or properties:",
            )
        yield from self._misfits()

    def _misfits(self) -> Iterable[Diagnostic]:
        if self.plant is None and not self.sources:
            message = "nothing says what is tested"
            advice = "add plant: with the plant file, or sources: with the PLC text of a block"
            yield Diagnostic("FB8018", message, self.span, advice)
        if self.block is not None and self.plant is not None and self.sources:
            message = "a block of sources needs no plant"
            advice = "leave out plant:, or block: to run the sources in the plant"
            yield Diagnostic("FB8018", message, self.span_of("plant"), advice)
        if self.plant is not None and self.dialect is not None:
            message = "the sources of a plant are of the plant's dialect"
            advice = "leave it out; variations: change the dialect of a plant"
            yield Diagnostic("FB8018", message, self.span_of("dialect"), advice)
        wrong: dict[str, object]
        if self.is_of_block:
            wrong = {"drives": self.drives, "gateways": self.gateways, "times": self._says("times")}
            advice = "a block on its own has no devices around it"
        else:
            wrong = {"stubs": self.stubs, "cycle": self._says("cycle")}
            advice = "it is for a block on its own: name it with block:"
        if self.plant is None:
            wrong["variations"] = self.variations
        for name in wrong:
            if wrong[name]:
                message = f"'{name}' does not fit here"
                yield Diagnostic("FB8018", message, self.span_of(name), advice)
        if isinstance(self.seeds, tuple) and self.seeds and "seed" in self.model_fields_set:
            message = "a list of seeds leaves nothing for 'seed' to say"
            yield Diagnostic("FB8018", message, self.span_of("seed"), "leave it out")

    def _says(self, key: str) -> bool:
        return key in self.model_fields_set

    @property
    def is_of_block(self) -> bool:
        """Whether a block is tested on its own."""
        return self.plant is None or self.block is not None
