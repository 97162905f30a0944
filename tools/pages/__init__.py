"""Pages of docs/reference that are made from the program; `python -m tools.pages` writes them."""
