"""Everything that is generated beside the PLC text: lists for other tools, instructions."""

from fbgen.artefacts.everything import with_artefacts

__all__ = ["with_artefacts"]
