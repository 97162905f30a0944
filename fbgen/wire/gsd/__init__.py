"""GSD files: what the maker of a PROFIBUS DP slave says about it, in the language of such files."""

from fbgen.wire.gsd.choosing import Configuration, choose
from fbgen.wire.gsd.reading import read_gsd
from fbgen.wire.gsd.station import (
    DiagnosisText,
    GsdModule,
    GsdStation,
    Limits,
    Rate,
    SlotDefinition,
)
from fbgen.wire.gsd.text import MAX_BYTES

__all__ = [
    "Configuration",
    "DiagnosisText",
    "GsdModule",
    "GsdStation",
    "Limits",
    "MAX_BYTES",
    "Rate",
    "SlotDefinition",
    "choose",
    "read_gsd",
]
