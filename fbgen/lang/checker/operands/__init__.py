"""Expressions: names, places in memory, operators, references."""
