"""Expressions as Python: operators, places, conversions, standard functions, references."""
