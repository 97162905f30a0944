"""Options of a catalogue of one's own: what the simulation does not find is told by name."""

import pytest

from fbgen.catalog import DeviceNetGateway, load_yaml, validate
from fbgen.diagnostics import DiagnosticError
from fbgen.resources import shipped
from fbgen.source import Source
from fbgen.wire.devicenet import Service
from fbgen.wire.devicenet_messages import Request, Response
from harness.drives import Inverter
from harness.gateways.dev003z import Dev003z, Dev003zSettings
from harness.kernel import Kernel
from harness.line import Line
from tests.unit.devicenet.bench import CATALOG

TEXT = (shipped("catalog") / "gateways" / "dev003z.yaml").read_text("utf-8")
POLE_COUNT = "      - {id: 12, name: pole_count"


def made(old: str, new: str) -> Dev003z:
    assert old in TEXT
    source = Source("own.yaml", TEXT.replace(old, new, 1))
    gateway = validate(load_yaml(source), DeviceNetGateway)
    kernel = Kernel()
    drive = Inverter(kernel, Line(kernel), CATALOG.drive("vf-s15"))
    return Dev003z(kernel, gateway, drive, lambda _: None, Dev003zSettings())


@pytest.mark.parametrize(
    ("old", "new", "missing"),
    [
        ("- id: motor_poles", "- id: poles", "option 'motor_poles'"),
        ("name: timeout_time", "name: loss_delay", "parameter 'timeout_time'"),
        ("{bit: 9, name: reverse", "{bit: 9, name: backward", "bit 'reverse' of 'command'"),
        ("{bit: 1, name: warning", "{bit: 1, name: caution", "value for the bit 'caution'"),
        (
            "{bit: 2, name: fault_reset",
            "{bit: 2, name: reset",
            "bit 'fault_reset' of 'basic_control'",
        ),
        ("    maximum: 5\n    default: 0\n", "    maximum: 6\n    default: 0\n", "for c203 = 6"),
        (
            "{name: speed, offset: 2",
            "{name: rpm, offset: 2",
            "use for the field 'rpm' of instance 20",
        ),
        (
            "{name: frequency, offset: 2, length: 2, title: Output",
            "{name: hertz, offset: 2, length: 2, title: Output",
            "value for the field 'hertz' of instance 150",
        ),
        ("{bit: 15, name: write,", "{bit: 15, name: put,", "bit 'write' of 'index_request'"),
        ("    name: network_status", "    name: network", "lamp 'network_status'"),
        ("name: link_failure", "name: failure", "state 'link_failure' of the lamp"),
        ("product_name: DEV003Z", "product_name: D\u00c9V", "product_name of ASCII characters"),
        (", type: uint, default: 155}", ", type: uint}", "class attribute 2 of class 04"),
        (
            POLE_COUNT,
            "      - {id: 13, name: inertia, title: Inertia, type: uint}\n" + POLE_COUNT,
            "nor default:, of attribute 13 of class 28",
        ),
    ],
)
def test_what_the_simulation_does_not_find_is_told(old: str, new: str, missing: str) -> None:
    with pytest.raises(DiagnosticError) as raised:
        made(old, new)
    (found,) = raised.value.diagnostics
    assert found.code == "FB7107"
    assert missing in found.message
    assert found.span is not None


def kept(option: Dev003z, class_id: int, attribute: int) -> list[int]:
    """An attribute as it begins, and when it was set to 9."""
    found = []
    for _ in range(2):
        asked = Request(Service.GET_ATTRIBUTE_SINGLE, class_id, 1, bytes([attribute]))
        answer = option.serve(asked)
        assert isinstance(answer, Response)
        found.append(int.from_bytes(answer.data, "little"))
        put = Request(Service.SET_ATTRIBUTE_SINGLE, class_id, 1, bytes([attribute, 9, 0]))
        assert isinstance(option.serve(put), Response)
    return found


def test_an_attribute_of_ones_own_begins_with_its_default_and_keeps_what_is_set() -> None:
    row = (
        "      - {id: 13, name: inertia, title: Inertia, type: uint, settable: true, default: 5}\n"
    )
    option = made(POLE_COUNT, row + POLE_COUNT)
    assert kept(option, 0x28, 13) == [5, 9]
    heartbeat = "      - {id: 10, name: heartbeat_interval"
    row = "      - {id: 11, name: place, title: Place, type: uint, settable: true, default: 7}\n"
    option = made(heartbeat, row + heartbeat)
    assert kept(option, 1, 11) == [7, 9]
