"""What there is to be reached in a file of PLC text: statements, branches, decisions, by block.

All of it is plain data that says where it stands in the text, so it outlives the program and can be
kept in a file. Counts are kept apart from it (`counts`).
"""

from typing import NamedTuple

from harness.engine.compiled.expressions.decisions import Tree


class Place(NamedTuple):
    """A piece of the text: lines and columns from 1, the end is the first character behind it."""

    line: int
    column: int
    end_line: int
    end_column: int


class Outcome(NamedTuple):
    """One way on from a branching. `excluded` says why it cannot be taken; "" if it can."""

    name: str
    place: Place
    excluded: str = ""


class Branching(NamedTuple):
    """IF, CASE, FOR, WHILE or REPEAT with the ways on from it."""

    kind: str
    place: Place
    outcomes: tuple[Outcome, ...]


class ConditionPlace(NamedTuple):
    """A condition of a decision. `excluded` says why it can never decide alone; "" if it can."""

    text: str
    place: Place
    excluded: str = ""


class DecisionPlace(NamedTuple):
    """A BOOL expression of at least two conditions; `tree` says how they are joined."""

    text: str
    place: Place
    tree: Tree
    conditions: tuple[ConditionPlace, ...]


class TemplateKeys(NamedTuple):
    """What a generated block is made from, and what its parts are called in any of its texts.

    `keys` are those of the statements, the outcomes and the conditions, in this order. Texts that
    were generated from one template have the same key for the same thing (`kinship`). A text that a
    person wrote has no `template` and no keys.
    """

    template: str = ""
    statements: tuple[str, ...] = ()
    outcomes: tuple[str, ...] = ()
    conditions: tuple[str, ...] = ()


class BlockPlaces(NamedTuple):
    """What there is in a block, in the order of the text."""

    name: str
    kind: str
    place: Place
    statements: tuple[Place, ...]
    branchings: tuple[Branching, ...]
    decisions: tuple[DecisionPlace, ...]
    made_from: TemplateKeys = TemplateKeys()


class FileKey(NamedTuple):
    """Files are the same if all of this is the same."""

    name: str
    dialect: str
    text: str
