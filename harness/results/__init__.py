"""What came of running scenarios: plain data for reports, which know nothing of how it came."""

from harness.results.result import ScenarioReport, ScenarioResult

__all__ = ["ScenarioReport", "ScenarioResult"]
