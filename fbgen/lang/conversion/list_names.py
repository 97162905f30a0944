"""`GVL.x` as `x`, for texts: only an object of TwinCAT or an export can say what a list is called.

Where the short name means something else there is no way to say it, and it is refused.
Source: TwinCAT 3 help, "Object GVL".
"""

from collections import Counter
from collections.abc import Mapping, Sequence
from typing import ClassVar

from fbgen.lang.ast import Accessor, Block, Expression, File, Globals, Member, Method, Name
from fbgen.lang.lowering.findings import Findings
from fbgen.lang.rewriting import Rewriter, Rule


def without_list_names(files: Sequence[File], findings: Findings) -> list[File]:
    """The same program, where no list of global variables is named."""
    lists = [unit for file in files for unit in file.units if isinstance(unit, Globals)]
    names = {one.name.casefold() for one in lists if one.name}
    if not names:
        return list(files)
    often = Counter(
        declared.name.casefold()
        for one in lists
        for declaration in one.section.declarations
        for declared in declaration.names
    )
    rewriter = _Shortening(names, often, findings)
    return [
        File(
            file.source,
            file.dialect,
            tuple(
                Globals(unit.span, rewriter.rewrite(unit.section))
                if isinstance(unit, Globals)
                else rewriter.rewrite(unit)
                for unit in file.units
            ),
            file.closing,
        )
        for file in files
    ]


class _Shortening(Rewriter):
    def __init__(self, names: set[str], often: Mapping[str, int], findings: Findings) -> None:
        self._names = names
        self._often = often
        self._findings = findings
        self._own: frozenset[str] = frozenset()

    def _with_variables(self, node: Block | Method | Accessor) -> object:
        around = self._own
        self._own |= {
            declared.name.casefold()
            for section in node.sections
            if section.keyword != "VAR_EXTERNAL"
            for declaration in section.declarations
            for declared in declaration.names
        }
        written = self.inside(node)
        self._own = around
        return written

    def _member(self, node: Member) -> Expression:
        base = node.base
        is_list = isinstance(base, Name) and base.name.casefold() in self._names
        if not is_list or (isinstance(base, Name) and base.name.casefold() in self._own):
            member: Expression = self.inside(node)
            return member
        if node.name.casefold() in self._own or self._often[node.name.casefold()] > 1:
            self._findings.refuse(
                node.span.text,
                node.span,
                "give the variable a name that nothing else has: a text has no names of lists",
            )
        return Name(node.span, node.name)

    rules: ClassVar[Mapping[type, Rule]] = {
        Block: _with_variables,
        Method: _with_variables,
        Accessor: _with_variables,
        Member: _member,
    }
