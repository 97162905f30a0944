"""The controller's instructions that work on hardware and on memory: their parameters.

Source: TIA Portal help, "DPRD_DAT" and "DPWR_DAT" (SFC14 and SFC15 on S7-300/400). LADDR is the
start address of the module as WORD (S7-300/400), or its hardware identifier (S7-1200/1500).
"DPNRM_DG" (SFC13): Siemens A5E00709327-01, 16.4; LADDR is the diagnostic address of the slave as
WORD, or the hardware identifier of the slave.
"BLKMOV", "UBLKMOV" and "FILL" (SFC20, SFC81, SFC21), "MOVE_BLK", "FILL_BLK", "POKE_BLK",
"MOVE_BLK_VARIANT", "Serialize", "Deserialize", "READ_LITTLE", "WRITE_BIG" and the like.
"""

from fbgen.dataclass import dataclass
from fbgen.lang.types import (
    ANY,
    BOOL,
    BYTE,
    DINT,
    INT,
    VARIANT,
    VARIANT_VALUE,
    VOID,
    WORD,
    AnyType,
    Elementary,
    ReferenceType,
)


@dataclass(frozen=True, slots=True)
class InstructionParameter:
    """One parameter. An area (VARIANT) is a place of any type; `is_output`: it is written.

    `any_integer`: whole numbers of all types are taken as they are. `either_way`: an in-out, which
    is published with := and with =>. A VARIANT_VALUE arrives as a VARIANT, which may be NULL.
    """

    name: str
    type: Elementary | AnyType | ReferenceType
    is_output: bool = False
    any_integer: bool = False
    either_way: bool = False


@dataclass(frozen=True, slots=True)
class Instruction:
    """An instruction; its result is its RET_VAL, VOID for none.

    `on_memory`: it works on the memory of the program alone, so that every engine has it.
    """

    name: str
    parameters: tuple[InstructionParameter, ...]
    result: Elementary
    on_memory: bool = False


def _number(name: str) -> InstructionParameter:
    return InstructionParameter(name, DINT, any_integer=True)


def _moves(name: str) -> Instruction:
    """What fills takes a value of the type that the elements have (VOID), what moves an element."""
    source = InstructionParameter("IN", VOID if "FILL" in name else VARIANT)
    target = InstructionParameter("OUT", VARIANT, is_output=True)
    return Instruction(name, (source, _number("COUNT"), target), VOID, on_memory=True)


def _copies(name: str) -> Instruction:
    source = InstructionParameter("SRCBLK", ANY)
    target = InstructionParameter("DSTBLK", ANY, is_output=True)
    return Instruction(name, (source, target), INT, on_memory=True)


_FILL = Instruction(
    "FILL",
    (InstructionParameter("BVAL", ANY), InstructionParameter("BLK", ANY, is_output=True)),
    INT,
    on_memory=True,
)
_POKE_BLK = Instruction(
    "POKE_BLK",
    (
        *(InstructionParameter("area_src", BYTE), _number("dbNumber_src")),
        *(_number("byteOffset_src"), InstructionParameter("area_dest", BYTE)),
        *(_number("dbNumber_dest"), _number("byteOffset_dest"), _number("count")),
    ),
    VOID,
    on_memory=True,
)


def _variant(name: str, is_output: bool = False) -> InstructionParameter:
    return InstructionParameter(name, VARIANT_VALUE, is_output=is_output)


def _in_out(name: str) -> InstructionParameter:
    return InstructionParameter(name, VARIANT_VALUE, either_way=True)


_ON_VARIANTS = (
    Instruction(
        "MOVE_BLK_VARIANT",
        (
            *(_variant("SRC"), _number("COUNT"), _number("SRC_INDEX"), _number("DEST_INDEX")),
            _variant("DEST", is_output=True),
        ),
        INT,
        on_memory=True,
    ),
    Instruction(
        "SERIALIZE",
        (_variant("SRC_VARIABLE"), _in_out("DEST_ARRAY"), _in_out("POS")),
        INT,
        on_memory=True,
    ),
    Instruction(
        "DESERIALIZE",
        (_variant("SRC_ARRAY"), _in_out("DEST_VARIABLE"), _in_out("POS")),
        INT,
        on_memory=True,
    ),
    *(
        Instruction(
            f"WRITE_{order}",
            (_variant("SRC_VARIABLE"), _in_out("DEST_ARRAY"), _in_out("POS")),
            INT,
            on_memory=True,
        )
        for order in ("LITTLE", "BIG")
    ),
    *(
        Instruction(
            f"READ_{order}",
            (_variant("SRC_ARRAY"), _in_out("DEST_VARIABLE"), _in_out("POS")),
            INT,
            on_memory=True,
        )
        for order in ("LITTLE", "BIG")
    ),
)
ON_VARIANTS = tuple(instruction.name for instruction in _ON_VARIANTS)
"""They get VARIANTs, ask for the types themselves and say in RET_VAL what does not fit."""
ELEMENT_MOVES = ("MOVE_BLK", "UMOVE_BLK", "FILL_BLK", "UFILL_BLK")
"""They work on elements of arrays from a given one on."""


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
        Instruction(
            "DPNRM_DG",
            (
                *(InstructionParameter("REQ", BOOL), InstructionParameter("LADDR", WORD)),
                InstructionParameter("RECORD", VARIANT, is_output=True),
                InstructionParameter("BUSY", BOOL, is_output=True),
            ),
            INT,
        ),
        *(_moves(name) for name in ELEMENT_MOVES),
        *_ON_VARIANTS,
        *(_copies("BLKMOV"), _copies("UBLKMOV"), _FILL, _POKE_BLK),
    )
}
"""By casefolded canonical name."""

ALIASES = {
    "sfc13": "dpnrm_dg",
    "sfc14": "dprd_dat",
    "sfc15": "dpwr_dat",
    "sfc20": "blkmov",
    "sfc21": "fill",
    "sfc81": "ublkmov",
}
"""Other spellings, casefolded."""


def instruction_named(name: str) -> Instruction | None:
    """The instruction with that name, whatever its case and spelling."""
    key = name.casefold()
    return INSTRUCTIONS.get(ALIASES.get(key, key))
