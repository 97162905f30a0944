"""All statements: here loops and regions, the others are in the modules below.

Source: IEC 61131-3, iteration statements; TIA Portal help, "REGION"; published sources for raw
REGION lines; TwinCAT 3 help, "__TRY, __CATCH, __FINALLY, __ENDTRY".
"""

from fbgen.lang.ast import (
    Catch,
    ElseBranch,
    Expression,
    For,
    Name,
    Region,
    Repeat,
    Statement,
    Try,
    While,
)
from fbgen.lang.parser.branches import BranchParser
from fbgen.lang.parser.cursor import Unexpected
from fbgen.lang.parser.statement_lists import enter


class StatementParser(BranchParser):
    """Reads all statements."""

    def _for(self) -> For:
        leading = self.take_leading()
        first = self.at
        self.at += 1
        variable, start, last, step = self._range()
        leading, opening = self.finish(leading)
        body = self.inside({"END_FOR"}, self.statements)
        closing = self.take_leading()
        self.end("END_FOR", first)
        place = self.span(first)
        trailing = self.take_same_line()
        return For(place, variable, start, last, step, body, leading, opening, closing, trailing)

    def _range(self) -> tuple[Expression, Expression, Expression, Expression | None]:
        """From the variable to DO; what is broken there does not hide what follows."""
        first, depth = self.at, self.depth
        try:
            variable = self.operand()
            self.expect(":=", "':='", "write FOR i := 0 TO 7 DO")
            start = self.expression()
            if self.texts[self.at].upper() == "DOWNTO":
                raise self.failed("TO or an operator", "count down by FOR i := 7 TO 0 BY -1 DO")
            self.expect("TO", "TO or an operator", "write FOR i := 0 TO 7 DO")
            last = self.expression()
            step = self.expression() if self.accept("BY") else None
            self.expect("DO", "DO, BY or an operator", "write FOR i := 0 TO 7 DO")
        except Unexpected:
            self.depth = depth
            self.skip_behind("DO")
            broken = Name(self.span(first), "")
            return broken, broken, broken, None
        return variable, start, last, step

    def _while(self) -> While:
        leading = self.take_leading()
        first = self.at
        self.at += 1
        condition = self.condition("DO", "WHILE condition DO")
        leading, opening = self.finish(leading)
        body = self.inside({"END_WHILE"}, self.statements)
        closing = self.take_leading()
        self.end("END_WHILE", first)
        place = self.span(first)
        trailing = self.take_same_line()
        return While(place, condition, body, leading, opening, closing, trailing)

    def _repeat(self) -> Repeat:
        leading = self.take_leading()
        first = self.at
        self.at += 1
        opening = self.take_same_line()
        body = self.inside({"UNTIL", "END_REPEAT"}, self.statements)
        closing = self.take_leading()
        condition = self._until()
        self.end("END_REPEAT", first)
        place = self.span(first)
        leading, trailing = self.finish(leading)
        return Repeat(place, body, condition, leading, opening, closing, trailing)

    def _until(self) -> Expression:
        """UNTIL and its condition; without it what was repeated is read all the same."""
        start = self.at
        if self.kinds[start] == "END_REPEAT":
            self.unexpected("UNTIL", "write REPEAT ... UNTIL condition END_REPEAT;")
            return Name(self.token_span(start), "")
        self.expect("UNTIL", "UNTIL", "write REPEAT ... UNTIL condition END_REPEAT;")
        condition = self.expression()
        self.accept(";")
        return condition

    def _try(self) -> Try:
        leading = self.take_leading()
        first = self.at
        self.at += 1
        opening = self.take_same_line()
        ends = {"__CATCH", "__FINALLY", "__ENDTRY"}
        body = self.inside(ends, self.statements)
        closing = self.take_leading()
        catch = self._catch() if self.kinds[self.at] == "__CATCH" else None
        final = self._final() if self.kinds[self.at] == "__FINALLY" else None
        if self.accept("__ENDTRY"):
            self.accept(";")
        else:
            self.missing_end("__ENDTRY", first)
        place = self.span(first)
        trailing = self.take_same_line()
        return Try(place, body, catch, final, leading, opening, closing, trailing)

    def _catch(self) -> Catch:
        first = self.at
        self.at += 1
        exception: Expression | None = None
        if self.accept("("):
            if self.kinds[self.at] != ")":
                exception = self.operand()
            self.expect(")", "')'", "write __CATCH(exc), exc is of type __SYSTEM.ExceptionCode")
        trailing = self.take_same_line()
        body = self.inside({"__FINALLY", "__ENDTRY"}, self.statements)
        closing = self.take_leading()
        return Catch(self.span(first), exception, body, (), trailing, closing)

    def _final(self) -> ElseBranch:
        first = self.at
        self.at += 1
        trailing = self.take_same_line()
        body = self.inside({"__ENDTRY"}, self.statements)
        closing = self.take_leading()
        return ElseBranch(self.span(first), body, (), trailing, closing)

    def _region(self) -> Statement:
        if self.kinds[self.at + 1] == ":=":
            self.kinds[self.at] = "name"
            return self.simple()
        leading = self.take_leading()
        first = self.at
        title = self.texts[first].strip()[len("REGION") :].strip()
        self.at += 1
        body = self.inside({"END_REGION"}, self.statements)
        closing = self.take_leading()
        end_text = ""
        if self.kinds[self.at] == "END_REGION":
            end_text = self.texts[self.at][len("END_REGION") :].strip()
            self.at += 1
        else:
            self.missing_end("END_REGION", first)
        return Region(self.span(first), title, body, end_text, leading, closing)


enter(
    {
        "FOR": StatementParser._for,
        "WHILE": StatementParser._while,
        "REPEAT": StatementParser._repeat,
        "REGION": StatementParser._region,
        "__TRY": StatementParser._try,
    }
)
