"""Plants with serial lines: which blocks they get, what is refused, that dialects agree."""

from pathlib import Path

import pytest

from fbgen.catalog import load_catalog
from fbgen.diagnostics import DiagnosticError
from fbgen.emit.generator import generate
from fbgen.plant import Plant, changed, in_dialect, load_plant
from fbgen.plant.loading import read_plant
from fbgen.source import Source

ROOT = Path(__file__).parents[3]
CATALOG = load_catalog()
BAD = ROOT / "tests" / "unit" / "bad"


def _plant(name: str = "serial") -> Plant:
    return load_plant(ROOT / "examples" / name / "plant.yaml", CATALOG)


def _with_gateway() -> Plant:
    serial = (ROOT / "examples" / "serial" / "plant.yaml").read_text("utf-8")
    gateway = (ROOT / "examples" / "five_drives" / "plant.yaml").read_text("utf-8")
    text = serial + gateway[gateway.index("gateways:") :]
    return read_plant(Source("both.yaml", text), CATALOG)


def _blocks(plant: Plant) -> set[str]:
    return {block.name for block in generate(plant, CATALOG).blocks}


def test_each_protocol_has_its_telegrams() -> None:
    toshiba, modbus = _blocks(_plant()), _blocks(_plant("modbus"))
    assert {"TIP_Telegram", "TIP_Line", "TOS_StatusPoll"} <= toshiba
    assert {"MB_Telegram", "MB_Line", "MB_StatusPoll"} <= modbus
    assert not {one for one in toshiba if one.startswith("MB_")}
    assert {"TIP_Drive", "TIP_Alarms", "TIP_Port_line1", "TIP_Serial_line1"} <= toshiba & modbus
    assert not {"TOS_Drive", "TOS_Line", "TOS_Telegram"} & (toshiba | modbus)


def test_a_plant_has_gateways_and_lines() -> None:
    blocks = _blocks(_with_gateway())
    assert {"TOS_Drive", "TIP_Drive", "TOS_Line", "TIP_Line"} <= blocks


@pytest.mark.parametrize(
    ("dialect", "there"),
    [
        ("step7", {"TIP_Buffer_line1"}),
        ("iec", {"TIP_Adapters", "typeTipAdapter"}),
        ("twincat", {"TIP_Adapters", "typeTipAdapter"}),
        ("plcopen", {"TIP_Adapters", "typeTipAdapter"}),
    ],
)
def test_a_dialect_has_the_module_of_its_plc(dialect: str, there: set[str]) -> None:
    blocks = _blocks(in_dialect(_plant(), dialect, CATALOG))
    assert there <= blocks
    assert not blocks & ({"TIP_Buffer_line1", "TIP_Adapters", "typeTipAdapter"} - there)


def test_the_data_block_of_a_cp_has_the_number_that_its_instructions_name() -> None:
    files = generate(in_dialect(_plant(), "step7", CATALOG), CATALOG).files
    table = next(file.text for file in files if file.name.endswith(".sdf"))
    assert '"TIP_Buffer_line1        ","DB    399' in table
    assert sum("DB_NO := 399" in file.text for file in files) == 1


def test_names_have_the_prefix_of_the_plant() -> None:
    blocks = _blocks(changed(_plant(), CATALOG, prefix="HALL_"))
    assert {"HALL_TIP_Drive", "HALL_TIP_Serial_line1", "typeHallTipPort"} <= blocks


def _texts(plant: Plant) -> dict[str, str]:
    return {file.name: file.text for file in generate(plant, CATALOG).files}


@pytest.mark.parametrize("frames", [None, "instruction"])
def test_modbus_goes_by_the_instruction_of_the_cpu(frames: str | None) -> None:
    texts = _texts(changed(_plant("modbus"), CATALOG, modbus_frames=frames))
    assert "#instMaster(REQ := #send" in texts["TIP_Port_line1.scl"]
    assert "outBytes" not in texts["typeTipPort.udt"]
    assert "tempCrc" not in texts["MB_Telegram.scl"]
    assert "S7_Optimized_Access := 'FALSE'" in texts["TIP_Buffer_line1.db"]


def test_modbus_goes_by_own_frames_where_they_are_chosen() -> None:
    texts = _texts(changed(_plant("modbus"), CATALOG, modbus_frames="own"))
    assert "#instSend(REQ := #port.send" in texts["TIP_Port_line1.scl"]
    assert "outcome" not in texts["typeTipPort.udt"]
    assert "tempCrc" in texts["MB_Telegram.scl"]
    assert "TIP_Buffer_line1.db" not in texts


