"""Which organization block of an S7 is which: their numbers, periods and priorities.

A source says only the name. `OB35` has its number in it; the names that TIA Portal gives by itself
are known; any other number has to be told.

Sources: STEP 7 System Software reference, "Organization blocks": numbers, priority classes 7 to 15
and default periods of OB30 to OB38; TIA Portal help, "Organization blocks": default names, 100 ms
for a new cyclic interrupt, further program cycle and start-up blocks from number 123 on; standard
library of STEP 7 V5 for the short names of the error blocks (recalled).
"""

import re
from collections.abc import Mapping
from dataclasses import field

from fbgen.dataclass import dataclass
from fbgen.diagnostics import Diagnostic, DiagnosticError
from fbgen.lang.ast import BlockKind
from fbgen.lang.checked import Program
from harness.kernel import NS_PER_MS

PROGRAM_CYCLE, WARM_RESTART, COLD_RESTART = 1, 100, 102
TIME_ERROR, DIAGNOSIS, PRIORITY_CLASS_ERROR, RACK_FAILURE = 80, 82, 85, 86
PROGRAMMING_ERROR, ACCESS_ERROR = 121, 122
CYCLIC_INTERRUPTS = range(30, 39)

_DEFAULT_NAMES = {
    "main": PROGRAM_CYCLE,
    "startup": WARM_RESTART,
    "cyclic interrupt": 30,
    "time error interrupt": TIME_ERROR,
    "diagnostic error interrupt": DIAGNOSIS,
    "rack or station failure": RACK_FAILURE,
    "programming error": PROGRAMMING_ERROR,
    "io access error": ACCESS_ERROR,
    "i/o_flt1": DIAGNOSIS,
    "obnl_flt": PRIORITY_CLASS_ERROR,
    "rack_flt": RACK_FAILURE,
    "prog_err": PROGRAMMING_ERROR,
    "mod_err": ACCESS_ERROR,
}
_NUMBER = re.compile(r"ob ?([0-9]{1,5})")
_PERIODS_MS = (5_000, 2_000, 1_000, 500, 200, 100, 50, 20, 10)
_TIA_PERIOD_NS = 100 * NS_PER_MS


@dataclass(frozen=True, slots=True)
class Period:
    """How often a cyclic interrupt runs, and how long after its grid."""

    interval_ns: int
    phase_ns: int = 0


@dataclass(frozen=True, slots=True)
class ObSettings:
    """What the project says about organization blocks, by their names or as `OB35`.

    `numbers` has those that the names do not tell, `periods` the cyclic interrupts whose period is
    not the default one. `main_function` runs once a cycle where the files have no OB1,
    `restart_function` once before the first one where they have no OB100.
    """

    numbers: Mapping[str, int] = field(default_factory=dict)
    periods: Mapping[str, Period] = field(default_factory=dict)
    main_function: str = "TOS_Main"
    restart_function: str = "TOS_Restart"


@dataclass(slots=True)
class CyclicInterrupt:
    """A cyclic interrupt: higher priority classes interrupt lower ones. `due_ns`: the next run."""

    block: str
    number: int
    period: Period
    due_ns: int = 0

    @property
    def priority_class(self) -> int:
        """7 for OB30 up to 15 for OB38; OB1 has 1."""
        return self.number - CYCLIC_INTERRUPTS[0] + 7


def organization_blocks(program: Program, settings: ObSettings) -> dict[int, str]:
    """The organization blocks by their numbers. Those whose number nobody knows are left out.

    Raises DiagnosticError: FB7410 for settings of a block that does not exist, FB7411 for two
    blocks with one number.
    """
    blocks = {
        key: block
        for key, block in program.blocks.items()
        if block.kind is BlockKind.ORGANIZATION_BLOCK
    }
    told = {name.casefold(): number for name, number in settings.numbers.items()}
    found = [_unknown(name) for name in settings.numbers if name.casefold() not in blocks]
    numbered: dict[int, str] = {}
    for key, block in blocks.items():
        number = told.get(key, number_in_name(block.name))
        if number is None:
            continue
        if number in numbered:
            found.append(
                Diagnostic(
                    "FB7411",
                    f"'{block.name}' and '{numbered[number]}' are both OB{number}",
                    block.span,
                    "give one of them another number",
                )
            )
        numbered[number] = block.name
    if found:
        raise DiagnosticError(found)
    return dict(sorted(numbered.items()))


def cyclic_interrupts(program: Program, settings: ObSettings) -> list[CyclicInterrupt]:
    """OB30 to OB38 of a program, with their periods. Raises as `organization_blocks`."""
    periods = {name.casefold(): period for name, period in settings.periods.items()}
    interrupts: list[CyclicInterrupt] = []
    for number, name in organization_blocks(program, settings).items():
        if number in CYCLIC_INTERRUPTS:
            by_number = periods.pop(f"ob{number}", None)
            period = periods.pop(name.casefold(), by_number) or _default_period(name, number)
            interrupts.append(CyclicInterrupt(name, number, period))
    if periods:
        raise DiagnosticError(_unknown(name) for name in periods)
    return interrupts


def number_in_name(name: str) -> int | None:
    """The number that the name of an organization block tells."""
    key = name.casefold()
    match = _NUMBER.fullmatch(key)
    return int(match[1]) if match else _DEFAULT_NAMES.get(key)


def _default_period(name: str, number: int) -> Period:
    if name.casefold() in _DEFAULT_NAMES:
        return Period(_TIA_PERIOD_NS)
    return Period(_PERIODS_MS[number - CYCLIC_INTERRUPTS[0]] * NS_PER_MS)


def _unknown(name: str) -> Diagnostic:
    return Diagnostic(
        "FB7410",
        f"there are settings for '{name}', which is no such organization block of the program",
        help="numbers are for organization blocks by their names, periods for OB30 to OB38",
    )
