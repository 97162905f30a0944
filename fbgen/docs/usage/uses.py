"""Every use of a bit or a communication number in a checked program, with its line.

Values of the catalogue carry marks through the generated text (`fbgen.emit.origin_map`). Sources of
the user's own have none: there a literal counts where the place beside it holds a word or a number.
"""

from collections.abc import Sequence

from fbgen.catalog import Catalog
from fbgen.dataclass import dataclass
from fbgen.docs.program import PlantProgram
from fbgen.docs.usage.catalogue_items import BitItem, CatalogueItems, ComNoItem, Item
from fbgen.docs.usage.places import BITWISE, Places, children, inside, operands
from fbgen.docs.usage.words import WordPlaces
from fbgen.lang.checked import (
    Assignment,
    Binary,
    Block,
    Case,
    Constant,
    Expression,
    For,
    FunctionCall,
    If,
    InstanceCall,
    Repeat,
    SliceRef,
    Unary,
    While,
)
from fbgen.source import Span

READS, SETS, CLEARS, TOGGLES, WRITES = "reads", "sets", "clears", "toggles", "writes"
SENDS_READ, SENDS_WRITE, NAMES, COMPARES = "reads", "writes", "names", "compares"
CHANGES = frozenset((SETS, CLEARS, TOGGLES, WRITES))
_BY_OPERATOR = {"OR": SETS, "XOR": TOGGLES, "AND": CLEARS}
_COMPARISONS = frozenset(("=", "<>", "<", ">", "<=", ">="))


@dataclass(frozen=True, slots=True)
class Use:
    """One use: what is done to it, by which block, in which line of which file.

    `own`: a source of the user's, not a generated one.
    """

    item: Item
    does: str
    block: str
    file: str
    line: int
    own: bool


@dataclass(frozen=True, slots=True)
class Unnamed:
    """A place where bits of a word are set from a value that the program works out."""

    device: str
    word: str
    block: str
    file: str
    line: int


