"""Statements, each with the comments around it."""

from typing import TypeAlias

from fbgen.lang.ast.expressions import Call, Expression
from fbgen.lang.ast.node import Trivia, TriviaList, node
from fbgen.source import Span


@node
class Assignment:
    """`target := value;` `operator` is ":=", "+=", "-=", "*=", "/=", "?=" (VARIANT to a variable),
    "S=", "R=" (set and reset of CODESYS) or "REF=" (binds a reference).
    """

    span: Span
    target: Expression
    operator: str
    value: Expression
    leading: TriviaList = ()
    trailing: Trivia | None = None


@node
class CallStatement:
    """A call that stands alone."""

    span: Span
    call: Call
    leading: TriviaList = ()
    trailing: Trivia | None = None


@node
class Branch:
    """A condition with its statements: IF ... THEN or ELSIF ... THEN."""

    span: Span
    condition: Expression
    body: tuple["Statement", ...]
    leading: TriviaList = ()
    trailing: Trivia | None = None
    closing: TriviaList = ()


@node
class ElseBranch:
    """The statements behind ELSE, of IF or CASE."""

    span: Span
    body: tuple["Statement", ...]
    leading: TriviaList = ()
    trailing: Trivia | None = None
    closing: TriviaList = ()


@node
class If:
    """IF with its ELSIFs; `trailing` is behind END_IF."""

    span: Span
    branches: tuple[Branch, ...]
    otherwise: ElseBranch | None
    leading: TriviaList = ()
    trailing: Trivia | None = None


@node
class LabelRange:
    """`1..5` as a CASE label."""

    span: Span
    first: Expression
    last: Expression


@node
class CaseArm:
    """`1, 3..5: statements`."""

    span: Span
    labels: tuple[Expression | LabelRange, ...]
    body: tuple["Statement", ...]
    leading: TriviaList = ()
    trailing: Trivia | None = None
    closing: TriviaList = ()


@node
class Case:
    """CASE ... END_CASE; `opening` is behind OF."""

    span: Span
    selector: Expression
    arms: tuple[CaseArm, ...]
    otherwise: ElseBranch | None
    leading: TriviaList = ()
    trailing: Trivia | None = None
    opening: Trivia | None = None


@node
class For:
    """FOR variable := first TO last BY step DO body END_FOR."""

    span: Span
    variable: Expression
    first: Expression
    last: Expression
    step: Expression | None
    body: tuple["Statement", ...]
    leading: TriviaList = ()
    opening: Trivia | None = None
    closing: TriviaList = ()
    trailing: Trivia | None = None


@node
class While:
    """WHILE condition DO body END_WHILE."""

    span: Span
    condition: Expression
    body: tuple["Statement", ...]
    leading: TriviaList = ()
    opening: Trivia | None = None
    closing: TriviaList = ()
    trailing: Trivia | None = None


@node
class Repeat:
    """REPEAT body UNTIL condition END_REPEAT."""

    span: Span
    body: tuple["Statement", ...]
    condition: Expression
    leading: TriviaList = ()
    opening: Trivia | None = None
    closing: TriviaList = ()
    trailing: Trivia | None = None


@node
class Catch:
    """`__CATCH(exc)` with its statements; `exception` is the variable that takes the code."""

    span: Span
    exception: Expression | None
    body: tuple["Statement", ...]
    leading: TriviaList = ()
    trailing: Trivia | None = None
    closing: TriviaList = ()


@node
class Try:
    """__TRY body __CATCH(exc) ... __FINALLY ... __ENDTRY of CODESYS and TwinCAT."""

    span: Span
    body: tuple["Statement", ...]
    catch: Catch | None
    final: ElseBranch | None
    leading: TriviaList = ()
    opening: Trivia | None = None
    closing: TriviaList = ()
    trailing: Trivia | None = None


@node
class Region:
    """REGION title ... END_REGION; both lines are free text to their end (TIA only)."""

    span: Span
    title: str
    body: tuple["Statement", ...]
    end_text: str = ""
    leading: TriviaList = ()
    closing: TriviaList = ()


@node
class Jump:
    """EXIT, CONTINUE or RETURN; `keyword` is upper case."""

    span: Span
    keyword: str
    leading: TriviaList = ()
    trailing: Trivia | None = None


@node
class Goto:
    """GOTO label."""

    span: Span
    label: str
    leading: TriviaList = ()
    trailing: Trivia | None = None


@node
class Label:
    """`label:` in front of a statement."""

    span: Span
    name: str
    leading: TriviaList = ()
    trailing: Trivia | None = None


@node
class Empty:
    """A lone semicolon."""

    span: Span
    leading: TriviaList = ()
    trailing: Trivia | None = None


Statement: TypeAlias = (
    Assignment
    | CallStatement
    | If
    | Case
    | For
    | While
    | Repeat
    | Try
    | Region
    | Jump
    | Goto
    | Label
    | Empty
)
