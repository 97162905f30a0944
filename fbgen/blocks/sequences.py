"""Command sequences as templates see them: steps with their telegrams spelled out in SCL."""

from collections.abc import Collection, Iterator, Mapping

from fbgen.blocks.checked_settings import Sheet, input_name
from fbgen.blocks.literals import NOTHING, SclText, comno, milliseconds, one_line, real, word
from fbgen.blocks.texts import Texts
from fbgen.blocks.words import bits_origin
from fbgen.catalog import (
    BranchStep,
    Catalog,
    CheckStep,
    ComNo,
    Condition,
    DelayStep,
    Parameter,
    ReadStep,
    RepeatStep,
    Result,
    Sequence,
    Setting,
    Step,
    ToshibaProtocol,
    WaitStep,
    WriteStep,
    origin,
)
from fbgen.dataclass import dataclass

_SIGNS = {"equals": "=", "at_least": ">=", "at_most": "<="}
_SCL_TYPES = {"BOOL": "Bool", "INT": "Int", "WORD": "Word", "REAL": "Real", "TIME": "Time"}


@dataclass(frozen=True, slots=True)
class ParameterView:
    """An input or output of a sequence block. `initial` is nothing or ` := value`."""

    name: str
    type: str
    initial: SclText
    comment: SclText


@dataclass(frozen=True, slots=True)
class StepView:
    """One step. `kind` is the key of the catalogue's step; unused parts are empty.

    `condition` is an expression, of the reply's data for "wait"; `target` the number of the step
    to which "branch" and "repeat" go.
    """

    number: int
    kind: str
    comment: SclText
    cmd: SclText = NOTHING
    comno: SclText = NOTHING
    data: tuple[SclText, ...] = ()
    reply_expected: str = "TRUE"
    timeout: SclText = NOTHING
    duration: SclText = NOTHING
    store: SclText = NOTHING
    noted: tuple[SclText, ...] = ()
    condition: SclText = NOTHING
    limit: SclText = NOTHING
    target: SclText = NOTHING
    times: SclText = NOTHING


@dataclass(frozen=True, slots=True)
class SequenceView:
    """A sequence with everything its block needs.

    `wanted` are inputs for what a parameter is to be where that differs from drive to drive.
    """

    id: str
    title: str
    description: tuple[str, ...]
    parameters: tuple[ParameterView, ...]
    results: tuple[ParameterView, ...]
    steps: tuple[StepView, ...]
    uses_max_frequency: bool
    wanted: tuple[ParameterView, ...] = ()

    @property
    def read_steps(self) -> tuple[StepView, ...]:
        """The steps that look at the reply."""
        return tuple(step for step in self.steps if step.kind in ("read", "check", "wait"))

    @property
    def has_checks(self) -> bool:
        """Whether the block counts what is not as it is to be."""
        return any(step.kind == "check" for step in self.steps)

    @property
    def waits(self) -> tuple[StepView, ...]:
        """The steps that read until a condition holds."""
        return tuple(step for step in self.steps if step.kind == "wait")

    @property
    def repeats(self) -> tuple[StepView, ...]:
        """The steps that go back, each with a counter."""
        return tuple(step for step in self.steps if step.kind == "repeat")

    @property
    def has_delay(self) -> bool:
        """Whether the block needs a timer."""
        return any(step.kind in ("delay", "wait") for step in self.steps)


def sequence_view(
    sequence: Sequence, sheet: Sheet, varying: Collection[int], catalog: Catalog, texts: Texts
) -> SequenceView:
    """The sequence as it is for drives of one sheet, all its steps spelled out.

    `varying` are the ComNos that are compared with an input.
    """
    protocol = catalog.toshiba_protocol(sheet.series.protocol)
    builder = _Steps(sequence, sheet, varying, protocol, texts)
    steps = tuple(builder.view(number) for number in range(1, len(sequence.steps) + 1))
    source = f"{texts('Source')}: {sequence.source}"
    paragraphs = (sequence.description, sequence.does_not_protect, source)
    return SequenceView(
        id=sequence.id,
        title=one_line(sequence.title),
        description=tuple(line for text in paragraphs for line in _wrap(one_line(text))),
        parameters=tuple(_parameter(item, texts) for item in sequence.parameters),
        results=(*(_parameter(item, texts) for item in sequence.results), *builder.noted()),
        steps=steps,
        uses_max_frequency=builder.uses_max_frequency,
        wanted=tuple(builder.wanted()),
    )


