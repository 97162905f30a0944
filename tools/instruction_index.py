"""Writes docs/reference/instructions.md, the list of instructions, from the checker's tables."""

import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from fbgen.lang.checker.supplied.instruction_page import page  # noqa: E402  (the checkout first)

(ROOT / "docs" / "reference" / "instructions.md").write_text(page(), encoding="utf-8")
