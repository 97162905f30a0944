"""Statements: assignments, jumps, and what becomes of errors."""