@pytest.mark.parametrize(("wires", "series", "mode"), [(4, "vf-s11", 1), (2, "vf-s15", 4)])
@pytest.mark.parametrize(("parity", "code"), [("none", 0), ("odd", 1), ("even", 2)])
def test_the_program_tells_the_module_what_the_line_is(
    wires: int, series: str, mode: int, parity: str, code: int
) -> None:
    written = (
        "version: 1\nname: hall\ndialect: tia\nplc: s7-1500\nserial:\n  - name: line1\n"
        "    hardware_identifier: 271\n    protocol: modbus\n    baud: 9600\n"
        f"    wires: {wires}\n    parity: {parity}\n    drives:\n"
        f"      - {{name: pump, inv_no: 1, series: {series}, max_frequency_hz: 50.0}}\n"
    )
    text = _texts(read_plant(Source("hall.yaml", written), CATALOG))["TIP_Port_line1.scl"]
    assert f"#instLoad.MODE := {mode};" in text
    assert "#instLoad.LINE_PRE := 2;" in text
    assert f"PARITY := {code}," in text
    assert "BAUD := 9600," in text
    assert "PORT := 271," in text


def test_lines_of_both_protocols_share_what_goes_to_a_module() -> None:
    plant = _plant("modbus")
    (line,) = plant.serial
    drives = tuple(
        one.model_copy(update={"name": f"{one.name}_t", "span": one.span}) for one in line.drives
    )
    other = line.model_copy(
        update={
            "name": "line2",
            "protocol": "toshiba_binary",
            "hardware_identifier": 271,
            "drives": drives,
        }
    )
    texts = _texts(changed(plant, CATALOG, serial=(line, other)))
    assert "#instMaster(" in texts["TIP_Port_line1.scl"]
    assert "#instSend(" in texts["TIP_Port_line2.scl"]
    assert {"outBytes", "outcome"} <= set(texts["typeTipPort.udt"].split())


@pytest.mark.parametrize("dialect", ["step7", "iec", "twincat", "plcopen"])
def test_another_dialect_builds_the_frames(dialect: str) -> None:
    plant = changed(_plant("modbus"), CATALOG, modbus_frames="instruction")
    other = in_dialect(plant, dialect, CATALOG)
    assert other.modbus_frames is None
    assert not any("Modbus_Master" in text for text in _texts(other).values())


def test_series_that_one_text_cannot_serve() -> None:
    with pytest.raises(DiagnosticError) as failure:
        generate(load_plant(BAD / "FB5017_two_ports.yaml", CATALOG), CATALOG)
    assert [item.code for item in failure.value.diagnostics] == ["FB5017"]


@pytest.mark.parametrize(
    ("wires", "first", "second"),
    [(4, "vf-a7", "vf-p7"), (2, "vf-s15", "vf-mb1"), (2, "vf-s9", "vf-nc1"), (2, "vf-s7", "g7")],
)
def test_series_of_which_only_the_manuals_differ_share_a_line(
    wires: int, first: str, second: str
) -> None:
    text = (
        "version: 1\nname: hall\ndialect: tia\nplc: s7-1500\nsequences: [check_parameters]\n"
        f"serial:\n  - name: line1\n    hardware_identifier: 270\n    wires: {wires}\n    drives:\n"
        f"      - {{name: pump, inv_no: 1, series: {first}, max_frequency_hz: 50.0}}\n"
        f"      - {{name: fan, inv_no: 2, series: {second}, max_frequency_hz: 50.0}}\n"
    )
    plant = read_plant(Source("hall.yaml", text), CATALOG)
    assert generate(plant, CATALOG).files


@pytest.mark.parametrize(
    ("line", "code"),
    [
        ("hardware_identifier: 270, wires: 2, series: vf-s11", "FB2052"),
        ("hardware_identifier: 270, protocol: modbus, inv_no: 0, series: vf-s11", "FB2007"),
        ("hardware_identifier: 270, inv_no: 64, series: vf-s11", "FB2007"),
        ("hardware_identifier: 270, protocol: modbus, series: vf-nc1", "FB2052"),
        ("address: 256, series: vf-s11", "FB2017"),
    ],
)
def test_what_a_line_cannot_be(line: str, code: str) -> None:
    parts = dict(one.split(": ") for one in line.split(", "))
    series, number = parts.pop("series"), parts.pop("inv_no", "1")
    keys = "".join(f"    {key}: {value}\n" for key, value in parts.items())
    text = (
        "version: 1\nname: hall\ndialect: tia\nplc: s7-1500\nserial:\n  - name: line1\n"
        f"{keys}    drives:\n"
        f"      - {{name: pump, inv_no: {number}, series: {series}, max_frequency_hz: 50.0}}\n"
    )
    with pytest.raises(DiagnosticError) as failure:
        read_plant(Source("hall.yaml", text), CATALOG)
    assert code in {item.code for item in failure.value.diagnostics}
