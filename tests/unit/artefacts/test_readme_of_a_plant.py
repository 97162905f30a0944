"""README.md in the output folder: every name in it is there, every figure the calculated one."""

import re
from pathlib import Path

import pytest

from fbgen.artefacts.memory import work_memory
from fbgen.artefacts.readme import readme
from fbgen.artefacts.view import PlantLists
from fbgen.blocks.line_times import line_times
from fbgen.lang import ast
from fbgen.plant import in_dialect, read_plant
from fbgen.source import Source
from tests.unit.artefacts.reading import FIVE_DRIVES, TWO_GATEWAYS, data, generated
from tests.unit.blocks.programs import shipped_catalog

DIALECTS = ["tia", "step7", "iec", "twincat", "plcopen"]
LANGUAGES = ["en", "de"]


MODBUS = (Path(__file__).parents[3] / "examples" / "modbus" / "plant.yaml").read_text("utf-8")


def page(dialect: str, language: str = "en", text: str = TWO_GATEWAYS) -> str:
    catalog = shipped_catalog()
    made = generated(text, dialect)
    plant = in_dialect(read_plant(Source("plant.yaml", text), catalog), dialect, catalog)
    lists = PlantLists(plant, catalog, made, language)
    others = [item for item in made.artefacts if item.name != "README.md"]
    return readme(lists, work_memory(lists), others).data.decode("utf-8")


def rows(text: str, heading: str) -> list[list[str]]:
    """The cells of the table below a heading, without the names of the columns."""
    part = text.partition(f"\n## {heading}\n")[2].partition("\n## ")[0]
    found = [line.strip("| ").split(" | ") for line in part.splitlines() if line.startswith("|")]
    return [[cell.strip(" `|") for cell in row] for row in found[2:]]


@pytest.mark.parametrize("dialect", DIALECTS)
def test_it_lists_every_file_of_the_folder(dialect: str) -> None:
    names = {name for name in generated(dialect=dialect).contents if name != "README.md"}
    assert {row[0] for row in rows(page(dialect), "Files")} == names


@pytest.mark.parametrize("dialect", DIALECTS)
def test_it_lists_every_block_with_its_purpose(dialect: str) -> None:
    canonical = generated(dialect=dialect).canonical
    assert canonical is not None
    named = [
        unit.name.name
        for file in canonical.units
        for unit in file.units
        if isinstance(unit, ast.Block | ast.DataBlock | ast.TypeDeclaration)
    ]
    listed = rows(page(dialect), "Blocks")
    assert [row[0] for row in listed] == named
    assert all(len(row[3 if dialect == "step7" else 2]) > 3 for row in listed)


def test_the_numbers_are_those_of_the_symbol_table() -> None:
    table = data("hall.sdf", dialect="step7").decode("ascii")
    numbers = dict(re.findall(r'"(\w+) *","(\w+ +\d+) *"', table))
    listed = {row[0]: row[2] for row in rows(page("step7"), "Blocks")}
    assert {name: number.replace(" ", "") for name, number in numbers.items()} == {
        name: number for name, number in listed.items() if not name.startswith("OB")
    }


WARNINGS = {
    "en": (
        "None of these blocks is a safety function",
        "Never tried on real hardware",
        "watchdog must be on",
        "With the PLC in STOP the drives go on running",
        "a drive that has lost its gateway runs on for ever",
        "Stop the drives first",
        "`run` has to be FALSE once",
        "an emergency stop, a missing interlock, `coast` or `dcBrake`",
        "nothing of `control` holds it but `emergencyStop`",
    ),
    "de": (
        "Keiner dieser Bausteine ist eine Sicherheitsfunktion",
        "Nie an echter Hardware erprobt",
        "Watchdog",
        "Mit der Steuerung in STOP laufen die Antriebe weiter",
        "läuft ein Antrieb, der sein Gateway verloren hat, immer weiter",
        "Zuerst die Antriebe anhalten",
        "`run` muss einmal FALSE sein",
        "Nothalt, fehlender Verriegelung, `coast` oder `dcBrake`",
        "nichts von `control` hält den Antrieb an außer `emergencyStop`",
    ),
}


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("dialect", DIALECTS)
def test_it_says_what_must_not_be_overlooked(dialect: str, language: str) -> None:
    text = page(dialect, language)
    one_text = dialect in ("iec", "plcopen")
    flowing = " ".join(text.split())
    for word in (*WARNINGS[language], "ESCO1803.GSD", "`parameters:`" if one_text else "FB5023"):
        assert word in flowing
    assert ("OB100" in text) is (dialect in ("tia", "step7"))
    assert ("OB86" in text) is (dialect == "step7")
    assert "gsd10: `30 30 20 30 30 70 20 70`" in text
    assert "doc9: `30 30 20 30 30 70 70`" in text