class UseFinder:
    """Goes through a program once."""

    def __init__(self, program: PlantProgram, catalog: Catalog, items: CatalogueItems) -> None:
        self._program, self._catalog, self._items = program, catalog, items
        self._series = sorted(program.devices & set(catalog.drives))
        self._words = WordPlaces(program.program, Places(program.program), self.named)
        self._block: Block | None = None
        self._found: dict[Use, None] = {}
        self._unnamed: dict[Unnamed, None] = {}
        self._writes: list[bool | None] = [None]
        self._carried: list[tuple[str, str] | None] = [None]

    def find(self) -> tuple[list[Use], list[Unnamed]]:
        """All uses, in the order of files and lines."""
        for block, body in self._program.program.bodies.items():
            self._block = block
            self._body(body)
        uses = sorted(self._found, key=lambda use: (use.own, use.file, use.line))
        return uses, list(self._unnamed)

    def named(self, value: Constant) -> tuple[Item, ...]:
        """What a value of the catalogue is, told by its mark."""
        file = self._program.files.get(value.span.source.name)
        if file is None or not isinstance(value.value, int) or isinstance(value.value, bool):
            return ()
        line = value.span.line
        if line > len(file.origins):
            return ()
        return self._items.in_line(file.origins[line - 1], value.value, self._program.devices)

    def _body(self, body: Sequence[object]) -> None:
        """Statements of one list: the command of a telegram among them says what is done."""
        commands = (self._command(one) for one in body if isinstance(one, Assignment))
        known = next((one for one in commands if one is not None), self._writes[-1])
        self._writes.append(known)
        self._carried.append(self._carried_word(body) or self._carried[-1])
        for statement in body:
            self._statement(statement)
        self._carried.pop()
        self._writes.pop()

    def _carried_word(self, body: Sequence[object]) -> tuple[str, str] | None:
        """The word that a telegram carries whose number is set in this list of statements."""
        for one in body:
            if isinstance(one, Assignment) and isinstance(value := inside(one.value), Constant):
                for item in self.named(value):
                    if (word := self._items.word_of(item)) is not None:
                        return word
        return None

    def _command(self, statement: Assignment) -> bool | None:
        file = self._program.files.get(statement.span.source.name)
        if file is None or not isinstance(inside(statement.value), Constant):
            return None
        line = statement.span.line
        return self._items.writes(file.origins[line - 1]) if line <= len(file.origins) else None

    def _statement(self, statement: object) -> None:
        if isinstance(statement, Assignment):
            self._assigned(statement.target, statement.value)
        elif isinstance(statement, If):
            for branch in statement.branches:
                self._value(branch.condition)
                self._body(branch.body)
            self._body(statement.otherwise)
        elif isinstance(statement, Case):
            self._value(statement.selector)
            for arm in statement.arms:
                self._body(arm.body)
            self._body(statement.otherwise)
        elif isinstance(statement, For | While | Repeat):
            for part in ("first", "last", "step", "condition"):
                if (value := getattr(statement, part, None)) is not None:
                    self._value(value)
            self._body(statement.body)
        elif isinstance(statement, InstanceCall):
            self._arguments(statement)
        else:
            self._value(statement)

    def _arguments(self, call: InstanceCall | FunctionCall) -> None:
        for _, value in call.inputs:
            if isinstance(inside(value), Constant):
                self._note(value, WRITES)
            else:
                self._value(value)
        for _, place in (*call.in_outs, *call.outputs):
            self._value(place)

    def _assigned(self, target: object, value: Expression) -> None:
        """Bits of a value that is put together bit by bit are set, cleared or written."""
        if isinstance(target, SliceRef):
            self._slice(target, WRITES)
        word = self._words.word(target)
        self._put(value, WRITES, word, target)

    def _put(
        self, value: Expression, does: str, word: tuple[str, str] | None, target: object
    ) -> None:
        plain = inside(value)
        if isinstance(plain, Binary) and plain.operator in BITWISE:
            mask = next((one for one in operands(plain) if isinstance(inside(one), Constant)), None)
            if plain.operator == "AND":
                self._masked(plain, mask, word)
                return
            for one in operands(plain):
                self._put(one, _BY_OPERATOR[plain.operator], word, target)
        elif isinstance(plain, Constant):
            self._note(plain, does, word, self._words.is_number(target))
        elif isinstance(plain, Unary) and plain.operator == "NOT":
            self._put(plain.operand, does, word, target)
        else:
            self._value(plain)
            unnamed = does != WRITES and self._words.word(plain) is None
            if word is not None and unnamed and self._items.words[word].written_by == "plc":
                place = plain.span if hasattr(plain, "span") else value.span
                block, file, line = self._where(place)
                self._unnamed[Unnamed(*word, block, file, line)] = None

    def _masked(self, value: Binary, mask: Expression | None, word: tuple[str, str] | None) -> None:
        """`x AND mask`: a mask without the bits clears them, one with them takes them out."""
        for one in operands(value):
            if one is not mask:
                self._value(one)
        if mask is None:
            return
        constant = inside(mask)
        assert isinstance(constant, Constant)
        if word is not None and self._keeps(constant):
            self._note(constant, CLEARS, word)
        else:
            others = (self._words.word(inside(one)) for one in operands(value) if one is not mask)
            self._note(constant, READS, next(others, None))

    def _keeps(self, mask: Constant) -> bool:
        """Whether a mask has the bits that it names as zeros."""
        assert isinstance(mask.value, int)
        ones = 0
        for item in self.named(mask):
            if isinstance(item, BitItem):
                ones |= self._items.words[item.device, item.word].field(item.bit).mask
        return bool(ones) and mask.value & ones == 0

    def _value(self, root: object) -> None:
        """An expression whose value is used: what is in it is read."""
        waiting = [root]
        while waiting:
            node = waiting.pop()
            if isinstance(node, FunctionCall):
                self._arguments(node)
            elif isinstance(node, Binary):
                self._binary(node, waiting)
            elif isinstance(node, SliceRef):
                self._slice(node, READS)
            elif isinstance(node, Constant):
                self._note(node, READS)
            else:
                waiting += children(node)

    def _binary(self, node: Binary, waiting: list[object]) -> None:
        compares = node.operator in _COMPARISONS
        for one, other in ((node.left, node.right), (node.right, node.left)):
            plain = inside(one)
            if isinstance(plain, Constant):
                beside = inside(other)
                does = COMPARES if compares and self._words.is_number(beside) else READS
                word = self._words.word(beside)
                self._note(plain, does, word, self._words.is_number(beside))
            else:
                waiting.append(one)

    def _slice(self, node: SliceRef, does: str) -> None:
        word = self._words.word(node.base)
        if word is not None:
            for item in self._items.of_mask(*word, 1 << node.index):
                self._add(item, does, node.span)

    def _note(
        self,
        value: Expression,
        does: str,
        word: tuple[str, str] | None = None,
        number: bool = False,
    ) -> None:
        constant = inside(value)
        if not isinstance(constant, Constant) or isinstance(constant.value, bool):
            return
        items = self.named(constant)
        if not items and isinstance(constant.value, int):
            bare = self._is_own(constant.span) or (word is not None and word == self._carried[-1])
            if not bare:
                return
            if word is not None and constant.value:
                items = self._items.of_mask(*word, constant.value)
            elif number:
                items = tuple(self._items.of_number(self._series, constant.value, self._catalog))
        for item in items:
            self._add(item, self._done(item, does), constant.span)

    def _done(self, item: Item, does: str) -> str:
        """A number that is sent is read or written as the telegram's command says."""
        if isinstance(item, ComNoItem) and does == WRITES:
            writes = self._writes[-1]
            return NAMES if writes is None else SENDS_WRITE if writes else SENDS_READ
        return does

    def _add(self, item: Item, does: str, span: Span) -> None:
        if isinstance(item, ComNoItem) and item.series not in self._series:
            return
        self._found[Use(item, does, *self._where(span), self._is_own(span))] = None

    def _where(self, span: Span) -> tuple[str, str, int]:
        assert self._block is not None
        return self._block.name, span.source.name, span.line

    def _is_own(self, span: Span) -> bool:
        return span.source.name not in self._program.files
