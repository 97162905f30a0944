"""The EDS file, read by a parser that others wrote (eds-pie, MIT), says what the option does."""

import logging
from typing import Any

import pytest

from fbgen.artefacts.eds import eds_text
from fbgen.catalog import load_catalog
from fbgen.wire.devicenet_paths import Segment, parse_path
from tests.unit.devicenet.bench import GATEWAY, bench

SERIES = load_catalog().drive("vf-s15")
SECTIONS = ["File", "Device", "IO_Info", "ParamClass", "Params"]


@pytest.fixture(scope="module")
def sheet() -> Any:
    from eds_pie.eds_pie import Parser  # noqa: PLC0415 - it sets up logging when it is imported

    logging.disable(logging.CRITICAL)
    try:
        parser = Parser(eds_text(GATEWAY, SERIES))
        parser.parse()
    finally:
        logging.disable(logging.NOTSET)
    return parser.eds


@pytest.mark.fact("dev.eds")
def test_a_foreign_parser_finds_the_device(sheet: Any) -> None:
    assert [name for name in SECTIONS if sheet.has_section(name)] == SECTIONS
    values = {key: sheet.get_value("Device", key) for key in ("VendCode", "ProdType", "ProdCode")}
    codes = GATEWAY.devicenet.product_codes
    wanted = {"VendCode": 377, "ProdType": 2, "ProdCode": codes["vf-s15"]}
    assert {key: int(value) for key, value in values.items()} == wanted
    assert sheet.get_value("Device", "ProdName") == "DEV003Z"


@pytest.mark.fact("dev.eds")
def test_its_connections_are_those_of_the_simulated_option(sheet: Any) -> None:
    for number, pair in enumerate(GATEWAY.assemblies, start=1):
        made = bench(pair.setting)
        for side, length in (
            ("Input", made.option.input_length),
            ("Output", made.option.output_length),
        ):
            assert int(sheet.get_value("IO_Info", f"{side}{number}", 0)) == length
            path = bytes.fromhex(sheet.get_value("IO_Info", f"{side}{number}", 5))
            assert int(sheet.get_value("IO_Info", f"{side}{number}", 4)) == len(path)
            instance = pair.input.instance if side == "Input" else pair.output.instance
            assert parse_path(path)[1].number == instance


@pytest.mark.fact("dev.eds")
def test_every_parameter_is_reached_by_its_path(sheet: Any) -> None:
    made = bench()
    made.allocate(1)
    for number, item in enumerate(GATEWAY.parameters, start=1):
        key = f"Param{number}"
        path = parse_path(bytes.fromhex(sheet.get_value("Params", key, 2)))
        assert [part.kind for part in path] == [
            Segment.CLASS, Segment.INSTANCE, Segment.ATTRIBUTE,
        ]  # fmt: skip
        found = made.get(path[0].number, path[1].number, path[2].number)
        default = sheet.get_value("Params", key, 11)
        assert found == int(default).to_bytes(2, "little")
        assert sheet.get_value("Params", key, 6) == item.display
        values = [int(sheet.get_value("Params", key, at)) for at in (12, 13, 20)]
        multiplier, divisor, decimals = values
        assert multiplier / divisor == pytest.approx(item.resolution)
        assert round(item.resolution, decimals) == item.resolution
        scaled = int(sheet.get_value("Params", key, 3), 16) & 4
        assert bool(scaled) is (item.resolution != 1)


@pytest.mark.fact("dev.eds")
def test_every_kind_of_connection_has_inputs_and_outputs_that_are_for_it(sheet: Any) -> None:
    for kind, bit in (("PollInfo", 1), ("COSInfo", 4), ("CyclicInfo", 8)):
        for place, side in ((1, "Input"), (2, "Output")):
            number = int(sheet.get_value("IO_Info", kind, place))
            assert int(sheet.get_value("IO_Info", f"{side}{number}", 2), 16) & bit
