"""Makes a failing scenario short: what can be left out with the same failure is left out.

Delta debugging over the list of faults and then over the steps, in halves, quarters and so on down
to single ones; then settings are dropped, and times made round and short. Whatever still fails in
the same way is taken.
"""

from collections.abc import Callable, Sequence
from typing import TypeVar

from harness.durations import read_duration
from harness.kernel import NS_PER_MS
from harness.verify.campaign.entries import Entry

Item = TypeVar("Item")
Fails = Callable[[Entry], bool]


def shrink(entry: Entry, fails: Fails) -> Entry:
    """The shortest scenario that was found; `fails` says whether one still fails in the same way.

    The last step stays: it is what fails, or what lets time pass.
    """
    for key in ("faults", "steps", "faults"):
        entry = _shorter_list(entry, key, fails)
    entry = _plainer(entry, fails)
    for number in range(len(entry.get("faults", ()))):
        entry = _simpler_fault(entry, number, fails)
    for number, step in enumerate(entry["steps"]):
        if "wait" in step:
            entry = _rounder(entry, "steps", number, "wait", fails)
    return entry if entry.get("faults") else _left_out(entry, "faults")


def minimal(items: Sequence[Item], fails: Callable[[list[Item]], bool]) -> list[Item]:
    """A list of items from which none can be taken without losing the failure (ddmin)."""
    left, parts = list(items), 2
    while left:
        size = max(len(left) // parts, 1)
        for at in range(0, len(left), size):
            fewer = left[:at] + left[at + size :]
            if fails(fewer):
                left, parts = fewer, max(parts - 1, 2)
                break
        else:
            if size == 1:
                break
            parts = min(parts * 2, len(left))
    return left


def _shorter_list(entry: Entry, key: str, fails: Fails) -> Entry:
    items = list(entry.get(key, ()))
    kept = items[-1:] if key == "steps" else []
    loose = items[: len(items) - len(kept)]
    return entry | {key: minimal(loose, lambda some: fails(entry | {key: some + kept})) + kept}


def _plainer(entry: Entry, fails: Fails) -> Entry:
    """The plant as its file has it, on the usual engine, as far as that fails, too."""
    for key in ("gateways", "drives", "times", "engine"):
        if key in entry and fails(without := _left_out(entry, key)):
            entry = without
    for key in ("gateways", "drives", "times"):
        for name in entry.get(key, {}):
            tried = entry | {key: _left_out(entry[key], name)}
            entry = tried if fails(tried) else entry
    if len(entry.get("variations", ())) != 1:
        return entry
    if fails(without := _left_out(entry, "variations")):
        return without
    for name in ("options", "cycle_time_ms", "layout"):
        tried = entry | {"variations": [_left_out(entry["variations"][0], name)]}
        entry = tried if fails(tried) else entry
    return entry


def _left_out(entry: Entry, key: str) -> Entry:
    return {name: value for name, value in entry.items() if name != key}


def _simpler_fault(entry: Entry, number: int, fails: Fails) -> Entry:
    plain = {key: value for key, value in entry["faults"][number].items() if key != "settings"}
    simple = _replaced(entry, "faults", number, plain)
    if "settings" in entry["faults"][number] and fails(simple):
        entry = simple
    for key in ("lasts", "at"):
        if key in entry["faults"][number]:
            entry = _rounder(entry, "faults", number, key, fails)
    return entry


def _rounder(entry: Entry, where: str, number: int, key: str, fails: Fails) -> Entry:
    """A time in whole seconds, tenths or milliseconds, the roundest that still fails."""
    time_ns = read_duration(entry[where][number][key])
    for unit_ms in (1000, 100, 10, 1):
        rounded = max(round(time_ns / (unit_ms * NS_PER_MS)) * unit_ms, 1)
        tried = _replaced(entry, where, number, entry[where][number] | {key: f"{rounded} ms"})
        if fails(tried):
            return tried
    return entry


def _replaced(entry: Entry, where: str, number: int, item: Entry) -> Entry:
    items = list(entry[where])
    items[number] = item
    return entry | {where: items}
