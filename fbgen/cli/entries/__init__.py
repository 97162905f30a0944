"""Entries of the catalogue as text for a person."""
