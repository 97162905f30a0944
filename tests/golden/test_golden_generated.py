"""The generated text of the example plants, line for line.

The files beside this test change only by `pytest --update-golden`. All files of a plant stand in
one golden file, each below a line with its name. The hash of the inputs and fbgen's version are
masked: they change with every comment in the catalogue, and tests of their own look at them.
"""

import os
import re
import subprocess
import sys
from collections.abc import Callable, Mapping
from pathlib import Path

import pytest

import fbgen
from fbgen.artefacts import with_artefacts
from fbgen.catalog import load_catalog
from fbgen.emit.generated import GeneratedSet
from fbgen.emit.generator import generate
from fbgen.plant import read_plant
from fbgen.source import Source

ROOT = Path(__file__).parents[2]
EXAMPLES = ROOT / "examples"

MANUAL_EXAMPLE = (EXAMPLES / "manual_example" / "plant.yaml").read_text("utf-8")
FIVE_DRIVES = (EXAMPLES / "five_drives" / "plant.yaml").read_text("utf-8")
PBDP110 = (EXAMPLES / "pbdp110" / "plant.yaml").read_text("utf-8")
CHANNELS = (ROOT / "tests" / "scenarios" / "devicenet" / "two_channels.yaml").read_text("utf-8")
SERIAL = (EXAMPLES / "serial" / "plant.yaml").read_text("utf-8")
BY_WORDS = {
    "layout: module2": "layout: module2\n    identifiers: 6F 5F 57",
    "access: dpxx_dat": "access: per_identifier",
    "hardware_identifier: 270": "input_address: 256\n    output_address: 256\n"
    "    diagnosis_address: 2046",
}
WHOLE_FRAME = {
    "access: per_identifier": "access: dpxx_dat\n    hardware_identifier: 270",
    "    input_address: 256\n": "",
    "    output_address: 256\n": "",
}
STEP7 = {"dialect: tia": "dialect: step7", "plc: s7-1500": "plc: s7-300"}
IEC = {
    "dialect: tia": "dialect: iec",
    "plc: s7-1500": "plc: iec",
    "access: per_identifier": "access: process_image",
    "address: 256": "address: 0",
}

TWINCAT = {"dialect: tia": "dialect: twincat", "plc: s7-1500": "plc: twincat"}
PLCOPEN = {"dialect: tia": "dialect: plcopen"}


def changed(text: str, changes: Mapping[str, str]) -> str:
    """The plant file with each text replaced; every one must be there."""
    for old, new in changes.items():
        assert old in text, old
        text = text.replace(old, new)
    return text


PLANTS = {
    "pbdp110.tia": PBDP110,
    "pbdp110_by_words.step7": changed(PBDP110, BY_WORDS | STEP7),
    "devicenet_channels.tia": CHANNELS,
    "manual_example_gsd10.tia": MANUAL_EXAMPLE,
    "manual_example_doc9.tia": changed(MANUAL_EXAMPLE, {"layout: gsd10": "layout: doc9"}),
    "manual_example_whole10.tia": changed(
        MANUAL_EXAMPLE, {"layout: gsd10": "layout: whole10"} | WHOLE_FRAME
    ),
    "manual_example_whole10_s7_300.tia": changed(
        MANUAL_EXAMPLE,
        {
            "layout: gsd10": "layout: whole10",
            "access: per_identifier": "access: dpxx_dat",
            "plc: s7-1500": "plc: s7-300",
        },
    ),
    "manual_example_process_image.tia": changed(
        MANUAL_EXAMPLE,
        {"access: per_identifier": "access: process_image", "address: 256": "address: 0"},
    ),
    "manual_example_gsd10.step7": changed(MANUAL_EXAMPLE, STEP7),
    "manual_example_whole10.step7": changed(
        MANUAL_EXAMPLE,
        STEP7 | {"layout: gsd10": "layout: whole10", "access: per_identifier": "access: dpxx_dat"},
    ),
    "manual_example_process_image.step7": changed(
        MANUAL_EXAMPLE,
        STEP7 | {"access: per_identifier": "access: process_image", "address: 256": "address: 0"},
    ),
    "manual_example.iec": changed(MANUAL_EXAMPLE, IEC),
    "manual_example.twincat": changed(MANUAL_EXAMPLE, IEC | TWINCAT),
    "manual_example.plcopen": changed(MANUAL_EXAMPLE, IEC | PLCOPEN),
    "five_drives.tia": FIVE_DRIVES,
    "five_drives.step7": changed(FIVE_DRIVES, STEP7),
    "five_drives.iec": changed(FIVE_DRIVES, IEC),
    "serial.tia": SERIAL,
}
PORTS = {
    "serial_port.step7": changed(SERIAL, STEP7),
    "serial_port_cp_341.step7": changed(SERIAL, STEP7 | {"    wires: 4": "    module: cp_341"}),
    "serial_port.iec": changed(
        SERIAL, {"dialect: tia": "dialect: iec", "plc: s7-1500": "plc: iec"}
    ),
}
"""The same line at other modules: only what reaches the module differs from `serial.tia`."""

