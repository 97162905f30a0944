"""The Jinja environment: sandboxed, strict about undefined names, and marking what it renders."""

import re
from collections.abc import Sequence
from functools import lru_cache
from pathlib import Path
from types import CodeType

from jinja2 import (
    ChoiceLoader,
    FileSystemLoader,
    StrictUndefined,
    TemplateError,
    TemplateNotFound,
    TemplateSyntaxError,
    UndefinedError,
)
from jinja2.bccache import Bucket, BytecodeCache
from jinja2.exceptions import SecurityError
from jinja2.ext import Extension

from fbgen.blocks.literals import SclText
from fbgen.blocks.texts import ENGLISH, Texts
from fbgen.diagnostics import DiagnosticError, error
from fbgen.emit.marks import OriginTable, TemplateLines, is_marked, without_marks
from fbgen.emit.sandbox import TemplateSandbox
from fbgen.emit.template_texts import translated
from fbgen.resources import shipped
from fbgen.source import Source, Span

_TAG = re.compile(r"\{#.*?#\}|\{%.*?%\}|\{\{.*?\}\}", re.DOTALL)


class LineMarks(Extension):
    """Puts the mark of its template line in front of each line that is printed."""

    def preprocess(self, source: str, name: str | None, filename: str | None = None) -> str:
        environment = self.environment
        assert isinstance(environment, _Templates)
        assert name is not None
        place = environment.place_of(name)
        source = translated(without_marks(source), environment.texts)
        inside = _places_inside_tags(source)
        lines = source.split("\n")
        start = 0
        for number, line in enumerate(lines, start=1):
            content = line.lstrip()
            at = start + len(line) - len(content)
            if content and at not in inside and not content.startswith(("{%", "{#")):
                indent = line[: len(line) - len(content)]
                lines[number - 1] = f"{indent}{_LINES.mark(place, number)}{content}"
            start += len(line) + 1
        return "\n".join(lines)


def _places_inside_tags(source: str) -> set[int]:
    """The offsets behind the first character of a tag, an expression or a comment of Jinja's."""
    return {offset for tag in _TAG.finditer(source) for offset in range(tag.start() + 1, tag.end())}


_LINES = TemplateLines()
"""The lines of all templates that were compiled: their marks stand in what is kept."""

_MOST_TEMPLATES = 1000


class _Compiled(BytecodeCache):
    """Compiled templates of one language, by file and content, however often somebody generates."""

    def __init__(self) -> None:
        self._kept: dict[tuple[str, str], CodeType | None] = {}

    def load_bytecode(self, bucket: Bucket) -> None:
        bucket.code = self._kept.get((bucket.key, bucket.checksum))

    def dump_bytecode(self, bucket: Bucket) -> None:
        if len(self._kept) >= _MOST_TEMPLATES:
            self._kept.clear()
        self._kept[bucket.key, bucket.checksum] = bucket.code


@lru_cache(maxsize=4)
def _compiled_in(texts: Texts) -> _Compiled:
    return _Compiled()


class _Templates(TemplateSandbox):
    """The templates of some folders in one language, with the table of one run."""

    def __init__(self, folders: Sequence[Path], texts: Texts) -> None:
        super().__init__(
            loader=ChoiceLoader([FileSystemLoader(folder) for folder in folders]),
            undefined=StrictUndefined,
            trim_blocks=True,
            lstrip_blocks=True,
            keep_trailing_newline=True,
            finalize=self._finalize,
            bytecode_cache=_compiled_in(texts),
        )
        self.folders = folders
        self.texts = texts
        self.table = OriginTable(_LINES)
        self.add_extension(LineMarks)

    def place_of(self, template: str) -> str:
        """Where a template lies, for a person: the user's own by its path."""
        for folder in self.folders[:-1]:
            if (folder / template).is_file():
                return (folder / template).as_posix()
        return f"templates/{template}"

    def _finalize(self, value: object) -> str:
        if isinstance(value, SclText):
            return self.table.marked(without_marks(value.text), value.origin)
        text = str(value)
        return text if is_marked(text) else without_marks(text)


