"""A failure of a campaign as a short scenario file that `fbgen test` runs."""

import os
from pathlib import Path

import yaml

from fbgen.diagnostics import DiagnosticError
from harness.verify.campaign.entries import Entry
from harness.verify.campaign.shrinking import shrink
from harness.verify.campaign.trials import CampaignSettings, Failure, drawn, kind_of, outcome


def reproduce(settings: CampaignSettings, failure: Failure, folder: Path) -> Path:
    """Shrink a failure and write its scenario file; gives its path."""
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / f"seed_{failure.seed}.scenario.yaml"

    def fails(entry: Entry) -> bool:
        try:
            found = outcome(entry, path)
        except (DiagnosticError, ValueError):
            return False
        return found is not None and kind_of(found) == failure.kind

    entry = shrink(drawn(settings, failure.seed), fails)
    if "plant" in entry:
        entry = entry | {"plant": Path(os.path.relpath(entry["plant"], folder)).as_posix()}
    head = (
        f"# {failure.kind}: {failure.message}\n"
        f"# Found by seed {failure.seed} of a campaign: {failure.configuration}\n"
        f"# Run it again: fbgen test {path.as_posix()}\n"
    )
    text = yaml.safe_dump(entry, sort_keys=False, allow_unicode=False, width=99)
    path.write_text(head + text, encoding="utf-8", newline="\n")
    return path
