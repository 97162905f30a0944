"""What a series can do on the wire: inheritance, names, quantities, and what contradicts itself."""

from pathlib import Path
from typing import Any

import pytest
import yaml

from fbgen.catalog import Communication, Drive, load_catalog, load_yaml, validate
from fbgen.catalog.communication_references import unresolved_communication
from fbgen.catalog.kinship import with_relative
from fbgen.diagnostics import DiagnosticError
from fbgen.resources import shipped
from fbgen.source import Source

CATALOG = load_catalog()
S11 = CATALOG.drive("vf-s11")
WITH = [drive for drive in CATALOG.drives.values() if drive.communication is not None]


def _of(drive: Drive) -> Communication:
    assert drive.communication is not None
    return drive.communication


def _codes(change: dict[str, Any]) -> list[tuple[str, str]]:
    """Codes and messages for a series like the VF-S11 with this communication of its own."""
    text = (shipped("catalog") / "drives" / "vf-s9.yaml").read_text("utf-8")
    data = {
        key: value
        for key, value in yaml.safe_load(text).items()
        if key in ("version", "title", "protocol", "source", "link", "times", "like")
    }
    data |= {"id": "mine", "communication": change}
    document = load_yaml(Source("mine.yaml", yaml.safe_dump(data)))
    try:
        drive = validate(with_relative(document, S11), Drive)
    except DiagnosticError as failure:
        return [(item.code, item.message) for item in failure.diagnostics]
    found = unresolved_communication(drive, _of(drive), CATALOG, CATALOG.protocols)
    return [(item.code, item.message) for item in found]


def _port(**changes: object) -> dict[str, object]:
    return {
        "name": "rs485",
        "title": "Port",
        "command": "command_word",
        "setpoint": "frequency_setpoint",
        "baud_rate": "baud_rate",
        "parity": "parity",
        "inv_no": "inverter_number",
        "timeout": "communication_timeout",
        "protocols": {0: "toshiba"},
        "source": "my manual",
    } | changes


def test_every_series_says_how_it_communicates() -> None:
    assert [drive.id for drive in CATALOG.drives.values() if drive not in WITH] == []


@pytest.mark.parametrize("drive", WITH, ids=lambda drive: drive.id)
def test_every_rate_and_parity_has_its_code(drive: Drive) -> None:
    for port in _of(drive).ports:
        rate, parity = drive.comno(port.baud_rate), drive.comno(port.parity)
        codes = range(rate.minimum_word, rate.maximum_word + 1)
        assert sorted(drive.baud_rates(port)) == list(codes)
        rates = [drive.baud_rates(port)[code] for code in codes]
        assert rates == sorted(set(rates))
        assert drive.parities(port)[parity.default_word] == "even"


def test_the_vf_s11_chooses_between_two_protocols() -> None:
    (port,) = _of(S11).ports
    assert (port.protocol, port.protocols) == ("protocol_selection", {0: "toshiba", 1: "modbus"})
    assert S11.comno("protocol_selection").hex == "0829"
    assert S11.baud_rates(port) == {0: 1200, 1: 2400, 2: 4800, 3: 9600, 4: 19200}
    assert S11.parities(port) == {0: "none", 1: "even", 2: "odd"}


def test_a_part_of_its_own_replaces_the_other_ones_and_the_rest_is_taken_over() -> None:
    drive = CATALOG.drive("vf-s9")
    known = _of(drive)
    assert known.modbus is None, "empty in its file: it has none, whatever the VF-S11 has"
    assert known.ports[0].protocols == {0: "toshiba"}
    assert known.ports[0].status == "verified"
    assert known.toshiba is not None
    assert known.toshiba.status == "unverified"
    assert (known.toshiba.source or "").startswith("as vf-s11: VF-S11 Communications")


def test_what_is_confirmed_is_verified_with_the_source_that_says_so(tmp_path: Path) -> None:
    text = (shipped("catalog") / "drives" / "vf-s9.yaml").read_text("utf-8")
    mine = text.replace("id: vf-s9\n", "id: mine\n").replace(
        "confirmed:\n",
        "confirmed:\n  - {communication: [toshiba], source: my manual}\n",
    )
    folder = tmp_path / "drives"
    folder.mkdir()
    (folder / "mine.yaml").write_text(mine, encoding="utf-8")
    toshiba = _of(load_catalog([tmp_path]).drive("mine")).toshiba
    assert toshiba is not None
    assert (toshiba.status, toshiba.source) == ("verified", "my manual")


