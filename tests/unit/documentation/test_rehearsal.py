"""What the other tests here rest on: a page that is wrong is found to be wrong."""

from pathlib import Path

import pytest

from tests.unit.documentation import markdown, rehearsal
from tests.unit.documentation.fragments import problems_of
from tests.unit.documentation.markdown import CodeBlock, anchors_of, links_of, pages
from tests.unit.documentation.rehearsal import commands_of, follow


@pytest.mark.parametrize(
    ("language", "text"),
    [
        ("yaml", "version: 1\nnames: hall\n"),
        ("yaml", "plc: s7-2000\ndialect: tia\n"),
        ("yaml", "drives: [\n"),
        ("scl", 'FUNCTION_BLOCK "P"\nBEGIN\n  #a := 1;\nEND_FUNCTION_BLOCK\n'),
        ("scl", "#a := ;\n"),
        ("st", "#a := 1;\n"),
        ("python", "def (:\n"),
        ("json", "{\n"),
        ("toml", "a = \n"),
        ("xml", "<a>\n"),
        ("jinja", "{% if %}\n"),
    ],
)
def test_text_that_is_wrong_is_found(language: str, text: str) -> None:
    assert problems_of(language, text)


@pytest.mark.parametrize(
    ("language", "text"),
    [
        ("yaml", "- {name: infeed, inv_no: 1}\n"),
        ("yaml", "steps:\n  - inject: drive_unpowered\n    on: pump\n"),
        ("scl", "IF #a THEN\n  #b := 1;\nEND_IF;\n"),
        ("scl", "VAR\n  a : INT;\nEND_VAR\n"),
        ("scl", "a : INT;\n"),
        ("st", "a := 1;\n"),
    ],
)
def test_parts_of_files_are_read(language: str, text: str) -> None:
    assert problems_of(language, text) == []


def test_a_dollar_tells_commands_from_what_they_print() -> None:
    text = "$ fbgen check a b    # status 1\nerror\n$ fbgen demo\n"
    first, second = commands_of(CodeBlock("page", 1, "console", "", text))
    assert (first.words, first.shown, first.status) == (["fbgen", "check", "a", "b"], "error\n", 1)
    assert (second.words, second.shown, second.status) == (["fbgen", "demo"], None, 0)


@pytest.fixture
def written(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A page of its own, which is the only one."""
    page = tmp_path / "page.md"
    monkeypatch.setattr(markdown, "pages", lambda: {"page.md": page})
    for known in (markdown.text_of, markdown.blocks_of, markdown.anchors_of):
        known.cache_clear()
    monkeypatch.chdir(tmp_path)
    return page


RIGHT = """\
# Page

```scl a.scl
FUNCTION "A" : INT
BEGIN
  #A := 1;
END_FUNCTION
```

```console
$ fbgen check a.scl
files: 1, ..., errors: 0, warnings: 0
```

```python
from harness import load_program

assert load_program(["a.scl"]).call("A") == 1
```
"""


def test_a_page_that_is_right_can_be_followed(
    written: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    written.write_text(RIGHT, "utf-8")
    follow("page.md", written.parent, capsys)


@pytest.mark.parametrize(
    ("right", "wrong"),
    [
        ("errors: 0", "errors: 2"),
        ("check a.scl", "check b.scl"),
        ("check a.scl", "check a.scl    # status 1"),
        ("#A := 1", "#A := 1.5"),
        ("== 1", "== 2"),
        ("$ fbgen", "$ rm"),
    ],
)
def test_a_page_that_is_wrong_cannot_be_followed(
    written: Path, capsys: pytest.CaptureFixture[str], right: str, wrong: str
) -> None:
    assert right in RIGHT
    written.write_text(RIGHT.replace(right, wrong), "utf-8")
    with pytest.raises((AssertionError, pytest.fail.Exception)):
        follow("page.md", written.parent, capsys)


def test_headings_have_the_names_that_links_use(written: Path) -> None:
    written.write_text("# A `b`, c: d_e\n\n## Twice\n\n## Twice\n\n[x](#twice) `[y](z)`\n", "utf-8")
    assert anchors_of("page.md") == {"a-b-c-d_e", "twice", "twice-1"}
    assert links_of("page.md") == ["#twice"]


def test_there_are_pages_and_each_command_that_is_not_run_has_a_reason() -> None:
    assert len(pages()) > 300
    assert all({**rehearsal.ELSEWHERE, **rehearsal.LONG}.values())
