"""Generating with templates, catalogues and plants of an attacker, through the command line."""

import contextlib
import io
from dataclasses import dataclass
from pathlib import Path

from fbgen.cli import main

ROOT = Path(__file__).parents[2]
EXAMPLE = ROOT / "examples" / "manual_example" / "plant.yaml"
TRIGGER = ROOT / "templates" / "blocks" / "TOS_TriggerCounter.scl.jinja"


@dataclass(frozen=True, slots=True)
class Outcome:
    """What a run came to: exit status, what it said, and everything that it wrote."""

    status: int
    said: str
    written: dict[str, bytes]

    def refused(self, code: str) -> None:
        """Check that the run ended with this diagnostic, and that nothing was written."""
        assert self.status == 1, self.said
        assert f"error[{code}]: " in self.said, self.said
        assert "Traceback" not in self.said
        assert self.written == {}


def generate(folder: Path, *options: str, plant: str | None = None) -> Outcome:
    """Run `fbgen generate` on the example, or on a plant file of this text."""
    path = EXAMPLE
    if plant is not None:
        path = folder / "plant.yaml"
        path.write_text(plant, "utf-8")
    out = folder / "out"
    said = io.StringIO()
    with contextlib.redirect_stdout(said), contextlib.redirect_stderr(said):
        status = main(("generate", str(path), "-o", str(out), *options))
    files = out.iterdir() if out.is_dir() else ()
    return Outcome(status, said.getvalue(), {item.name: item.read_bytes() for item in files})


def with_template(folder: Path, line: str) -> Outcome:
    """The trigger counter's template with a line of the attacker's behind BEGIN (line 19)."""
    blocks = folder / "templates" / "blocks"
    blocks.mkdir(parents=True)
    text = TRIGGER.read_text("utf-8").replace("BEGIN\n", f"BEGIN\n{line}\n", 1)
    (blocks / TRIGGER.name).write_text(text, "utf-8")
    return generate(folder, "--templates", str(folder / "templates"))