CHANNELS = """\
version: 1
name: hall
dialect: tia
plc: s7-1500
gateways:
  - name: north
    type: pbdp110
    layout: {layout}
    profibus_address: 2
    access: dpxx_dat
    hardware_identifier: 270
    drives: [{{name: pump, channel: A, series: vf-s11, max_frequency_hz: 50.0}}]
"""


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize(("layout", "has_parameters"), [("module1", True), ("module3", False)])
def test_of_process_data_it_tells_what_the_module_can_do(
    layout: str, has_parameters: bool, language: str
) -> None:
    text = page("tia", language, CHANNELS.format(layout=layout))
    assert ("`TOS_Plant.north.pump.parameter`" in text) is has_parameters
    assert ("8501" in text) is has_parameters
    assert ("`control.reset`" in text) is not has_parameters
    # nothing of lines, sequences and tags that this plant does not have
    assert not re.search(r"8402|8406|8407|8408|[Tt]rigger|inverter number|^6\. ", text, re.M)
    assert re.findall(r"^(\d)\. ", text, re.M) == ["1", "2", "3", "4", "5"]


@pytest.mark.parametrize(
    ("language", "who"),
    [("en", "Each drive at a line: F800"), ("de", "Jeder Antrieb an einer Linie: F800")],
)
def test_only_the_drives_of_lines_are_set_to_the_speed_of_the_line(language: str, who: str) -> None:
    channels = CHANNELS.format(layout="module1").partition("gateways:\n")[2]
    mixed = TWO_GATEWAYS + channels.replace("north", "west").replace("pump", "mill").replace(
        "profibus_address: 2", "profibus_address: 9"
    )
    assert who in page("tia", language, mixed)
    assert who not in page("tia", language)
    assert "F800 = 4" in page("tia", language)


@pytest.mark.parametrize("language", LANGUAGES)
def test_only_the_section_of_the_dialect_is_there(language: str) -> None:
    tools = {"tia": "TIA Portal", "step7": "S7-SCL", "twincat": "TwinCAT 3", "iec": "MATIEC"}
    for dialect in tools:
        text = page(dialect, language)
        assert [name for name, tool in tools.items() if tool in text] == [dialect]


def test_the_sources_of_step7_stand_in_the_order_in_which_they_compile() -> None:
    listed = re.findall(r"^ +\d\. `(\S+)`", page("step7"), re.MULTILINE)
    assert listed == [
        "hall.scl", "hall_parameters.scl", "hall_calls.scl", "hall_error_obs.scl",
    ]  # fmt: skip


@pytest.mark.parametrize("language", LANGUAGES)
def test_in_the_order_of_the_readme_each_block_of_step7_finds_what_it_names(language: str) -> None:
    text = TWO_GATEWAYS + "files: per_block\n"
    shown = page("step7", language, text)
    order = re.findall(r"^ +\d+\. `(\S+\.scl)`", shown, re.MULTILINE)
    contents = generated(text, "step7").contents
    assert sorted(order) == sorted(name for name in contents if name.endswith(".scl"))
    blocks = {name.removesuffix(".scl") for name in order}
    for number, name in enumerate(order, start=1):
        named = set(re.findall(r'"(\w+)"', contents[name].decode("ascii"))) & blocks
        assert named <= {earlier.removesuffix(".scl") for earlier in order[:number]}


def test_a_control_file_is_spoken_of_only_where_there_are_many_sources() -> None:
    apart = TWO_GATEWAYS + "files: per_block\n"
    assert "compile control file" in page("step7", text=apart)
    assert "Übersetzungssteuerdatei" in page("step7", "de", apart)
    assert "control file" not in page("step7") + page("tia", text=apart)


def test_poll_and_memory_are_the_calculated_ones() -> None:
    text = page("tia", text=FIVE_DRIVES)
    ((_, drives, reads, one, round_ms),) = rows(text, "Poll cycle")
    assert (drives, reads) == ("5", "20")
    assert float(round_ms.removesuffix(" ms")) == 20 * float(one.removesuffix(" ms"))
    sizes = [int(row[3]) for row in rows(text, "Blocks") if row[1] != "UDT"]
    found = re.search(r"Code about (\d+) bytes .* data\s+(\d+) bytes", text, re.DOTALL)
    assert found
    assert int(found[1]) + int(found[2]) == sum(sizes)
    assert {row[0].rstrip(" *") for row in rows(text, "Work memory")} >= {"1511-1", "1513-1"}


def test_the_worst_cases_are_those_that_the_sweep_measures() -> None:
    catalog = shipped_catalog()
    plant = read_plant(Source("plant.yaml", TWO_GATEWAYS), catalog)
    expected = []
    for entry in plant.gateways:
        times = line_times(plant, entry, catalog)
        figures = (times.telegram_ms, times.wait_ms, times.emergency_stop_ms)
        expected.append([entry.name, *(f"{figure:.0f} ms" for figure in figures)])
    assert rows(page("tia"), "Worst cases") == expected
    assert rows(page("tia", "de"), "Ungünstigste Fälle") == expected


