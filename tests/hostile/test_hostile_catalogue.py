"""Catalogues and plants of somebody else's: no text of theirs becomes PLC code or a path."""

from pathlib import Path
from typing import Any

import pytest
import yaml
from hypothesis import given, settings
from hypothesis import strategies as st

from fbgen.source import Source
from harness.engine.loading import read_program
from tests.hostile.attack import EXAMPLE, ROOT, Outcome, generate

EVIL = {
    "ends_a_line_comment": "x\n   #execute := TRUE;",
    "ends_a_block_comment": "x *) execute := TRUE; (*",
    "ends_a_block_comment_in_two_ways": "*) */ (* *) /* x",
    "nests_comments": "(*(*(*",
    "quotes": "\"'\"'$'$N",
    "line_comment": "// x",
    "pragma": "} { S7_Optimized_Access := 'TRUE' }",
    "ends_a_section": "x END_VAR END_STRUCT END_FUNCTION_BLOCK",
    "carriage_return": "x\r#execute := TRUE;",
    "line_separators": "x\u2028#execute := TRUE;\u2029\x85\x0b\x0c y",
    "nul": "x\x00y",
    "delete": "x\x7fy",
    "right_to_left": "\u202e;EURT =: x",
    "marks_of_origin": "\ue000999\ue001x\ue000",
    "jinja": "{{ ''.__class__ }}{% for x in y %}",
    "long": "x" * 4000,
    "long_words": "END_IF; " * 400,
    "backslash": "x\\",
    "umlauts": "Übergröße",
    "emoji": "\U0001f600",
    "surrogate_like": "\ufffe\uffff",
}


def plant(**changes: Any) -> str:
    """The example's plant file with other values at its top."""
    return yaml.safe_dump(yaml.safe_load(EXAMPLE.read_text("utf-8")) | changes, allow_unicode=True)


def with_entry(folder: Path, kind: str, entry: dict[str, Any], text: str) -> Outcome:
    """Generate with an entry of the attacker's in front of the shipped ones."""
    place = folder / "catalog" / kind
    place.mkdir(parents=True)
    (place / f"{entry['id']}.yaml").write_text(yaml.safe_dump(entry, allow_unicode=True), "utf-8")
    return generate(folder, "--catalog", str(folder / "catalog"), plant=text)


def sequence(**changes: Any) -> dict[str, Any]:
    """A sequence with one step, with other values."""
    return {
        "version": 1,
        "id": "evil",
        "title": "Title",
        "description": "Description.",
        "does_not_protect": "Nobody.",
        "source": "a manual",
        "series": ["vf-s11"],
        "parameters": [{"name": "value", "type": "WORD", "title": "Value"}],
        "results": [{"name": "current", "type": "WORD", "title": "Current"}],
        "steps": [
            {"write": "FA00", "parameter": "value", "title": "Write"},
            {"read": "FE03", "into": "current", "title": "Read"},
        ],
    } | changes


def code(text: str) -> str:
    """The text of a file without its comments, titles, blanks and the hash of the inputs."""
    lines = (line.partition("//")[0].strip() for line in text.splitlines())
    kept = (line for line in lines if line and not line.startswith("TITLE"))
    return "\n".join(line for line in kept if "inputsHash :=" not in line)


def program_of(outcome: Outcome) -> dict[str, str]:
    """The PLC text of what was written, by file name."""
    return {
        name: data.decode("ascii")
        for name, data in outcome.written.items()
        if Path(name).suffix in (".scl", ".udt", ".db", ".st")
    }


def evil_everywhere(text: str) -> dict[str, Any]:
    """A sequence with a text wherever one can stand."""
    return sequence(
        title=text,
        description=text,
        does_not_protect=text,
        source=text,
        parameters=[{"name": "value", "type": "WORD", "title": text, "unit": text}],
        results=[{"name": "current", "type": "WORD", "title": text, "unit": text}],
        steps=[
            {"write": "FA00", "parameter": "value", "title": text},
            {"read": "FE03", "into": "current", "title": text},
        ],
    )


