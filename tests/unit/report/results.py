"""Results of scenarios as a session leaves them, made by hand."""

from dataclasses import replace

from fbgen.diagnostics import Diagnostic, Note, Severity
from fbgen.source import Source, Span
from harness.results import ScenarioReport, ScenarioResult

SCENARIO = Source("tests/start.scenario.yaml", "steps:\n  - expect: {drive.pump.running: true}\n")
PLC = Source("TOS_Drive.scl", "IF #run THEN\n    #running := FALSE;\nEND_IF;\n")
FOUND = "drive.pump.running is false after 0.300 s, expected true"

PASSED = ScenarioResult(
    *("A drive <stops> & waits", "tests/stop.scenario.yaml", 0, True),
    virtual_ns=2_500_000_000,
    checks=3,
    plant="tests/plant.yaml",
    ran_dialect="tia",
)
FAILED = ScenarioResult(
    *("A drive starts [step7]", "tests/start.scenario.yaml", 7, False),
    failures=(
        Diagnostic(
            "FB8001",
            FOUND,
            Span(SCENARIO, 20, 38),
            notes=(
                Note("at 0.400 s of the plant's time"),
                Note("FALSE was written here", Span(PLC, 17, 34)),
            ),
        ),
        Diagnostic("FB8012", "the CPU went to STOP by itself", help="mend it"),
    ),
    virtual_ns=400_000_000,
    checks=1,
    changes="[step7]",
    plant="tests/plant.yaml",
    ran_dialect="step7",
)
UNREADABLE = ScenarioResult(
    *("broken.scenario.yaml", "tests/broken.scenario.yaml", 0, False),
    failures=(Diagnostic("FB1001", "this is no YAML: \x07\ufffe"),),
)
EXPECTED = replace(
    FAILED, passed=True, expected_failure="the line is not repaired yet", name="Known"
)
WARNED = replace(
    PASSED,
    warnings=(Diagnostic("FB8021", "nothing was decided", severity=Severity.WARNING),),
    name="Told",
)
SESSION = ScenarioReport((PASSED, FAILED, UNREADABLE))
