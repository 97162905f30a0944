"""A sweep in words and figures."""

from harness.kernel import NS_PER_MS
from harness.sweep.sweeping import SweepResult

_EMERGENCY_STOP = "emergency stop"


def report(result: SweepResult) -> str:
    """What was gone through, the longest times with their bounds, and what broke a rule."""
    lines = [
        f"{result.runs} combinations, {result.requests} requests, "
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
    if not result.broken:
        lines.append("Every rule held.")
    return "\n".join(lines) + "\n"
