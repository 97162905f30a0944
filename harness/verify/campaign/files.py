"""Which files and faults a campaign is about, from what was asked for."""

from collections.abc import Sequence
from pathlib import Path

from fbgen.diagnostics import Diagnostic, DiagnosticError
from fbgen.nearest import nearest
from fbgen.resources import shipped
from harness.faults import FAULTS
from harness.scenario import SUFFIX, find_scenarios, scenario_cases
from harness.verify.campaign.trials import CampaignSettings, subject_of


def campaign_settings(paths: Sequence[Path], faults: Sequence[str]) -> CampaignSettings:
    """Plant files and scenario files; folders stand for their scenarios, nothing for the example.

    Raises DiagnosticError FB8007 for what is not there, FB8004 for unknown faults, and whatever is
    wrong in a file.
    """
    unknown = [name for name in faults if name not in FAULTS]
    if unknown:
        raise DiagnosticError(
            [
                Diagnostic("FB8004", f"there is no fault '{name}'", None, nearest(name, FAULTS))
                for name in unknown
            ]
        )
    files: list[Path] = []
    for path in paths or [shipped("examples") / "five_drives" / "plant.yaml"]:
        if path.is_file() and not path.name.endswith(SUFFIX):
            subject_of(path.resolve().as_posix())
            files.append(path)
        else:
            found = find_scenarios([path])
            for file in found:
                scenario_cases(file)
            files += found
    named = tuple(dict.fromkeys(path.resolve().as_posix() for path in files))
    return CampaignSettings(named, tuple(sorted(faults or FAULTS)))
