"""ENO of instructions with several outputs, and results that are taken by an arrow.

Expected values: TIA Portal help, "SCALE" (an error outside of the range), "STRG_VAL" and "VAL_STRG"
(ENO is FALSE where nothing fits), "DEMUX" (ENO is FALSE without such an output), "GET_ERROR"
(changes its operand only where there is an error), "T_ADD".
"""

from pathlib import Path

from harness import load_program
from harness.engine.variables import BlockInstance

_PROGRAM = Path(__file__).with_name("eno.scl")


def _told(engine_name: str, **inputs: int | str) -> BlockInstance:
    block = load_program([_PROGRAM], engine=engine_name).instance("Told")
    block(**{"raw": 100, "text": "12", "k": 0, **inputs})
    return block


def test_eno_is_true_where_everything_works(engine_name: str) -> None:
    block = _told(engine_name)
    flags = ("scaled", "converted", "demuxed", "shown", "read", "added")
    assert [block[one] for one in flags] == [True] * len(flags)
    assert (block["number"], block["chosen"], block["line"]) == (12, 7, " 100")
    assert block["sum"] == 1_500


def test_eno_of_scale_is_false_outside_of_the_range(engine_name: str) -> None:
    block = _told(engine_name, raw=30_000)
    assert not block["scaled"]
    assert (block["value"], block["status"]) == (100.0, 8)


def test_eno_of_text_conversions_is_false_where_nothing_fits(engine_name: str) -> None:
    block = _told(engine_name, text="x", raw=12_345)
    assert not block["converted"]
    assert not block["shown"]
    assert (block["number"], block["line"]) == (0, "")
    assert not _told(engine_name, text="99999")["converted"]


def test_eno_of_demux_is_false_without_such_an_output(engine_name: str) -> None:
    assert not _told(engine_name, k=2)["demuxed"]


def test_a_text_that_is_moved_loses_its_end(engine_name: str) -> None:
    assert _told(engine_name, text="abcdef")["short"] == "abc"