@pytest.fixture(scope="module")
def harmless(tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    """The code of each file with a harmless sequence."""
    outcome = with_entry(
        tmp_path_factory.mktemp("harmless"), "sequences", sequence(), plant(sequences=["evil"])
    )
    assert outcome.status == 0, outcome.said
    return {name: code(text) for name, text in program_of(outcome).items()}


@pytest.mark.parametrize("name", EVIL)
def test_texts_of_a_sequence_stay_in_comments(
    name: str, tmp_path: Path, harmless: dict[str, str]
) -> None:
    outcome = with_entry(
        tmp_path, "sequences", evil_everywhere(EVIL[name]), plant(sequences=["evil"])
    )
    assert "Traceback" not in outcome.said
    if outcome.status:
        assert outcome.written == {}
        assert "error[FB1" in outcome.said
        return
    assert {file: code(text) for file, text in program_of(outcome).items()} == harmless


@given(text=st.text(min_size=1, max_size=60).filter(str.strip))
@settings(max_examples=15)
def test_whatever_the_text_the_code_stays(
    text: str, tmp_path_factory: pytest.TempPathFactory, harmless: dict[str, str]
) -> None:
    outcome = with_entry(
        tmp_path_factory.mktemp("any"),
        "sequences",
        evil_everywhere(text),
        plant(sequences=["evil"]),
    )
    assert "Traceback" not in outcome.said
    if outcome.status == 0:
        assert {file: code(text) for file, text in program_of(outcome).items()} == harmless


@pytest.mark.parametrize("dialect", ["tia", "iec"])
@pytest.mark.parametrize("name", ["ends_a_block_comment", "nests_comments", "quotes", "pragma"])
def test_what_is_generated_with_an_evil_text_is_read_back(
    name: str, dialect: str, tmp_path: Path
) -> None:
    gateway = yaml.safe_load(EXAMPLE.read_text("utf-8"))["gateways"][0]
    gateway |= {"access": "process_image", "input_address": 0, "output_address": 0}
    outcome = with_entry(
        tmp_path,
        "sequences",
        evil_everywhere(EVIL[name]),
        plant(
            sequences=["evil"],
            gateways=[gateway],
            dialect=dialect,
            plc="iec" if dialect == "iec" else "s7-1500",
        ),
    )
    assert outcome.status == 0, outcome.said
    program = read_program([Source(*file) for file in program_of(outcome).items()], dialect)
    assert "tos_seq_evil" in program.blocks


@pytest.mark.parametrize(
    "default", ["0; x := TRUE", "T#1s;", "16#0 // x", "(* x", "1E9", "TRUE", "16#12345", "'x'"]
)
def test_a_default_that_is_none_is_refused(default: str, tmp_path: Path) -> None:
    entry = sequence(
        parameters=[{"name": "value", "type": "WORD", "title": "Value", "default": default}]
    )
    with_entry(tmp_path, "sequences", entry, plant(sequences=["evil"])).refused("FB1107")


@pytest.mark.parametrize(
    "name", ["done", "channel", "stepnumber", "maxfrequency", "exit", "stat_x"]
)
def test_a_parameter_called_like_something_of_the_block_is_fb5007(
    name: str, tmp_path: Path
) -> None:
    entry = sequence(
        parameters=[{"name": name, "type": "WORD", "title": "Value"}],
        steps=[
            {"write": "FA00", "parameter": name},
            {"read": "FE03", "into": "current", "title": "Read"},
        ],
    )
    outcome = with_entry(tmp_path, "sequences", entry, plant(sequences=["evil"]))
    outcome.refused("FB5007")
    assert "evil.yaml:" in outcome.said


@pytest.mark.parametrize("name", ["polled", "end_if", "if", "var"])
def test_a_sequence_called_like_a_member_or_a_reserved_word_is_fb5007(
    name: str, tmp_path: Path
) -> None:
    with_entry(tmp_path, "sequences", sequence(id=name), plant(sequences=[name])).refused("FB5007")


@pytest.mark.parametrize(
    "name",
    [
        *(
            "../evil",
            "..",
            "/etc/x",
            "a/b",
            "a\\b",
            "a b",
            'x"',
            "x'",
            "x*)",
            "x//",
            "x}",
            "END_VAR",
        ),
        *("x\ny", "x\x00y", "\u202ex", "", "a" * 5000, "x;y", "1x", "_x", "x__y", "Main\n", "if"),
    ],
)
@pytest.mark.parametrize("kind", ["plant", "gateway", "drive"])
def test_a_name_of_the_plant_is_a_name_or_is_refused(kind: str, name: str, tmp_path: Path) -> None:
    data = yaml.safe_load(EXAMPLE.read_text("utf-8"))
    places = {
        "plant": data,
        "gateway": data["gateways"][0],
        "drive": data["gateways"][0]["drives"][0],
    }
    places[kind]["name"] = name
    outcome = generate(tmp_path, plant=yaml.safe_dump(data))
    assert outcome.status == 1
    assert "Traceback" not in outcome.said
    assert outcome.written == {}
    assert [item.name for item in tmp_path.iterdir()] == ["plant.yaml"]


def test_a_drive_called_like_a_variable_of_its_gateway_is_fb5007(tmp_path: Path) -> None:
    text = EXAMPLE.read_text("utf-8").replace("name: drive11", "name: Line")
    generate(tmp_path, plant=text).refused("FB5007")


@pytest.mark.parametrize("name", ["control", "state", "polled"])
def test_a_sequence_called_like_a_member_of_a_drive_is_fb5007(name: str, tmp_path: Path) -> None:
    entry = sequence(id=name)
    with_entry(tmp_path, "sequences", entry, plant(sequences=[name])).refused("FB5007")


def test_a_gateway_called_like_the_data_block_of_another_is_fb5007(tmp_path: Path) -> None:
    data = yaml.safe_load(EXAMPLE.read_text("utf-8"))
    gateway = data["gateways"][0]
    data["gateways"].append(
        gateway
        | {"name": "GW1_db", "profibus_address": 3, "input_address": 300, "output_address": 300}
    )
    data["gateways"][1]["drives"] = [gateway["drives"][0] | {"name": "other"}]
    generate(tmp_path, plant=yaml.safe_dump(data)).refused("FB5007")


@pytest.mark.parametrize("kind", ["gateway", "drive"])
def test_names_that_differ_only_by_case_are_refused(kind: str, tmp_path: Path) -> None:
    data = yaml.safe_load(EXAMPLE.read_text("utf-8"))
    gateway = data["gateways"][0]
    drive = gateway["drives"][0]
    if kind == "drive":
        gateway["drives"] = [drive, drive | {"name": "DRIVE11", "inv_no": 12}]
    else:
        other = {"name": "GW1", "profibus_address": 3, "input_address": 300}
        data["gateways"].append(
            gateway | other | {"output_address": 300, "drives": [drive | {"name": "d"}]}
        )
    generate(tmp_path, plant=yaml.safe_dump(data)).refused("FB2013")


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("{name: data, offset: 6", "{name: other, offset: 6"),
        (
            "{name: cmd, offset: 4, length: 1, title: Command}",
            "{name: cmd, offset: 4, length: 1, title: Command, pad: true}",
        ),
    ],
)
def test_a_layout_without_the_fields_of_a_telegram_is_fb5008(
    old: str, new: str, tmp_path: Path
) -> None:
    text = (ROOT / "catalog" / "gateways" / "tospbdp001.yaml").read_text("utf-8")
    assert old in text
    place = tmp_path / "catalog" / "gateways"
    place.mkdir(parents=True)
    (place / "tospbdp001.yaml").write_text(text.replace(old, new), "utf-8")
    outcome = generate(tmp_path, "--catalog", str(tmp_path / "catalog"))
    outcome.refused("FB5008")
    assert "tospbdp001.yaml:" in outcome.said


