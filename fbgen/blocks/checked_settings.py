"""Which parameters the sequences of a plant compare, and with what, at each of its drives.

A sequence is one block for all drives on lines. So it compares what the sheets of all of them have,
and a value that is not the same everywhere is an input of the block.
"""

from collections.abc import Iterator, Mapping
from collections.abc import Sequence as Row

from fbgen.blocks.drive_settings import drive_settings
from fbgen.blocks.literals import SclText, word
from fbgen.catalog import (
    Catalog,
    CheckStep,
    ComNo,
    Drive,
    Sequence,
    Setting,
    SettingsStep,
    Step,
    origin,
)
from fbgen.dataclass import dataclass
from fbgen.diagnostics import error
from fbgen.plant import Plant, PlantGateway, SerialLine


@dataclass(frozen=True, slots=True)
class Sheet:
    """What the inverters of one series are set to at one gateway or on one line."""

    unit: PlantGateway | SerialLine
    series: Drive
    settings: Mapping[int, Setting]

    def setting(self, comno: ComNo) -> Setting | None:
        """How a parameter is to be set there; None where the sheet has no value for it."""
        return self.settings.get(comno.number)

    def word(self, number: int) -> int:
        """The value of a setting that is no drive's own, as a word."""
        return self.series.comno(number).to_word(self.settings[number].value or 0.0)


def sheets(plant: Plant, catalog: Catalog) -> tuple[Sheet, ...]:
    """One for each series at each gateway with a line, and on each serial line."""
    found = []
    for unit in plant.gateways_and_lines:
        names = dict.fromkeys(drive.series for drive in unit.drives if drive.channel is None)
        for name in names:
            series = catalog.drive(name)
            known = drive_settings(plant, unit, series, catalog)
            always = {series.comno(one.comno).number: one for one in known if one.always}
            found.append(Sheet(unit, series, always))
    return tuple(found)


def spelled_out(sequence: Sequence, sheet: Sheet, all_sheets: Row[Sheet]) -> Sequence:
    """The sequence with a step for each parameter that all sheets have."""
    steps: list[Step] = []
    for step in sequence.steps:
        steps += _checks(step, sheet, all_sheets) if isinstance(step, SettingsStep) else [step]
    return sequence.model_copy(update={"steps": tuple(steps)})


def _checks(step: SettingsStep, sheet: Sheet, all_sheets: Row[Sheet]) -> Iterator[CheckStep]:
    label = step.label
    for number in all_sheets[0].settings:
        if all(number in one.settings for one in all_sheets):
            one = CheckStep.model_construct(
                check=f"{number:04X}", title=step.title, label=label, timeout_ms=step.timeout_ms
            )
            yield one.in_place_of(step)
            label = None


def varying(sequences: Row[Sequence], all_sheets: Row[Sheet]) -> tuple[int, ...]:
    """The ComNos that are compared with another value here than there, in their order.

    Raises DiagnosticError FB1107 where a sheet does not say what a parameter is to be.
    """
    found: dict[int, None] = {}
    for sequence in sequences:
        for number in _compared(sequence, all_sheets):
            of_plant = all_sheets[0].settings[number].plant
            if not of_plant and len({sheet.word(number) for sheet in all_sheets}) > 1:
                found[number] = None
    return tuple(sorted(found))


def _compared(sequence: Sequence, all_sheets: Row[Sheet]) -> Iterator[int]:
    for sheet in all_sheets:
        for step in spelled_out(sequence, sheet, all_sheets).steps:
            if not isinstance(step, CheckStep) or step.equals is not None:
                continue
            comno = sheet.series.comno(step.check)
            if comno.number not in sheet.settings:
                raise error(
                    "FB1107",
                    f"the parameter sheet of the drives of '{sheet.unit.name}' does not say what "
                    f"{comno.hex} '{comno.name}' is to be",
                    step.span_of("check"),
                    "say it with equals:, or use check_settings: all",
                )
            yield comno.number


def handed_over(
    numbers: Row[int], all_sheets: Row[Sheet]
) -> dict[tuple[str, str], tuple[SclText, ...]]:
    """What the call of the sequences of a drive hands over, by the names of unit and series."""
    return {
        (sheet.unit.name, sheet.series.id): tuple(
            SclText(
                f"{input_name(number)} := {word(sheet.word(number))}",
                origin(f"parameters of {sheet.unit.name}", sheet.unit),
            )
            for number in numbers
        )
        for sheet in all_sheets
    }


def input_name(number: int) -> str:
    """The input of a sequence block for what a parameter is to be."""
    return f"wanted_{number:04X}"
