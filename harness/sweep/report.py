"""A sweep in words and figures."""

from harness.kernel import NS_PER_MS
from harness.sweep.result import SweepResult

_EMERGENCY_STOP = "emergency stop"


def report(result: SweepResult) -> str:
    """What was gone through, the longest times with their bounds, and what broke a rule."""
    of = f" of {result.planned}" if result.runs < result.planned else ""
    lines = [
        f"{result.runs}{of} combinations, {result.requests} requests, "
        f"{result.telegrams} telegrams on the line.",
        "",
        "| access | drives answer within | what | worst | bound | at |",
        "|---|---|---|---|---|---|",
    ]
    for (access, limit_ms, kind), worst in sorted(result.worst.items()):
        times = result.times[access, limit_ms]
        bound_ms = times.emergency_stop_ms if kind == _EMERGENCY_STOP else times.telegram_ms
        lines.append(
            f"| {access} | {limit_ms} ms | {kind} | {worst.took_ns / NS_PER_MS:.0f} ms "
            f"| {bound_ms:.0f} ms | {worst.conditions} |"
        )
    lines.append("")
    for rule, count in result.broken.most_common():
        conditions, violation = result.examples[rule]
        lines.append(f"BROKEN {count} times: {rule}. First: {conditions}: {violation.text}")
    if of:
        lines.append("The sweep was ended early.")
    if not result.broken:
        lines.append("Every rule held." if not of else "Every rule held up to there.")
    return "\n".join(lines) + "\n"
