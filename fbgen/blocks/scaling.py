"""How words of the drives are counted: the functions between words, Hz and percent."""

from fbgen.blocks.literals import SclText, one_line
from fbgen.blocks.texts import Texts
from fbgen.catalog import ComNo, Drive, origin


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