PARTS_OF_PORTS = re.compile(
    r'^(FUNCTION_BLOCK|DATA_BLOCK) "?(?:TIP_Port_|TIP_Buffer_).*?^END_\1\n',
    re.DOTALL | re.MULTILINE,
)


def generated(text: str) -> GeneratedSet:
    """What is generated for a plant file of this text."""
    catalog = load_catalog()
    return generate(read_plant(Source("plant.yaml", text), catalog), catalog)


def in_one(files: GeneratedSet) -> str:
    """All files in their order, each below a line with its name."""
    text = "".join(f"===== {file.name}\n{file.text}" for file in files.files)
    return text.replace(f"fbgen {fbgen.__version__} ", "fbgen VERSION ").replace(
        files.inputs_hash, "HASH"
    )


@pytest.mark.parametrize("name", PLANTS)
def test_the_generated_text_is_as_before(name: str, golden: Callable[[str, str], None]) -> None:
    golden(f"{name}.txt", in_one(generated(PLANTS[name])))


@pytest.mark.parametrize("name", PORTS)
def test_the_text_of_a_port_is_as_before(name: str, golden: Callable[[str, str], None]) -> None:
    text = in_one(generated(PORTS[name]))
    golden(f"{name}.txt", "\n".join(part[0] for part in PARTS_OF_PORTS.finditer(text)))


def test_every_golden_file_is_compared() -> None:
    kept = {path.name.removesuffix(".txt") for path in Path(__file__).parent.glob("*.txt")}
    assert kept == {*PLANTS, *PORTS}


@pytest.mark.parametrize(
    "name", ["manual_example_gsd10.tia", "manual_example_gsd10.step7", "manual_example.iec"]
)
def test_each_file_carries_the_version_and_a_hash_of_its_inputs(name: str) -> None:
    files = generated(PLANTS[name])
    for file in (one for one in files.files if one.is_program):
        heading = re.match(
            r"(?://|\(\*) Generated by fbgen (\S+) for plant (\S+), inputs (\S+)", file.text
        )
        assert heading, file.name
        assert heading.groups() == (fbgen.__version__, "manual_example", files.inputs_hash)


def test_the_hash_follows_the_plant_file() -> None:
    other = changed(MANUAL_EXAMPLE, {"inv_no: 11": "inv_no: 12"})
    assert generated(MANUAL_EXAMPLE).inputs_hash != generated(other).inputs_hash
    assert generated(MANUAL_EXAMPLE).inputs_hash == generated(MANUAL_EXAMPLE).inputs_hash


@pytest.mark.parametrize(
    "surroundings",
    [
        {"PYTHONHASHSEED": "1", "LC_ALL": "C", "LANG": "C"},
        {"PYTHONHASHSEED": "4711", "LC_ALL": "tr_TR.UTF-8", "LANG": "tr_TR.UTF-8"},
        {"PYTHONHASHSEED": "0", "LC_ALL": "C", "PYTHONUTF8": "0", "TZ": "Asia/Kathmandu"},
    ],
)
def test_another_process_with_other_surroundings_writes_the_same_bytes(
    surroundings: dict[str, str], tmp_path: Path
) -> None:
    plant = EXAMPLES / "five_drives" / "plant.yaml"
    command = [sys.executable, "-m", "fbgen.cli", "generate", str(plant), "-o", str(tmp_path)]
    environment = os.environ | {"PYTHONPATH": str(ROOT)} | surroundings
    run = subprocess.run(
        command, env=environment, cwd=tmp_path, capture_output=True, text=True, check=False
    )
    assert run.returncode == 0, run.stderr
    catalog = load_catalog()
    files = with_artefacts(
        generated(FIVE_DRIVES), read_plant(Source("plant.yaml", FIVE_DRIVES), catalog), catalog
    )
    assert files.contents == {
        path.name: path.read_bytes() for path in tmp_path.iterdir() if path.suffix != ".json"
    }
