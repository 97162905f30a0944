"""What becomes BOOL.

Sources: IEC 61131-3, table 30 (the rightmost bit of a bit string); CODESYS help, "BOOL conversions"
(FALSE for 0, else TRUE); TIA Portal help, "CONVERT" (the lowest bit).
"""

import pytest

from fbgen.source import Source
from harness import load_program

TEXT = """
FUNCTION_BLOCK B
VAR_INPUT
  count : INT;
  pattern : WORD;
END_VAR
VAR
  ofCount : BOOL;
  ofPattern : BOOL;
END_VAR
{begin}
  ofCount := INT_TO_BOOL(count);
  ofPattern := WORD_TO_BOOL(pattern);
END_FUNCTION_BLOCK
"""


@pytest.mark.parametrize(
    ("dialect", "of_count", "of_pattern"),
    [
        ("tia", False, False),
        ("step7", False, False),
        ("iec", True, False),
        ("twincat", True, True),
    ],
)
def test_two_becomes_bool_by_the_rule_of_the_dialect(
    engine_name: str, dialect: str, *, of_count: bool, of_pattern: bool
) -> None:
    text = TEXT.format(begin="BEGIN" if dialect in ("tia", "step7") else "")
    program = load_program([Source("b.scl", text)], dialect=dialect, engine=engine_name)
    block = program.instance("B")
    block(count=2, pattern=2)
    assert (block.ofCount, block.ofPattern) == (of_count, of_pattern)
    block(count=0, pattern=0)
    assert (block.ofCount, block.ofPattern) == (False, False)
