"""The files of vectors as data. Each is read once in a process, by libyaml where PyYAML has it."""

from functools import cache
from pathlib import Path
from typing import Any

import yaml

FOLDER = Path(__file__).parent
LOADER: type[yaml.SafeLoader] = getattr(yaml, "CSafeLoader", yaml.SafeLoader)


@cache
def entries(name: str) -> dict[str, dict[str, Any]]:
    """The entries of a file, NAME.yaml, by their ids."""
    text = (FOLDER / f"{name}.yaml").read_text(encoding="utf-8")
    return {entry["id"]: entry for entry in yaml.load(text, Loader=LOADER)["entries"]}
