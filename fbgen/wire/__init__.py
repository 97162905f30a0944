"""Data formats without behaviour: frames, identifiers and checksums as they go over a wire."""
