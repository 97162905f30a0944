"""The reference page of the instructions, made from the tables that the checker works with."""

from fbgen.lang.checker.supplied.instruction_list import CATEGORIES, Treatment, treatment_of
from fbgen.lang.checker.supplied.refused_instructions import NOT_SUPPORTED, WRITTEN_OTHERWISE
from fbgen.lang.checker.supplied.routines.hardware import HARDWARE_ALIASES
from fbgen.lang.checker.supplied.routines.hardware_blocks import BLOCK_ALIASES
from fbgen.lang.families import Cpu
from fbgen.lang.instruction_families import MISSING_INSTRUCTIONS

_HEAD = """\
# Instructions

What becomes of the instructions of the S7 CPUs in a program that fbgen reads. This page is made
from the tables of the checker by `python tools/instruction_index.py`.

* **runs**: both engines carry it out; [semantics.md](semantics.md) says where controllers disagree.
* **runs in a plant**: it needs the PROFIBUS of a plant file, or its communication module; a stub
  may stand for it too.
* **stub**: it works on what the simulated controller does not have. Calls are checked, with the
  warning FB4140; what they do [you say](../how-to/stub-a-block.md). Function blocks have the inputs
  and outputs of the controller, so that `inst.REQ` can be set and `inst.DONE` read; functions take
  parameters of any name.
* **FB4141**: read and checked, with a warning; the program does not run.
* **written otherwise**: refused, with what to write instead.

The last column has the CPU families that lack an instruction (`fbgen check --cpu`); where it is
empty every family has it, or it is not certain.
"""
_TABLE = "\n| instruction | number | here | lacking on |\n|---|---|---|---|\n"
_NUMBERS = {
    **{name: number for number, name in HARDWARE_ALIASES.items()},
    **{name: number for number, name in BLOCK_ALIASES.items()},
    "BLKMOV": "SFC20",
    "FILL": "SFC21",
    "UBLKMOV": "SFC81",
    "DPNRM_DG": "SFC13",
    "DPRD_DAT": "SFC14",
    "DPWR_DAT": "SFC15",
    "SET_CLK": "SFC0",
    "READ_CLK": "SFC1",
    "RE_TRIGR": "SFC43",
    "STP": "SFC46",
    "TIME_TCK": "SFC64",
    "CTU": "SFB0",
    "CTD": "SFB1",
    "CTUD": "SFB2",
    "TP": "SFB3",
    "TON": "SFB4",
    "TOF": "SFB5",
}


def page() -> str:
    """The text of the page."""
    text = _HEAD
    for category, names in CATEGORIES.items():
        rows = "".join(map(_row, names))
        text += f"\n## {category}\n{_TABLE}{rows}"
    return text


def _row(name: str) -> str:
    key = name.upper()
    treatment = treatment_of(name)
    assert treatment is not None, name
    said = treatment.value
    if treatment is Treatment.REFUSED:
        said = f"FB4141: {NOT_SUPPORTED[key]}"
    elif treatment is Treatment.WRITTEN:
        said = f"written otherwise: {WRITTEN_OTHERWISE[key]}"
    lacking = [cpu.value for cpu in Cpu if key in MISSING_INSTRUCTIONS[cpu]]
    return f"| `{name}` | {_NUMBERS.get(key, '')} | {said} | {', '.join(lacking)} |\n"