@pytest.mark.parametrize(
    ("change", "code", "said"),
    [
        ({"ports": [_port(command="comand_word")]}, "FB1105", "no ComNo 'comand_word'"),
        ({"ports": [_port(protocols={0: "toshba"})]}, "FB1105", "no protocol 'toshba'"),
        ({"ports": [_port(), _port(name="b")]}, "FB1115", "'rs485' and 'b' have one command word"),
        ({"ports": [_port(), _port(command="free_notes")]}, "FB1102", "port 'rs485'"),
        ({"modbus": None}, "FB1115", "speaks 'modbus', and nothing says"),
        (
            {"modbus": {"source": "m", "exceptions": {"wrong_data": "no"}, "accesses": []}},
            "FB1105",
            "no exception 'no'",
        ),
        (
            {
                "modbus": {
                    "source": "m",
                    "exceptions": {},
                    "accesses": [
                        {
                            "function": "write",
                            "way": "direct",
                            "least_written": 1,
                            "most_written": 2,
                            "keeps": "ram",
                            "source": "m",
                        }
                    ],
                }
            },
            "FB1114",
            "'write' carries 1 words at most, not 2",
        ),
        (
            {
                "modbus": {
                    "source": "m",
                    "exceptions": {},
                    "accesses": [{"function": "red", "way": "identification", "source": "m"}],
                    "identification": {
                        "conformity": "01",
                        "vendor": "a",
                        "product": "b",
                        "revision": "c",
                        "source": "m",
                    },
                }
            },
            "FB1105",
            "no function 'red'",
        ),
        (
            {
                "modbus": {
                    "source": "m",
                    "exceptions": {},
                    "accesses": [
                        {
                            "function": "read",
                            "way": "direct",
                            "least_read": 1,
                            "most_read": 1,
                            "option": "bloks",
                            "source": "m",
                        }
                    ],
                }
            },
            "FB1105",
            "no option 'bloks'",
        ),
        (
            {
                "toshiba": {
                    "source": "m",
                    "forms": ["ascii"],
                    "commands": ["read_padded"],
                    "frame_end": "length",
                    "groups": True,
                }
            },
            "FB1115",
            "'read_padded' has only the form binary",
        ),
        (
            {
                "toshiba": {
                    "source": "m",
                    "forms": ["ascii"],
                    "commands": ["raed"],
                    "frame_end": "silence",
                    "groups": True,
                }
            },
            "FB1115",
            "silence that ends a telegram is not given",
        ),
    ],
)
def test_what_cannot_be_is_told(change: dict[str, Any], code: str, said: str) -> None:
    found = _codes(change)
    assert any(item[0] == code and said in item[1] for item in found), found


def test_a_rate_that_the_protocol_does_not_know_is_told(tmp_path: Path) -> None:
    text = (shipped("catalog") / "protocols" / "toshiba.yaml").read_text("utf-8")
    folder = tmp_path / "protocols"
    folder.mkdir()
    (folder / "toshiba.yaml").write_text(text.replace("[1200, ", "["), encoding="utf-8")
    with pytest.raises(DiagnosticError) as raised:
        load_catalog([tmp_path])
    found = raised.value.diagnostics[0]
    assert found.code == "FB1113"
    assert "'toshiba' knows no 1200 bit/s" in found.message


def test_a_protocol_of_the_other_kind_is_refused() -> None:
    assert CATALOG.modbus_protocol("modbus").function("read").code == 0x03
    assert CATALOG.toshiba_protocol("toshiba").command("block").code == 0x58
    with pytest.raises(DiagnosticError) as raised:
        CATALOG.toshiba_protocol("modbus")
    (found,) = raised.value.diagnostics
    assert (found.code, found.help) == ("FB1206", "a Toshiba inverter protocol is toshiba")


def test_a_kind_of_protocol_that_there_is_none_of_is_told(tmp_path: Path) -> None:
    text = (shipped("catalog") / "protocols" / "modbus.yaml").read_text("utf-8")
    folder = tmp_path / "protocols"
    folder.mkdir()
    (folder / "modbus.yaml").write_text(text.replace("kind: modbus", "kind: modbs"), "utf-8")
    with pytest.raises(DiagnosticError) as raised:
        load_catalog([tmp_path])
    found = raised.value.diagnostics[0]
    assert (found.code, found.message) == (
        "FB1007",
        "found 'modbs', expected one of: toshiba, modbus",
    )
