"""The Jinja environment: sandboxed, strict about undefined names, and marking what it renders."""

from collections.abc import Sequence
from pathlib import Path

from jinja2 import (
    ChoiceLoader,
    FileSystemLoader,
    StrictUndefined,
    TemplateError,
    TemplateNotFound,
    TemplateSyntaxError,
    UndefinedError,
)
from jinja2.exceptions import SecurityError
from jinja2.ext import Extension
from jinja2.sandbox import ImmutableSandboxedEnvironment

from fbgen.blocks.literals import SclText
from fbgen.diagnostics import Diagnostic, DiagnosticError, error
from fbgen.emit.marks import OriginTable, is_marked, without_marks
from fbgen.resources import shipped
from fbgen.source import Origin, Source, Span


class LineMarks(Extension):
    """Puts the mark of its template line in front of each line that is printed."""

    def preprocess(self, source: str, name: str | None, filename: str | None = None) -> str:
        table: OriginTable = self.environment.origin_table  # type: ignore[attr-defined]
        lines = source.split("\n")
        in_comment = False
        for number, line in enumerate(lines, start=1):
            content = line.lstrip()
            begins_comment = content.startswith("{#")
            if content and not in_comment and not content.startswith(("{%", "{#")):
                template = Origin("template", f"templates/{name}", number)
                indent = line[: len(line) - len(content)]
                lines[number - 1] = f"{indent}{table.line_mark(template)}{content}"
            in_comment = (in_comment or begins_comment) and "#}" not in content
        return "\n".join(lines)


class TemplateRenderer:
    """Renders templates of the shipped folder, with folders of the user's own in front of it."""

    def __init__(self, extra: Sequence[Path] = ()) -> None:
        self.table = OriginTable()
        folders = [*reversed(extra), shipped("templates")]
        for folder in extra:
            if not folder.is_dir():
                raise error(
                    "FB5002",
                    f"the template folder {folder} is not there",
                    help="give --templates a folder with blocks/, types/, access/ or data/ in it",
                )
        self._environment = ImmutableSandboxedEnvironment(
            loader=ChoiceLoader([FileSystemLoader(folder) for folder in folders]),
            undefined=StrictUndefined,
            trim_blocks=True,
            lstrip_blocks=True,
            keep_trailing_newline=True,
            finalize=self._finalize,
        )
        self._environment.origin_table = self.table  # type: ignore[attr-defined]
        self._environment.add_extension(LineMarks)

    def render(self, template: str, context: dict[str, object]) -> str:
        """The template as marked text. Raises DiagnosticError FB5003 or FB5004."""
        try:
            return self._environment.get_template(template).render(context)
        except TemplateNotFound as missing:
            raise error(
                "FB5003",
                f"there is no template {missing.name}",
                help="templates are looked for in the --templates folders, then in the shipped one",
            ) from None
        except TemplateSyntaxError as wrong:
            raise self._failure(
                f"the template cannot be read: {wrong.message}",
                wrong.name or template,
                wrong.lineno,
            ) from None
        except (UndefinedError, SecurityError, TemplateError, ArithmeticError) as wrong:
            raise self._failure(
                f"the template cannot be filled in: {wrong}", *_where(wrong, template)
            ) from None
        except (TypeError, ValueError, AttributeError, LookupError, RecursionError) as wrong:
            if isinstance(wrong, DiagnosticError):
                raise
            raise self._failure(
                f"the template cannot be filled in: {type(wrong).__name__}: {wrong}",
                *_where(wrong, template),
            ) from None

    def names(self) -> list[str]:
        """All templates that there are, in order."""
        return sorted(self._environment.list_templates(extensions=["jinja"]))

    def text_of(self, template: str) -> str:
        """The template itself, for the hash of the inputs."""
        loader = self._environment.loader
        assert loader is not None
        return loader.get_source(self._environment, template)[0]

    def _finalize(self, value: object) -> str:
        if isinstance(value, SclText):
            return self.table.marked(without_marks(value.text), value.origin)
        text = str(value)
        return text if is_marked(text) else without_marks(text)

    def _failure(self, message: str, template: str, line: int) -> DiagnosticError:
        span = None
        try:
            source = Source(f"templates/{template}", self.text_of(template))
        except TemplateNotFound:
            pass
        else:
            start = sum(len(text) + 1 for text in source.text.split("\n")[: line - 1])
            span = Span(source, start, start + len(source.line_text(line)))
        return DiagnosticError(
            [
                Diagnostic(
                    "FB5004", message, span, "compare it with the shipped template of that name"
                )
            ]
        )


def _where(problem: BaseException, template: str) -> tuple[str, int]:
    """The template line on which a problem came up: the innermost frame that is a template."""
    name, line = template, 1
    trace = problem.__traceback__
    while trace is not None:
        code = trace.tb_frame.f_code
        if ".jinja" in code.co_filename:
            parts = Path(code.co_filename).parts
            name, line = "/".join(parts[-2:]), trace.tb_lineno
        trace = trace.tb_next
    return name, line
