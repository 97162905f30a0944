"""Handshakes for the reference, from a simulated run."""

import pytest

from fbgen.catalog import load_catalog
from fbgen.cli.handshakes import handshakes
from fbgen.docs.examples import example_programs
from fbgen.docs.handshake import Handshake, Signal


@pytest.fixture(scope="module")
def seen() -> dict[str, Handshake]:
    programs = list(example_programs(load_catalog()))
    return {one.gateway: one for one in handshakes(programs, ["tospbdp001", "pbdp110", "dev003z"])}


def at(one: Handshake, title: str) -> Signal:
    return next(signal for signal in one.signals if signal.title == title)


@pytest.mark.fact("tos.sw.b14")
def test_bit_14_is_acknowledged_and_the_reply_comes_behind_the_frame(
    seen: dict[str, Handshake],
) -> None:
    telegram = seen["tospbdp001"]
    posted = at(telegram, "control bit 14").changes[1]
    taken = at(telegram, "status bit 14").changes[1]
    assert posted[1] == taken[1]
    assert posted[0] < taken[0]
    assert at(telegram, "trigger").changes[1][0] == posted[0]
    request, reply = telegram.frames[:2]
    assert posted[0] < request.start_ms < request.end_ms < reply.start_ms
    assert request.text.startswith("2F 00 47 FD 01")


def test_a_parameter_is_read_number_first(seen: dict[str, Handshake]) -> None:
    channel = seen["pbdp110"]
    order = [at(channel, title).changes[1][0] for title in ("number out", "request", "response")]
    assert order == sorted(order)
    assert [value for _, value in at(channel, "request").changes] == [0, 0x1000, 0]


def test_what_no_example_plant_has_is_left_out(seen: dict[str, Handshake]) -> None:
    assert set(seen) == {"tospbdp001", "pbdp110"}
