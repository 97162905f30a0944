"""X_TO_BOOL means something else in another dialect: a conversion says what the first one means."""

import pytest

from fbgen.diagnostics import DiagnosticError
from fbgen.lang.conversion import convert
from fbgen.lang.parser import parse
from fbgen.lang.printer import print_generated
from fbgen.source import Source
from harness import load_program

TEXT = """
FUNCTION_BLOCK B
VAR_INPUT
  count : INT;
  small : BYTE;
  pattern : WORD;
END_VAR
VAR_OUTPUT
  ofCount : BOOL;
  ofSmall : BOOL;
  ofPattern : BOOL;
END_VAR
{begin}
  ofCount := INT_TO_BOOL(count + 1);
  ofSmall := BYTE_TO_BOOL(small) AND NOT INT_TO_BOOL(-count);
  ofPattern := WORD_TO_BOOL(pattern OR 16#10);
END_FUNCTION_BLOCK
"""
DIALECTS = ("tia", "step7", "iec", "twincat")
VALUES = [(-1, 0, 0), (0, 1, 1), (1, 2, 0xFF00), (2, 255, 3), (-32768, 128, 0)]


def results(texts: list[str], dialect: str) -> list[tuple[object, ...]]:
    sources = [Source(f"{number}.scl", text) for number, text in enumerate(texts)]
    block = load_program(sources, dialect).instance("B")
    seen = []
    for count, small, pattern in VALUES:
        block(count=count, small=small, pattern=pattern)
        seen.append((block.ofCount, block.ofSmall, block.ofPattern))
    return seen


@pytest.mark.parametrize("source", DIALECTS)
@pytest.mark.parametrize("target", DIALECTS)
def test_a_converted_block_gives_the_same_bool(source: str, target: str) -> None:
    text = TEXT.format(begin="BEGIN" if source in ("tia", "step7") else "")
    if source == "tia":
        for name in ("ofCount", "ofSmall", "ofPattern", "count", "small", "pattern"):
            text = text.replace(f" {name} :=", f" #{name} :=").replace(f"({name}", f"(#{name}")
    converted = convert([parse(Source("b.scl", text), source)], target)
    printed = [print_generated(one).text for one in converted]
    assert results(printed, target) == results([text], source)


@pytest.mark.parametrize(
    ("source", "target", "is_refused"),
    [("iec", "tia", True), ("twincat", "step7", True), ("iec", "iec", False)],
)
def test_to_bool_without_a_type_is_refused_where_it_means_something_else(
    source: str, target: str, *, is_refused: bool
) -> None:
    text = TEXT.format(begin="").replace("WORD_TO_BOOL", "TO_BOOL")
    file = parse(Source("b.st", text), source)
    if not is_refused:
        assert convert([file], target)
        return
    with pytest.raises(DiagnosticError) as refused:
        convert([file], target)
    (found,) = refused.value.diagnostics
    assert (found.code, found.span and found.span.line) == ("FB3051", 16)
