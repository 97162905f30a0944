"""A block on trial: called cycle after cycle with inputs set, and what it does noted.

For a quick look at a block, without a test: `fbgen run`.
"""

from harness.trial.settings import Setting, read_duration, read_setting
from harness.trial.subject import Subject, subject_named
from harness.trial.trial import Row, Trial

__all__ = ["Row", "Setting", "Subject", "Trial", "read_duration", "read_setting", "subject_named"]
