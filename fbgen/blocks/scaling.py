"""How words of the drives are counted: the functions between words, Hz and percent."""

from collections.abc import Iterator

from fbgen.blocks.literals import SclText, one_line
from fbgen.blocks.texts import Texts
from fbgen.catalog import Catalog, ComNo, Drive, origin
from fbgen.diagnostics import Diagnostic
from fbgen.plant import Plant


def scaling(drive: Drive, texts: Texts) -> dict[str, object]:
    """Factors and comments of TOS_HzToWord, TOS_WordToHz and TOS_WordToPercent."""
    setpoint = drive.comno(drive.link.setpoint)
    current = drive.comno(drive.link.output_current)
    frequency_origin = origin(f"ComNo {setpoint.hex}", setpoint, setpoint.source or "")
    return {
        "frequency_factor": SclText(f"{round(1 / setpoint.resolution, 6)}", frequency_origin),
        "frequency_largest": SclText(f"{0xFFFF * setpoint.resolution:.2f}", frequency_origin),
        "frequency_comment": SclText(
            one_line(_one_count(setpoint, texts)),
            frequency_origin,
        ),
        "percent_factor": SclText(
            f"{round(1 / current.resolution, 6)}", origin(f"ComNo {current.hex}", current)
        ),
        "percent_comment": SclText(
            one_line(_one_count(current, texts)),
            origin(f"ComNo {current.hex}", current),
        ),
    }


def _one_count(number: ComNo, texts: Texts) -> str:
    return texts(
        "One count is {size} {unit} (ComNo {number})",
        size=number.resolution,
        unit=number.unit,
        number=number.hex,
    )


def other_counts(plant: Plant, catalog: Catalog) -> Iterator[Diagnostic]:
    """FB5013: series whose words count otherwise than those of the first drive."""
    first, *others = dict.fromkeys(drive.series for drive in plant.drives)
    known = _counts(catalog.drive(first))
    for name in others:
        if _counts(catalog.drive(name)) != known:
            yield Diagnostic(
                "FB5013",
                f"the series '{name}' counts frequency or current in other units than '{first}'",
                next(drive.span_of("series") for drive in plant.drives if drive.series == name),
                "make a plant file of its own for each of them",
            )


def _counts(drive: Drive) -> tuple[float, float]:
    numbers = (drive.comno(drive.link.setpoint), drive.comno(drive.link.output_current))
    return numbers[0].resolution, numbers[1].resolution
