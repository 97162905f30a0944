"""CONFIGURATION, RESOURCE, TASK and program instances.

Source: IEC 61131-3, configuration elements.
"""

from fbgen.lang.ast import (
    Configuration,
    ProgramInstance,
    Resource,
    Task,
    VarSection,
)
from fbgen.lang.dialects.dialect import Feature
from fbgen.lang.parser.declarations import SECTIONS
from fbgen.lang.parser.statements import StatementParser
from fbgen.lang.parser.unread import UNREAD_SECTIONS


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
            elif kind == "PROGRAM" or (kind == "name" and self.texts[self.at].upper() == "TASK"):
                resources.append(self._single_resource())
            elif kind == ";":
                self.at += 1
            else:
                break
        if self.texts[self.at].upper() in UNREAD_SECTIONS:
            raise self.unread(self.texts[self.at].upper(), self.token_span(self.at), "leave it out")
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
        sections, tasks, programs = self._contents()
        closing = self.take_leading()
        self._close("END_RESOURCE", first, "TASK, PROGRAM or END_RESOURCE")
        return Resource(self.span(first), name, on, sections, tasks, programs, leading, closing)

    def _single_resource(self) -> Resource:
        """Tasks and programs that stand in the configuration itself."""
        first = self.at
        _, tasks, programs = self._contents(frozenset())
        return Resource(self.span(first), "", "", (), tasks, programs)

    def _contents(
        self, section_words: frozenset[str] = SECTIONS
    ) -> tuple[tuple[VarSection, ...], tuple[Task, ...], tuple[ProgramInstance, ...]]:
        sections: list[VarSection] = []
        tasks: list[Task] = []
        programs: list[ProgramInstance] = []
        while True:
            kind = self.kinds[self.at]
            if kind in section_words:
                sections.append(self.section())
            elif kind == "PROGRAM":
                programs.append(self._program_instance())
            elif kind == "name" and self.texts[self.at].upper() == "TASK":
                tasks.append(self._task())
            elif kind == ";":
                self.at += 1
            else:
                return tuple(sections), tuple(tasks), tuple(programs)

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
        qualifiers: tuple[str, ...] = ()
        retained = self.texts[self.at].upper()
        if retained in ("RETAIN", "NON_RETAIN") and self.word(self.at + 1):
            qualifiers = (retained,)
            self.at += 1
        name = self.name().name
        task = self.name().name if self.accept_word("WITH") else ""
        self.expect(":", "':'", "write PROGRAM instance WITH task : type;")
        kind = self.named_type()
        arguments = self.arguments() if self.accept("(") else ()
        if not self.accept(";"):
            self.missing_semicolon("the program instance")
        place = self.span(first)
        leading, trailing = self.settle(leading)
        return ProgramInstance(place, name, task, kind, leading, trailing, arguments, qualifiers)
