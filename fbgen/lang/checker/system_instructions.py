"""The controller's instructions that work on hardware: their parameters.

Source: TIA Portal help, "DPRD_DAT" and "DPWR_DAT" (SFC14 and SFC15 on S7-300/400). LADDR is the
start address of the module as WORD (S7-300/400), or its hardware identifier (S7-1200/1500).
"""

from dataclasses import dataclass

from fbgen.lang.types import INT, VARIANT, WORD, AnyType, Elementary


@dataclass(frozen=True, slots=True)
class InstructionParameter:
    """One parameter. An area (VARIANT) is a place of any type; `is_output`: it is written."""

    name: str
    type: Elementary | AnyType
    is_output: bool = False


@dataclass(frozen=True, slots=True)
class Instruction:
    """An instruction; its result is its RET_VAL."""

    name: str
    parameters: tuple[InstructionParameter, ...]
    result: Elementary


RETURN_VALUE = "RET_VAL"
"""The result may also be taken by `RET_VAL => place`, as with S7-300/400."""

INSTRUCTIONS: dict[str, Instruction] = {
    instruction.name.casefold(): instruction
    for instruction in (
        Instruction(
            "DPRD_DAT",
            (
                InstructionParameter("LADDR", WORD),
                InstructionParameter("RECORD", VARIANT, is_output=True),
            ),
            INT,
        ),
        Instruction(
            "DPWR_DAT",
            (InstructionParameter("LADDR", WORD), InstructionParameter("RECORD", VARIANT)),
            INT,
        ),
    )
}
"""By casefolded canonical name."""

ALIASES = {"sfc14": "dprd_dat", "sfc15": "dpwr_dat"}
"""Other spellings, casefolded."""


def instruction_named(name: str) -> Instruction | None:
    """The instruction with that name, whatever its case and spelling."""
    key = name.casefold()
    return INSTRUCTIONS.get(ALIASES.get(key, key))
