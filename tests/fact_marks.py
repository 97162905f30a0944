"""Which behaviour rows the collected tests name, kept by `conftest.py` for the test of the rows."""

import pytest

FactMark = tuple[str, str]
"""Id of a behaviour row, and the test that names it."""

FACTS = pytest.StashKey[list[FactMark]]()
"""Every `fact` mark of the tests that were collected and are not slow."""
