"""METHOD, PROPERTY and ACTION in files of their own: into the block that their file is named after.

`Pump.Start.st`, `Pump_Start.st` and `Start.st` in a folder `Pump` have members of the block Pump:
so tools write them that keep one file for each object.
Source: published projects of CODESYS and TwinCAT that were exported object by object.
"""

from collections.abc import Sequence
from pathlib import PurePath

from fbgen.lang import ast
from fbgen.lang.checker.findings import Findings
from fbgen.lang.rewriting import replaced


def with_their_members(files: Sequence[ast.File], findings: Findings) -> Sequence[ast.File]:
    """The files, where each block has all of its members; what belongs to none is reported."""
    lone = [unit for file in files for unit in file.units if isinstance(unit, ast.LoneMember)]
    if not lone:
        return files
    blocks = {
        unit.name.name.casefold(): unit
        for file in files
        for unit in file.units
        if isinstance(unit, ast.Block)
    }
    found: dict[ast.Block, list[ast.BlockMember]] = {}
    for one in lone:
        owner = _owner(one, blocks)
        if owner is not None:
            found.setdefault(owner, []).append(one.member)
            continue
        kind = type(one.member).__name__.upper()
        findings.warning(
            "FB4098",
            f"{kind} {one.member.name.name} stands alone, and belongs to no block that is here",
            one.member.name.span,
            f"name the file after its block, such as Pump.{one.member.name.name}.st, check the file"
            " that has the block too, or write it in the block",
        )
    return [
        ast.File(
            file.source,
            file.dialect,
            tuple(
                replaced(unit, members=(*unit.members, *found[unit])) if unit in found else unit
                for unit in file.units
                if not isinstance(unit, ast.LoneMember)
            ),
            file.closing,
        )
        for file in files
    ]


def _owner(one: ast.LoneMember, blocks: dict[str, ast.Block]) -> ast.Block | None:
    path = PurePath(one.span.source.name)
    member = one.member.name.name.casefold()
    stem = path.name.rpartition(".")[0].casefold()
    beginning = stem.partition(member)[0] if member in stem else stem
    names = [stem.rpartition(f".{member}")[0], beginning.rstrip("._- "), stem.partition(".")[0]]
    names.append(path.parent.name.casefold())
    return next((blocks[name] for name in names if name in blocks), None)
