"""IF and CASE, also with thousands of branches.

Python's compiler nests every ELIF into the one before, so a long chain is written in pieces of
`LONGEST_CHAIN`, with a flag between them. A CASE with many arms finds the number of its arm in a
table, and the arm by halving.
"""

from bisect import bisect_right
from collections.abc import Callable, Sequence
from functools import partial

from fbgen.lang.checked import Branch, Case, CaseArm, If, Statement
from harness.engine.compiled.code import Code
from harness.engine.compiled.evaluation import condition, value
from harness.engine.compiled.procedure import Procedure
from harness.engine.compiled.shortening.intervals import calls_anything, learned
from harness.engine.compiled.watching.probes import Moment, Probed

LONGEST_CHAIN = 40
MOST_ARMS_IN_CHAIN = 8
LARGEST_TABLE = 10_000

WriteBody = Callable[[Procedure, Sequence[Statement], Probed | None], None]


def write_if(procedure: Procedure, node: If, write_body: WriteBody) -> None:
    """IF with any number of ELSIFs."""
    before = procedure.known
    if len(node.branches) <= LONGEST_CHAIN:
        _chain(procedure, node.branches, write_body)
        if _has_otherwise(procedure, node):
            procedure.line("else:")
            _write_knowing(procedure, node.otherwise, node, write_body)
        procedure.known = before
        return
    flag = procedure.temporary()
    procedure.line(f"{flag} = True")
    for start in range(0, len(node.branches), LONGEST_CHAIN):
        procedure.line(f"if {flag}:")
        procedure.listing.indent += 4
        procedure.line(f"{flag} = False")
        _chain(procedure, node.branches[start : start + LONGEST_CHAIN], write_body)
        procedure.known = before
        procedure.line("else:")
        procedure.line(f"    {flag} = True")
        procedure.listing.indent -= 4
    if _has_otherwise(procedure, node):
        procedure.line(f"if {flag}:")
        write_body(procedure, node.otherwise, node)


def _has_otherwise(procedure: Procedure, node: If | Case) -> bool:
    """True if something is to be done where no branch or arm is chosen."""
    return bool(node.otherwise or procedure.probed(node, Moment.INSIDE))


def _chain(procedure: Procedure, branches: Sequence[Branch], write_body: WriteBody) -> None:
    """IF and ELSIFs; `procedure.known` has then what all of them together leave for ELSE."""
    keyword = "if"
    learns = not any(calls_anything(branch.condition) for branch in branches)
    for branch in branches:
        procedure.forget_sites()
        procedure.listing.span = branch.condition.span
        procedure.line(f"{keyword} {condition(procedure, branch.condition)}:")
        known = procedure.known
        if learns:
            procedure.known = learned(branch.condition, True, known)
        _write_knowing(procedure, branch.body, branch, write_body)
        procedure.known = learned(branch.condition, False, known) if learns else known
        keyword = "elif"


def _write_knowing(
    procedure: Procedure,
    body: Sequence[Statement],
    owner: Branch | If,
    write_body: WriteBody,
) -> None:
    """A branch in which only that is known which nobody else can change."""
    context, known = procedure.context, procedure.known
    if known:
        private = context.facts.private(set(known), context.block, body)
        procedure.known = {one: known[one] for one in known if one in private}
    write_body(procedure, body, owner)
    procedure.known = known


def write_case(procedure: Procedure, node: Case, write_body: WriteBody) -> None:
    """CASE with any number of arms."""
    procedure.listing.span = node.selector.span
    selector = value(procedure, node.selector)
    if not node.arms:
        procedure.line(selector.text)
        procedure.listing.span = node.span
        if _has_otherwise(procedure, node):
            procedure.line("if True:")
            write_body(procedure, node.otherwise, node)
        return
    if len(node.arms) <= MOST_ARMS_IN_CHAIN:
        _few_arms(procedure, node, selector, write_body)
        return
    name = procedure.temporary()
    procedure.line(f"{name} = {_arm_number(procedure, node, selector)}")
    bodies: list[tuple[Sequence[Statement], Probed]] = [(arm.body, arm) for arm in node.arms]
    bodies.append((node.otherwise, node))
    _halve(procedure, name, bodies, 0, write_body)


def _few_arms(procedure: Procedure, node: Case, selector: Code, write_body: WriteBody) -> None:
    name = selector.text
    if not selector.simple:
        name = procedure.temporary()
        procedure.line(f"{name} = {selector.text}")
    keyword = "if"
    for arm in node.arms:
        procedure.listing.span = arm.span
        procedure.line(f"{keyword} {arm_condition(name, arm)}:")
        write_body(procedure, arm.body, arm)
        keyword = "elif"
    if _has_otherwise(procedure, node):
        procedure.line("else:")
        write_body(procedure, node.otherwise, node)


def arm_condition(name: str, arm: CaseArm) -> str:
    """The condition under which a selector that `name` holds chooses the arm."""
    singles = [first for first, last in arm.ranges if first == last]
    tests = [f"{first} <= {name} <= {last}" for first, last in arm.ranges if first != last]
    if len(singles) == 1:
        tests.insert(0, f"{name} == {singles[0]}")
    elif singles:
        tests.insert(0, f"{name} in {tuple(singles)}")
    return " or ".join(tests)


def _arm_number(procedure: Procedure, node: Case, selector: Code) -> str:
    """The Python text that gives the number of the arm, the last one for ELSE."""
    ranges = sorted(
        (first, last, number) for number, arm in enumerate(node.arms) for first, last in arm.ranges
    )
    otherwise = len(node.arms)
    if sum(last - first + 1 for first, last, _ in ranges) <= LARGEST_TABLE:
        arms = {
            content: number for first, last, number in ranges for content in range(first, last + 1)
        }
        table = procedure.context.table("arms", arms)
        return f"{table}.get({selector.text}, {otherwise})"
    search = partial(_arm, [first for first, _, _ in ranges], ranges, otherwise)
    return f"{procedure.context.table('arms', search)}({selector.text})"


def _arm(
    starts: list[int], ranges: list[tuple[int, int, int]], otherwise: int, content: int
) -> int:
    """The number of the arm for a value. No closure: programs are kept."""
    position = bisect_right(starts, content) - 1
    if position >= 0 and content <= ranges[position][1]:
        return ranges[position][2]
    return otherwise


def _halve(
    procedure: Procedure,
    name: str,
    bodies: list[tuple[Sequence[Statement], Probed]],
    first: int,
    write_body: WriteBody,
) -> None:
    """Statements that find one of the bodies, which are numbered from `first` on, by halving."""
    if len(bodies) == 1:
        body, owner = bodies[0]
        procedure.listing.indent -= 4
        write_body(procedure, body, owner)
        procedure.listing.indent += 4
        return
    middle = len(bodies) // 2
    procedure.line(f"if {name} < {first + middle}:")
    procedure.listing.indent += 4
    _halve(procedure, name, bodies[:middle], first, write_body)
    procedure.listing.indent -= 4
    procedure.line("else:")
    procedure.listing.indent += 4
    _halve(procedure, name, bodies[middle:], first + middle, write_body)
    procedure.listing.indent -= 4
