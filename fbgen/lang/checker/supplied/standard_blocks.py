"""The function blocks that come with the controller: their variables, in the order of a call.

Sources: IEC 61131-3 third edition, tables 43 to 46; TIA Portal help, "IEC timers", "IEC counters".
TIA's TONR has no counterpart in the standard. Names in `ALIASES` are the same block.
"""

from fbgen.lang.checked import StandardBlock, Variable, VariableKind
from fbgen.lang.types import (
    BOOL,
    DINT,
    INT,
    LINT,
    LTIME,
    SINT,
    TIME,
    UDINT,
    UINT,
    ULINT,
    USINT,
    Elementary,
)
from fbgen.source import Source, Span

_NOWHERE = Span(Source("standard blocks", ""), 0, 0)


def _block(
    name: str, inputs: dict[str, Elementary], outputs: dict[str, Elementary]
) -> StandardBlock:
    variables = [
        Variable(_NOWHERE, variable, VariableKind.INPUT, kind) for variable, kind in inputs.items()
    ]
    variables += [
        Variable(_NOWHERE, variable, VariableKind.OUTPUT, kind)
        for variable, kind in outputs.items()
    ]
    return StandardBlock(name, tuple(variables))


def _timers() -> list[StandardBlock]:
    blocks = []
    for suffix, kind in (("", TIME), ("_LTIME", LTIME)):
        for name in ("TON", "TOF", "TP"):
            blocks.append(_block(name + suffix, {"IN": BOOL, "PT": kind}, {"Q": BOOL, "ET": kind}))
        blocks.append(
            _block(f"TONR{suffix}", {"IN": BOOL, "R": BOOL, "PT": kind}, {"Q": BOOL, "ET": kind})
        )
        name = "IEC_LTIMER" if suffix else "IEC_TIMER"
        blocks.append(_block(name, {"IN": BOOL, "PT": kind}, {"Q": BOOL, "ET": kind}))
    return blocks


def _counters() -> list[StandardBlock]:
    blocks = []
    kinds = (INT, SINT, DINT, LINT, USINT, UINT, UDINT, ULINT)
    for kind in kinds:
        suffix = "" if kind == INT else f"_{kind.name}"
        count = {"Q": BOOL, "CV": kind}
        blocks.append(_block(f"CTU{suffix}", {"CU": BOOL, "R": BOOL, "PV": kind}, count))
        blocks.append(_block(f"CTD{suffix}", {"CD": BOOL, "LD": BOOL, "PV": kind}, count))
        blocks.append(
            _block(
                f"CTUD{suffix}",
                {"CU": BOOL, "CD": BOOL, "R": BOOL, "LD": BOOL, "PV": kind},
                {"QU": BOOL, "QD": BOOL, "CV": kind},
            )
        )
    return blocks


STANDARD_BLOCKS: dict[str, StandardBlock] = {
    block.name.casefold(): block
    for block in (
        *_timers(),
        *_counters(),
        _block("R_TRIG", {"CLK": BOOL}, {"Q": BOOL}),
        _block("F_TRIG", {"CLK": BOOL}, {"Q": BOOL}),
        _block("SR", {"S1": BOOL, "R": BOOL}, {"Q1": BOOL}),
        _block("RS", {"S": BOOL, "R1": BOOL}, {"Q1": BOOL}),
    )
}
"""By casefolded canonical name."""

ALIASES: dict[str, str] = {
    "ton_time": "TON",
    "tof_time": "TOF",
    "tp_time": "TP",
    "tonr_time": "TONR",
    "sfb0": "CTU",
    "sfb1": "CTD",
    "sfb2": "CTUD",
    "sfb3": "TP",
    "sfb4": "TON",
    "sfb5": "TOF",
    "ctu_int": "CTU",
    "ctd_int": "CTD",
    "ctud_int": "CTUD",
    "iec_counter": "CTUD",
    "iec_scounter": "CTUD_SINT",
    "iec_dcounter": "CTUD_DINT",
    "iec_lcounter": "CTUD_LINT",
    "iec_uscounter": "CTUD_USINT",
    "iec_ucounter": "CTUD_UINT",
    "iec_udcounter": "CTUD_UDINT",
    "iec_ulcounter": "CTUD_ULINT",
}
"""Other spellings, casefolded, of canonical names."""

PARAMETER_NAMES = {
    "SR": {"SET1": "S1", "RESET": "R"},
    "RS": {"SET": "S", "RESET1": "R1"},
    "CTU": {"RESET": "R"},
    "CTD": {"LOAD": "LD"},
    "CTUD": {"RESET": "R", "LOAD": "LD"},
}
"""What CODESYS and TwinCAT call the parameters of standard blocks."""

TIMER_METHODS = ("TON", "TOF", "TP", "TONR")
"""`timer.TON(...)`: how TIA calls an instance of IEC_TIMER or of a timer type."""

ANY_TIMERS = ("IEC_TIMER", "IEC_LTIMER")
"""What can be called as any of the timers, and as nothing else."""

COUNTER_METHODS = {"CTU": "QU", "CTD": "QD", "CTUD": ""}
"""`counter.CTU(...)`: how TIA calls an instance of IEC_COUNTER, which has the memory of a CTUD, and
the output of that which is its Q."""


def parameter_name(block: str, name: str) -> str:
    """The name of a parameter in the standard, for what CODESYS and TwinCAT call it."""
    known = PARAMETER_NAMES.get(block.partition("_")[0], {})
    return known.get(name.upper(), name)


def timer_called(method: str, kind: str) -> str:
    """The timer that `timer.TON(...)` means where the instance has a type of 64 bits or not."""
    block = standard_block(kind)
    assert block is not None
    is_long = any(variable.type == LTIME for variable in block.variables)
    return f"{method}_LTIME" if is_long else method


def standard_block(name: str) -> StandardBlock | None:
    """The standard block with that name, whatever its case and spelling."""
    key = name.casefold()
    return STANDARD_BLOCKS.get(ALIASES.get(key, key).casefold())
