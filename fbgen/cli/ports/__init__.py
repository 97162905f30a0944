"""Devices at real ports: options of the line, what is served, asked and shown."""
