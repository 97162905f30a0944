"""Calls: what is called, which argument belongs to which parameter, and EN and ENO."""
