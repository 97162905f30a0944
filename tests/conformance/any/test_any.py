"""ANY as a parameter: an area that a block hands on to BLKMOV and FILL.

Expected values: S7-SCL V5.3 manual, "Parameter type ANY"; System functions manual, SFC 20, SFC 21.
"""

from pathlib import Path

from harness import LoadedProgram, load_program

_PROGRAM = Path(__file__).with_name("hand_on.step7")


def _run(engine_name: str) -> LoadedProgram:
    return load_program([_PROGRAM], dialect="step7", engine=engine_name)


def test_an_area_goes_through_several_blocks(engine_name: str) -> None:
    block = _run(engine_name).instance("FB1")
    block()
    assert block["record"] == {"x": 0x0908, "y": 0x0706}
    assert block["words"] == [0x0908, 0x0706, 0]
    assert block["result"] == [0, 0, 0, 0]


def test_a_pointer_constant_is_an_area(engine_name: str) -> None:
    program = _run(engine_name)
    program.instance("FB1")()
    assert program.globals["DB10"]["c"] == 0x01020304


def test_a_member_of_a_data_block_is_an_area(engine_name: str) -> None:
    block = _run(engine_name).instance("FB1")
    block()
    assert block["number"] == 0x0304


def test_fill_repeats_what_any_points_to(engine_name: str) -> None:
    program = _run(engine_name)
    program.instance("FB1")()
    assert bytes(program.engine.environment.markers[100:106]) == bytes((3, 4, 3, 4, 3, 0))
