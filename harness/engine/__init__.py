"""Checked program to behaviour: the reference evaluator, the compiler to Python, the library."""
