"""One browser for all pages that are tried in one: there can be no second beside it."""

from collections.abc import Iterator
from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from playwright.sync_api import Browser


@pytest.fixture(scope="session")
def chromium() -> "Iterator[Browser]":
    """A browser without a window."""
    from tests.browser import headless_chromium  # noqa: PLC0415 - few tests need it

    with headless_chromium() as browser:
        yield browser
