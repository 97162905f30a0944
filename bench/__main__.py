"""Runs the modules of this folder that have `figures()`: all of them, or those that are named."""

import sys
from importlib import import_module
from pathlib import Path
from pkgutil import iter_modules


def main(names: list[str]) -> None:
    """Print the figures of the modules."""
    folder = Path(__file__).parent
    modules = names or sorted(module.name for module in iter_modules([str(folder)]))
    for name in modules:
        if name.startswith("__"):
            continue
        figures = getattr(import_module(f"bench.{name}"), "figures", None)
        if figures is None:
            continue
        print(f"\n{name}")
        for figure in figures():
            print(f"  {figure}", flush=True)


main(sys.argv[1:])
