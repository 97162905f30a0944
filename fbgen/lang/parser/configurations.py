"""CONFIGURATION, RESOURCE, TASK and program instances.

Source: IEC 61131-3, configuration elements.
"""

from fbgen.lang.ast import (
    Configuration,
    NamedType,
    ProgramInstance,
    Resource,
    Task,
    VarSection,
)
from fbgen.lang.dialects.dialect import Feature
from fbgen.lang.parser.declarations import SECTIONS
from fbgen.lang.parser.statements import StatementParser


class ConfigurationParser(StatementParser):
    """Reads configurations."""

    def configuration(self) -> Configuration:
        """CONFIGURATION ... END_CONFIGURATION."""
        leading = self.take_leading()
        first = self.at
        self.at += 1
        self.need(Feature.CONFIGURATIONS, first)
        name = self.name().name
        sections: list[VarSection] = []
        resources: list[Resource] = []
        while True:
            kind = self.kinds[self.at]
            if kind in SECTIONS:
                sections.append(self.section())
            elif kind == "RESOURCE":
                resources.append(self._resource())
            elif kind == ";":
                self.at += 1
            else:
                break
        closing = self.take_leading()
        self._close("END_CONFIGURATION", first, "VAR_GLOBAL, RESOURCE or END_CONFIGURATION")
        return Configuration(
            self.span(first), name, tuple(sections), tuple(resources), leading, closing
        )

    def _close(self, end: str, first: int, expected: str) -> None:
        if self.kinds[self.at] == "end":
            self.missing_end(end, first)
            return
        self.expect(end, expected)
        self.accept(";")

    def _resource(self) -> Resource:
        leading = self.take_leading()
        first = self.at
        self.at += 1
        name = self.name().name
        if not self.accept_word("ON"):
            raise self.failed("ON", "write RESOURCE name ON type")
        on = self.name().name
        sections: list[VarSection] = []
        tasks: list[Task] = []
        programs: list[ProgramInstance] = []
        while True:
            kind = self.kinds[self.at]
            if kind in SECTIONS:
                sections.append(self.section())
            elif kind == "PROGRAM":
                programs.append(self._program_instance())
            elif kind == "name" and self.texts[self.at].upper() == "TASK":
                tasks.append(self._task())
            elif kind == ";":
                self.at += 1
            else:
                break
        closing = self.take_leading()
        self._close("END_RESOURCE", first, "TASK, PROGRAM or END_RESOURCE")
        return Resource(
            self.span(first),
            name,
            on,
            tuple(sections),
            tuple(tasks),
            tuple(programs),
            leading,
            closing,
        )

    def _task(self) -> Task:
        leading = self.take_leading()
        first = self.at
        self.at += 1
        name = self.name().name
        self.expect("(", "'('", "write TASK name(INTERVAL := T#10ms, PRIORITY := 0);")
        properties = self.arguments()
        if not self.accept(";"):
            self.missing_semicolon("the task")
        place = self.span(first)
        leading, trailing = self.settle(leading)
        return Task(place, name, properties, leading, trailing)

    def _program_instance(self) -> ProgramInstance:
        leading = self.take_leading()
        first = self.at
        self.at += 1
        name = self.name().name
        task = self.name().name if self.accept_word("WITH") else ""
        self.expect(":", "':'", "write PROGRAM instance WITH task : type;")
        at = self.at
        type_name = self.name()
        if self.kinds[self.at] == "(":
            raise self.unread(
                "a program instance with connections", self.token_span(at), "use VAR_GLOBAL"
            )
        if not self.accept(";"):
            self.missing_semicolon("the program instance")
        place = self.span(first)
        leading, trailing = self.settle(leading)
        kind = NamedType(type_name.span, type_name.name, type_name.quoted)
        return ProgramInstance(place, name, task, kind, leading, trailing)
