"""Which blocks a plant needs, and what their templates are told."""