def test_gateways_of_two_types_are_fb5009(tmp_path: Path) -> None:
    text = (ROOT / "catalog" / "gateways" / "tospbdp001.yaml").read_text("utf-8")
    place = tmp_path / "catalog" / "gateways"
    place.mkdir(parents=True)
    other = text.replace("id: tospbdp001", "id: another")
    (place / "another.yaml").write_text(other, "utf-8")
    data = yaml.safe_load((ROOT / "examples" / "five_drives" / "plant.yaml").read_text("utf-8"))
    (gateway,) = data["gateways"]
    second = gateway | {
        "name": "gw2",
        "type": "another",
        "profibus_address": 3,
        "input_address": 300,
        "output_address": 300,
        "drives": [gateway["drives"][0] | {"name": "sixth"}],
    }
    data["gateways"] = [gateway, second]
    outcome = generate(tmp_path, "--catalog", str(tmp_path / "catalog"), plant=yaml.safe_dump(data))
    outcome.refused("FB5009")
    assert "'gw2' is a another, 'gw1' a tospbdp001" in outcome.said


def test_a_layout_whose_name_is_text_is_refused(tmp_path: Path) -> None:
    text = (ROOT / "catalog" / "gateways" / "tospbdp001.yaml").read_text("utf-8")
    place = tmp_path / "catalog" / "gateways"
    place.mkdir(parents=True)
    evil = text.replace("- name: gsd10", '- name: "x\\n#execute := TRUE;"')
    (place / "tospbdp001.yaml").write_text(evil, "utf-8")
    generate(tmp_path, "--catalog", str(tmp_path / "catalog")).refused("FB1007")
