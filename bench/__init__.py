"""Speed and size: `python -m bench` runs all of it, `python -m bench engine` one module."""