class _Steps:
    """Spells the steps of one sequence out, for the drives of one sheet."""

    def __init__(
        self,
        sequence: Sequence,
        sheet: Sheet,
        varying: Collection[int],
        protocol: ToshibaProtocol,
        texts: Texts,
    ) -> None:
        self.texts = texts
        self.sequence = sequence
        self.sheet = sheet
        self.drive = sheet.series
        self.varying = varying
        self.protocol = protocol
        self.uses_max_frequency = any(
            isinstance(step, WriteStep) and step.parameter and self._is_setpoint(step.parameter)
            for step in sequence.steps
        ) or any(setting.plant == "max_frequency_hz" for _, setting in self._checks())

    def view(self, number: int) -> StepView:
        step = self.sequence.steps[number - 1]
        if isinstance(step, WriteStep):
            return self._write(number, step)
        if isinstance(step, ReadStep):
            return self._read(number, step)
        if isinstance(step, CheckStep):
            return self._check(number, step)
        if isinstance(step, WaitStep):
            return self._wait(number, step)
        if isinstance(step, BranchStep):
            return self._branch(number, step)
        if isinstance(step, RepeatStep):
            return self._repeat(number, step)
        assert isinstance(step, DelayStep), "settings are spelled out as checks before"
        return self._delay(number, step)

    def _write(self, number: int, step: WriteStep) -> StepView:
        target = self.drive.comno(step.write)
        command = "write_eeprom" if step.memory == "eeprom" else "write_ram"
        return StepView(
            number,
            "write",
            _comment(step, self.texts("write {name}", name=target.name)),
            self._command(command),
            comno(target),
            tuple(self._value(step, target)),
            reply_expected="TRUE" if step.reply == "expected" else "FALSE",
            timeout=self._timeout(step),
        )

    def _read(self, number: int, step: ReadStep) -> StepView:
        target = self.drive.comno(step.read)
        result = next(item for item in self.sequence.results if item.name == step.into)
        return StepView(
            number,
            "read",
            _comment(step, self.texts("read {name}", name=target.name)),
            self._command("read_padded"),
            comno(target),
            (SclText("#channel.request.data := 16#0000;"),),
            timeout=self._timeout(step),
            store=SclText(f"#{result.name} := {self._received(result)};", origin("step", step)),
        )

    def _checks(self) -> Iterator[tuple[CheckStep, Setting]]:
        """Each check with the setting that its value is from."""
        for step in self.sequence.steps:
            if isinstance(step, CheckStep):
                checked = self.drive.comno(step.check)
                setting = None if step.equals is not None else self.sheet.setting(checked)
                source, name = self.sequence.source or self.sequence.id, checked.name
                yield (
                    step,
                    setting or Setting(comno=name, value=step.equals, why=name, source=source),
                )

    def wanted(self) -> Iterator[ParameterView]:
        """The inputs for values that differ from drive to drive."""
        for step, setting in self._checks():
            comno_ = self.drive.comno(setting.comno)
            if step.equals is None and comno_.number in self.varying:
                place = origin(f"ComNo {comno_.hex}", comno_, comno_.source or "")
                text = self.texts("what {comno} is to be", comno=comno_.display or comno_.hex)
                name = input_name(comno_.number)
                yield ParameterView(name, "Word", NOTHING, SclText(text, place))

    def noted(self) -> Iterator[ParameterView]:
        """What checks leave: how many deviate, which was the first, what each was to be and was."""
        checks = [step for step in self.sequence.steps if isinstance(step, CheckStep)]
        if not checks:
            return
        yield ParameterView(
            "deviations", "Int", NOTHING, SclText(self.texts("how many ComNos deviate"))
        )
        yield ParameterView(
            "deviant", "Word", NOTHING, SclText(self.texts("the first of them, 0000 for none"))
        )
        for step in checks:
            comno_ = self.drive.comno(step.check)
            place = origin(f"ComNo {comno_.hex}", comno_, comno_.source or "")
            display = f"{comno_.display}, " if comno_.display else ""
            title = one_line(f"{display}{comno_.title}")
            yield ParameterView(f"expected_{comno_.hex}", "Word", NOTHING, SclText(title, place))
            read = SclText(self.texts("what was read"), place)
            yield ParameterView(f"found_{comno_.hex}", "Word", NOTHING, read)

    def _check(self, number: int, step: CheckStep) -> StepView:
        target = self.drive.comno(step.check)
        setting = next(setting for one, setting in self._checks() if one is step)
        place = origin(f"setting of {target.name}", setting, setting.source or "")
        expected, found = f"#expected_{target.hex}", f"#found_{target.hex}"
        noted = (
            f"{found} := #channel.reply.data;",
            f"IF {found} <> {expected} THEN",
            "   #deviations := #deviations + 1;",
            "   IF #deviant = 16#0000 THEN",
            f"      #deviant := 16#{target.hex};",
            "   END_IF;",
            "END_IF;",
        )
        return StepView(
            number,
            "check",
            _comment(step, self.texts("check {name}", name=target.name)),
            self._command("read_padded"),
            comno(target),
            (
                SclText("#channel.request.data := 16#0000;"),
                SclText(f"{expected} := {self._wanted(target, step, setting)};", place),
            ),
            timeout=self._timeout(step),
            noted=tuple(SclText(line, place) for line in noted),
        )

    def _wanted(self, target: ComNo, step: CheckStep, setting: Setting) -> str:
        """What a parameter is to be, as a word."""
        if step.equals is None and target.number in self.varying:
            return f"#{input_name(target.number)}"
        if setting.plant == "inv_no":
            return "BYTE_TO_WORD(#invNo)"
        if setting.plant == "max_frequency_hz":
            factor = real(round(1 / target.resolution, 6))
            return f"DWORD_TO_WORD(DINT_TO_DWORD(REAL_TO_DINT(#maxFrequency * {factor})))"
        return str(word(target.to_word(setting.value or 0.0)))

    def _delay(self, number: int, step: DelayStep) -> StepView:
        place = origin(f"step {number} of {self.sequence.id}", step)
        if step.delay.parameter is not None:
            duration = SclText(f"#stat_{step.delay.parameter}", place)
        elif step.delay.drive_time is not None:
            known = getattr(self.drive.times, step.delay.drive_time)
            name = f"{self.drive.id} {step.delay.drive_time}"
            duration = milliseconds(known.ms, origin(name, known, known.source or ""))
        else:
            duration = milliseconds(step.delay.ms or 0, place)
        return StepView(number, "delay", _comment(step, self.texts("pause")), duration=duration)

    def _wait(self, number: int, step: WaitStep) -> StepView:
        target = self.drive.comno(step.wait)
        place = origin(f"step {number} of {self.sequence.id}", step, target.source or "")
        return StepView(
            number,
            "wait",
            _comment(step, self.texts("wait for {name}", name=target.name)),
            self._command("read_padded"),
            comno(target),
            (SclText("#channel.request.data := 16#0000;"),),
            timeout=self._timeout(step),
            duration=milliseconds(step.every_ms, place),
            condition=SclText(self._awaited(step.until, target), place),
            limit=milliseconds(step.limit_ms, place),
        )

    def _awaited(self, until: Condition, target: ComNo) -> str:
        """The condition on the data of the reply."""
        data = "#channel.reply.data"
        number = f"DWORD_TO_DINT(WORD_TO_DWORD({data}))"
        parts = [
            f"{number} {_SIGNS[name]} {round(value / target.resolution)}"
            for name, value in until.numbers.items()
        ]
        if until.bits:
            bits = self.drive.word(target.word or "")
            mask, wanted = bits.encode(until.bits.keys()), bits.encode(until.bits)
            parts.append(f"({data} AND {word(mask)}) = {word(wanted)}")
        return " AND ".join(parts)

    def _branch(self, number: int, step: BranchStep) -> StepView:
        place = origin(f"step {number} of {self.sequence.id}", step)
        target = str(self.sequence.position(step.to))
        return StepView(
            number,
            "branch",
            _comment(
                step, self.texts("go to {label} if {name} says so", label=step.to, name=step.branch)
            ),
            condition=SclText(self._compared(step), place),
            target=SclText(target, place),
        )

    def _compared(self, step: BranchStep) -> str:
        """The condition on a parameter or a result of the block."""
        parameter = next((p for p in self.sequence.parameters if p.name == step.branch), None)
        item = parameter or next(r for r in self.sequence.results if r.name == step.branch)
        name = f"#stat_{item.name}" if parameter is not None else f"#{item.name}"
        if item.type == "REAL":
            return _compare(name, {key: str(real(v)) for key, v in step.when.numbers.items()})
        whole = {key: str(round(value)) for key, value in step.when.numbers.items()}
        if item.type == "BOOL":
            number = f"BOOL_TO_INT({name})"
        elif item.type == "WORD":
            number = f"DWORD_TO_DINT(WORD_TO_DWORD({name}))"
        else:
            number = name
        return _compare(number, whole)

    def _repeat(self, number: int, step: RepeatStep) -> StepView:
        place = origin(f"step {number} of {self.sequence.id}", step)
        return StepView(
            number,
            "repeat",
            _comment(step, self.texts("back to {label}", label=step.repeat)),
            target=SclText(str(self.sequence.position(step.repeat)), place),
            times=SclText(str(step.times), place),
        )

    def _value(self, step: WriteStep, target: ComNo) -> list[SclText]:
        place = origin(f"step of {self.sequence.id}", step, self.sequence.source or "")
        if step.literal is not None:
            return [SclText(f"#channel.request.data := {word(step.literal)};", place)]
        if step.parameter is not None:
            parameter = next(p for p in self.sequence.parameters if p.name == step.parameter)
            return [SclText(line, place) for line in self._sent(parameter)]
        bits = self.drive.word(target.word or "")
        names = (*(step.bits or ()), *step.bits_from)
        of_bits = bits_origin(self.drive.id, bits, names) if names else None
        place = origin(f"step of {self.sequence.id}", step, self.sequence.source or "", [of_bits])
        lines = [SclText(f"#channel.request.data := {word(bits.encode(step.bits or ()))};", place)]
        for bit, name in step.bits_from.items():
            mask = word(bits.encode([bit]))
            lines += [
                SclText(f"IF #stat_{name} THEN", place),
                SclText(f"   #channel.request.data := #channel.request.data OR {mask};", place),
                SclText("END_IF;", place),
            ]
        return lines

    def _sent(self, parameter: Parameter) -> list[str]:
        """The lines that put a parameter into the telegram."""
        latched = f"#stat_{parameter.name}"
        if parameter.type == "WORD":
            return [f"#channel.request.data := {latched};"]
        if parameter.type == "INT":
            return [f"#channel.request.data := INT_TO_WORD({latched});"]
        if parameter.scaled_by is None:
            return self._limited(latched, 0.0, 65535.0, 1.0)
        if self._is_setpoint(parameter.name):
            value = f'"TOS_HzToWord"(hz := {latched}, maxFrequency := #maxFrequency)'
            return [f"#channel.request.data := {value};"]
        scale = self.drive.comno(parameter.scaled_by)
        low, high = scale.to_value(scale.minimum_word), scale.to_value(scale.maximum_word)
        return self._limited(latched, low, high, round(1 / scale.resolution, 6))

    def _limited(self, name: str, low: float, high: float, factor: float) -> list[str]:
        """A REAL as a word. What is no number fails every comparison and becomes the minimum."""
        return [
            f"IF NOT ({name} >= {real(low)}) THEN",
            f"   {name} := {real(low)};",
            f"ELSIF {name} > {real(high)} THEN",
            f"   {name} := {real(high)};",
            "END_IF;",
            "#channel.request.data := "
            f"DWORD_TO_WORD(DINT_TO_DWORD(REAL_TO_DINT({name} * {real(factor)})));",
        ]

    def _received(self, result: Result) -> str:
        data = "#channel.reply.data"
        if result.type == "WORD":
            return data
        if result.type == "INT":
            return f"WORD_TO_INT({data})"
        if result.scaled_by is None:
            return f"DINT_TO_REAL(DWORD_TO_DINT(WORD_TO_DWORD({data})))"
        scale = self.drive.comno(result.scaled_by)
        if scale.unit == "Hz" and scale.resolution == self._setpoint.resolution:
            return f'"TOS_WordToHz"(value := {data})'
        if scale.unit == "%" and scale.resolution == 0.01:
            return f'"TOS_WordToPercent"(value := {data})'
        number = f"DINT_TO_REAL(DWORD_TO_DINT(WORD_TO_DWORD({data})))"
        return f"{number} / {real(round(1 / scale.resolution, 6))}"

    @property
    def _setpoint(self) -> ComNo:
        return self.drive.comno(self.drive.link.setpoint)

    def _is_setpoint(self, name: str) -> bool:
        parameter = next((p for p in self.sequence.parameters if p.name == name), None)
        return parameter is not None and parameter.scaled_by == self.drive.link.setpoint

    def _command(self, name: str) -> SclText:
        command = self.protocol.command(name)
        place = origin(f"command {command.letter}", command, command.source or "")
        return SclText(f"16#{command.code:02X}", place)

    def _timeout(self, step: WriteStep | ReadStep | CheckStep | WaitStep) -> SclText:
        if step.timeout_ms is not None:
            return milliseconds(step.timeout_ms, origin("timeout_ms", step))
        return milliseconds(self.sequence.reply_timeout_ms, origin("timeout", self.sequence))


def _compare(value: str, numbers: Mapping[str, str]) -> str:
    return " AND ".join(f"{value} {_SIGNS[name]} {number}" for name, number in numbers.items())


def _comment(step: Step, fallback: str) -> SclText:
    return SclText(one_line(step.title or fallback), origin("step", step))


def _parameter(item: Parameter | Result, texts: Texts) -> ParameterView:
    default = item.default if isinstance(item, Parameter) else None
    place = origin(f"parameter {item.name}", item)
    unit = f" {texts('in {unit}', unit=item.unit)}" if item.unit else ""
    return ParameterView(
        item.name,
        _SCL_TYPES[item.type],
        SclText(f" := {default}", place) if default is not None else NOTHING,
        SclText(one_line(item.title + unit), place),
    )


def _wrap(text: str, width: int = 92) -> list[str]:
    lines: list[str] = []
    for piece in text.split(" "):
        if lines and len(lines[-1]) + 1 + len(piece) <= width:
            lines[-1] += f" {piece}"
        else:
            lines.append(piece)
    return lines