@pytest.mark.parametrize(
    ("frames", "language", "said", "not_said"),
    [
        ("instruction", "en", "The program sets the module by Modbus_Comm_Load", "to freeport"),
        ("instruction", "de", "Das Modul stellt das Programm mit Modbus_Comm_Load", "auf Freeport"),
        ("own", "en", "Set the module to freeport", "Modbus_Comm_Load"),
        ("own", "de", "Das Modul auf Freeport stellen", "Modbus_Comm_Load"),
    ],
)
def test_it_says_how_the_module_of_a_line_is_set(
    frames: str, language: str, said: str, not_said: str
) -> None:
    text = MODBUS.replace("serial:", f"modbus_frames: {frames}\nserial:", 1)
    written = page("tia", language, text)
    assert said in written
    assert not_said not in written


def test_only_a_watch_table_is_called_one() -> None:
    named = {row[0] for row in rows(page("tia"), "Files") if row[1] == "a watch table"}
    assert named == {name for name in generated().contents if "_watch_" in name}


def test_a_layout_that_no_gsd_file_has_is_called_invented() -> None:
    text = TWO_GATEWAYS.replace("layout: doc9", "layout: whole10")
    assert "no GSD file offers this module" in page("tia", text=text)
    assert "no GSD file offers this module" not in page("tia")


def test_a_template_of_the_users_own_takes_its_place(tmp_path: Path) -> None:
    own = tmp_path / "docs" / "README.en.md.jinja"
    own.parent.mkdir()
    own.write_text("Our hall: {{ main }}\n", "utf-8")
    catalog = shipped_catalog()
    plant = read_plant(Source("plant.yaml", TWO_GATEWAYS), catalog)
    lists = PlantLists(plant, catalog, generated(), "en")
    made = readme(lists, work_memory(lists), [], [tmp_path])
    assert made.data == b"Our hall: TOS_Main\n"


SERIAL = """\
version: 1
name: hall
dialect: tia
plc: {plc}
serial:
  - name: line1
    hardware_identifier: 270
    address: 256
    {line}
    drives:
      - {{name: pump, inv_no: 1, series: {series}, max_frequency_hz: 50.0}}
"""


def serial_page(
    dialect: str, plc: str = "s7-1500", line: str = "baud: 9600", series: str = "vf-s11"
) -> str:
    return page(dialect, text=SERIAL.format(plc=plc, line=line, series=series))


@pytest.mark.parametrize("dialect", DIALECTS)
def test_without_gateways_nothing_is_said_of_their_bytes(dialect: str) -> None:
    text = serial_page(dialect)
    assert "gateway's bytes" not in text
    assert "io.csv" not in text
    assert "error_obs" not in text
    numbers = [int(one) for one in re.findall(r"^(\d)\. ", text, re.M)]
    assert numbers == list(range(1, len(numbers) + 1))


@pytest.mark.parametrize(
    ("plc", "dialect", "line", "says"),
    [
        ("s7-1500", "tia", "wires: 4", "four-wire, point-to-point (multipoint master is offered"),
        ("s7-1200", "tia", "wires: 4", "four-wire, point-to-point. Initial"),
        ("s7-300", "tia", "baud: 9600", "four characters (5 ms at `line1`)"),
        ("s7-400", "step7", "wires: 4", "SEND_440, RECV_440 come from the library"),
        ("s7-300", "step7", "module: cp_341", "P_SND_RK, P_RCV_RK come from the library"),
        ("s7-300", "tia", "module: cp_341", "P_SND_RK, P_RCV_RK are instructions of"),
        ("s7-300", "tia", "wires: 4", "The import gives other numbers"),
    ],
)
def test_it_says_what_is_set_at_each_module(plc: str, dialect: str, line: str, says: str) -> None:
    text = serial_page(dialect, plc, line)
    assert says in text
    assert "R(A) 0 V, R(B) 5 V" in text.replace("\n", " ")


@pytest.mark.parametrize(
    ("series", "line", "wires", "settings"),
    [
        ("vf-s11", "baud: 9600", "T(B) to RXA and T(A) to RXB", "F800 = 3 (9600 bit/s)"),
        ("vf-a7", "baud: 9600", "RXA 4, RXB 5, TXA 3, TXB 6", "F820 = 3 (9600 bit/s)"),
        ("vf-as1", "wires: 2", "R(B)/T(B) to A and R(A)/T(A) to B", "F807 = 0 (Toshiba"),
        ("vf-as1", "protocol: modbus", "R(B) to TXA", "F829 = 1 (MODBUS-RTU)"),
    ],
)
def test_wires_and_settings_are_those_of_the_port(
    series: str, line: str, wires: str, settings: str
) -> None:
    text = serial_page("tia", line=line, series=series)
    assert wires in text
    assert settings in text
    assert "Toshiba calls the positive wire of a pair A, Siemens B" in text
