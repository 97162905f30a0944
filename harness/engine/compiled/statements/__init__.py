"""Statements and calls as Python."""