class TemplateRenderer:
    """Renders templates of the shipped folder, with folders of the user's own in front of it.

    `texts` are those of the language in which their comments come out.
    """

    def __init__(self, extra: Sequence[Path] = (), texts: Texts = ENGLISH) -> None:
        self.texts = texts
        self._folders = [*reversed(extra), shipped("templates")]
        for folder in extra:
            if not folder.is_dir():
                raise error(
                    "FB5002",
                    f"the template folder {folder} is not there",
                    help="give --templates a folder with blocks/, types/, access/ or data/ in it",
                )
        self._environment = _Templates(self._folders, texts)
        self.table = self._environment.table

    def render(self, template: str, context: dict[str, object]) -> str:
        """The template as marked text. Raises DiagnosticError FB5003 or FB5004."""
        self._environment.refill()
        try:
            return self._environment.get_template(template).render(context)
        except TemplateNotFound as missing:
            raise self._missing(missing) from None
        except TemplateSyntaxError as wrong:
            raise self._failure(
                f"the template cannot be read: {wrong.message}",
                wrong.name or template,
                wrong.lineno,
            ) from None
        except (UndefinedError, SecurityError, TemplateError) as wrong:
            raise self._failure(
                f"the template cannot be filled in: {wrong}", *self._where(wrong, template)
            ) from None
        except DiagnosticError:
            raise
        except OSError as problem:
            reason = problem.strerror or type(problem).__name__
            raise self._unreadable(template, reason) from None
        except UnicodeDecodeError:
            raise self._unreadable(template, "it is not UTF-8") from None
        except Exception as wrong:
            # whatever an expression in a template can raise, and Python's limits for nesting
            raise self._failure(
                f"the template cannot be filled in: {type(wrong).__name__}: {wrong}",
                *self._where(wrong, template),
            ) from None

    def names(self) -> list[str]:
        """All templates that there are, in order."""
        return sorted(self._environment.list_templates(extensions=["jinja"]))

    def text_of(self, template: str) -> str:
        """The template itself, for the hash of the inputs."""
        loader = self._environment.loader
        assert loader is not None
        try:
            return loader.get_source(self._environment, template)[0]
        except OSError as problem:
            reason = problem.strerror or type(problem).__name__
            raise self._unreadable(template, reason) from None
        except UnicodeDecodeError:
            raise self._unreadable(template, "it is not UTF-8") from None

    def _missing(self, problem: TemplateNotFound) -> DiagnosticError:
        place = self._where(problem, "")
        return error(
            "FB5003",
            f"there is no template {problem.name}",
            self._span(*place) if place[0] else None,
            "templates are looked for in the --templates folders, then in the shipped one",
        )

    def _unreadable(self, template: str, reason: str) -> DiagnosticError:
        return error(
            "FB5003",
            f"the template {template} cannot be read: {reason}",
            help="templates are text files in UTF-8 that you may read",
        )

    def _failure(self, message: str, template: str, line: int) -> DiagnosticError:
        return error(
            "FB5004",
            message,
            self._span(template, line),
            "compare it with the shipped template of that name",
        )

    def _span(self, template: str, line: int) -> Span | None:
        """A line of a template."""
        try:
            source = Source(self._environment.place_of(template), self.text_of(template))
        except (TemplateNotFound, DiagnosticError):
            return None
        start = sum(len(text) + 1 for text in source.text.split("\n")[: line - 1])
        return Span(source, start, start + len(source.line_text(line)))

    def _where(self, problem: BaseException, template: str) -> tuple[str, int]:
        """The template line on which a problem came up: the innermost frame that is a template."""
        name, line = template, 1
        trace = problem.__traceback__
        while trace is not None:
            file = Path(trace.tb_frame.f_code.co_filename)
            for folder in self._folders:
                if file.is_relative_to(folder):
                    name, line = file.relative_to(folder).as_posix(), trace.tb_lineno
            trace = trace.tb_next
        return name, line
