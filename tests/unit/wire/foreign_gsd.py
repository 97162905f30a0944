"""pyprofibus, which others wrote, as a reader of GSD files."""

import gc
from unittest.mock import patch

from pyprofibus.gsd.interp import GsdInterp


def foreign_station(data: bytes) -> GsdInterp:
    """The station in a file. It collects garbage at each step, which a test process has much of."""
    with patch.object(gc, "collect"):
        return GsdInterp.fromBytes(data)
