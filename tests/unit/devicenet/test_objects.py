"""Get and Set on every attribute of every object, and each general status code."""

import pytest

from fbgen.catalog.devicenet_objects import Attribute, ObjectClass
from fbgen.wire.devicenet import Choice, Service, Status
from fbgen.wire.devicenet_messages import ErrorResponse, Request, Response
from tests.unit.devicenet.bench import C203, GATEWAY, MAC, Bench, bench, words
from tests.vectors.reading import entries

ENTRIES = entries("dev003z_words")

SIZES = {
    "bool": 1, "byte": 1, "usint": 1, "sint": 1, "word": 2, "int": 2, "uint": 2,
    "dint": 4, "udint": 4,
}  # fmt: skip
INSTANCES = {"connection": (1, 2, 4), "assembly": (20, 155), "parameter": (0x4003, 0x7A00, 0x0203)}
ALL = [
    pytest.param(known, item, instance, id=f"{known.name} {instance} {item.name}")
    for known in GATEWAY.objects
    for item in known.attributes
    for instance in INSTANCES.get(known.name, (1,))
    if not item.instances or instance in item.instances
]


@pytest.fixture(scope="module")
def made() -> Bench:
    found = bench(C203[21])
    found.connect(Choice.POLLED | Choice.CHANGE_OF_STATE, rate_ms=0)
    return found


def whole(made: Bench, class_id: int, instance: int, attribute: int) -> bytes | int:
    """An attribute without regard to the length of its answer."""
    request = Request(Service.GET_ATTRIBUTE_SINGLE, class_id, instance, bytes([attribute]))
    answer = made.option.serve(request)
    return answer.data if isinstance(answer, Response) else answer.status


@pytest.mark.parametrize("known", GATEWAY.objects, ids=lambda known: known.name)
def test_class_attributes_are_constants_of_their_types(made: Bench, known: ObjectClass) -> None:
    for item in known.class_attributes:
        assert item.default is not None
        found = whole(made, known.code, 0, item.id)
        assert found == item.default.to_bytes(SIZES[item.type], "little")
        request = Request(Service.SET_ATTRIBUTE_SINGLE, known.code, 0, bytes([item.id, 0, 0]))
        assert made.option.serve(request) == ErrorResponse(Status.SERVICE_NOT_SUPPORTED, 0xFF)


@pytest.mark.parametrize(("known", "item", "instance"), ALL)
def test_every_attribute_can_be_read_in_its_type(
    made: Bench, known: ObjectClass, item: Attribute, instance: int
) -> None:
    found = whole(made, known.code, instance, item.id)
    assert isinstance(found, bytes)
    size = SIZES.get(item.type)
    assert size is None or len(found) == size
    if item.type in ("usint", "uint", "bool") and item.values:
        assert int.from_bytes(found, "little") in item.values


@pytest.mark.parametrize(("known", "item", "instance"), ALL)
def test_every_attribute_takes_what_it_may_and_nothing_else(
    made: Bench, known: ObjectClass, item: Attribute, instance: int
) -> None:
    """What cannot be set says so; what can refuses other lengths, and takes its own value."""
    data = whole(made, known.code, instance, item.id)
    assert isinstance(data, bytes)

    def put(value: bytes) -> int:
        request = Request(
            Service.SET_ATTRIBUTE_SINGLE, known.code, instance, bytes([item.id]) + value
        )
        answer = made.option.serve(request)
        return 0 if isinstance(answer, Response) else answer.status

    if Service.SET_ATTRIBUTE_SINGLE not in {service.code for service in known.services}:
        assert put(data) == Status.SERVICE_NOT_SUPPORTED
        return
    if not item.settable:
        assert put(data) == Status.ATTRIBUTE_NOT_SETTABLE
        return
    if item.type == "byte_array":
        output = instance < 70 or instance in (100, 101, 102, 105)
        wanted = Status.OBJECT_STATE_CONFLICT if output else Status.ATTRIBUTE_NOT_SETTABLE
        assert put(data) == wanted, "the polled connection has the outputs"
        return
    assert put(b"") == Status.NOT_ENOUGH_DATA
    assert put(data + b"\x00") == Status.TOO_MUCH_DATA
    if known.name == "connection" and item.name == "watchdog_timeout_action" and instance != 1:
        assert put(data) == Status.ATTRIBUTE_NOT_SETTABLE
        return
    if known.name == "parameter" and instance == 0x4003:
        assert put(words(9)) == Status.INVALID_ATTRIBUTE_VALUE
    assert put(data) == 0
    assert whole(made, known.code, instance, item.id) == data


@pytest.mark.parametrize(
    ("asked", "service", "data", "status"),
    [
        ((0x06, 1), 0x0E, "01", Status.OBJECT_DOES_NOT_EXIST),
        ((0x01, 2), 0x0E, "01", Status.OBJECT_DOES_NOT_EXIST),
        ((0x05, 3), 0x0E, "01", Status.OBJECT_DOES_NOT_EXIST),
        ((0x04, 103), 0x0E, "03", Status.OBJECT_DOES_NOT_EXIST),
        ((0x64, 0x4002), 0x0E, "03", Status.OBJECT_DOES_NOT_EXIST),
        ((0x64, 0x0010), 0x0E, "03", Status.OBJECT_DOES_NOT_EXIST),
        ((0x64, 0x0000), 0x0E, "03", Status.SERVICE_NOT_SUPPORTED),
        ((0x01, 1), 0x01, "", Status.SERVICE_NOT_SUPPORTED),
        ((0x01, 0), 0x05, "", Status.SERVICE_NOT_SUPPORTED),
        ((0x01, 0), 0x10, "01 01 00", Status.SERVICE_NOT_SUPPORTED),
        ((0x02, 1), 0x10, "02 00 00", Status.SERVICE_NOT_SUPPORTED),
        ((0x01, 1), 0x0E, "63", Status.ATTRIBUTE_NOT_SUPPORTED),
        ((0x01, 1), 0x10, "63 00", Status.ATTRIBUTE_NOT_SUPPORTED),
        ((0x01, 0), 0x0E, "07", Status.ATTRIBUTE_NOT_SUPPORTED),
        ((0x05, 2), 0x0E, "11", Status.ATTRIBUTE_NOT_SUPPORTED),
        ((0x01, 1), 0x0E, "", Status.NOT_ENOUGH_DATA),
        ((0x01, 1), 0x10, "", Status.NOT_ENOUGH_DATA),
        ((0x01, 1), 0x0E, "01 01", Status.TOO_MUCH_DATA),
        ((0x01, 1), 0x10, "07 00", Status.ATTRIBUTE_NOT_SETTABLE),
        ((0x29, 1), 0x10, "05 02", Status.INVALID_ATTRIBUTE_VALUE),
        ((0x2A, 1), 0x10, "08 FF FF", Status.INVALID_ATTRIBUTE_VALUE),
        ((0x2B, 1), 0x10, "01 00 00", Status.INVALID_ATTRIBUTE_VALUE),
        ((0x2B, 1), 0x10, "03 02 00", Status.INVALID_ATTRIBUTE_VALUE),
        ((0x64, 0x7D00), 0x10, "03 00 00", Status.ATTRIBUTE_NOT_SETTABLE),
        ((0x64, 0x4011), 0x10, "03 FF FF", Status.INVALID_ATTRIBUTE_VALUE),
        ((0x01, 1), 0x05, "02", Status.INVALID_PARAMETER),
        ((0x01, 1), 0x05, "00 00", Status.TOO_MUCH_DATA),
        ((0x05, 2), 0x05, "00", Status.TOO_MUCH_DATA),
        ((0x29, 1), 0x05, "00", Status.TOO_MUCH_DATA),
        ((0x29, 0), 0x05, "", Status.SERVICE_NOT_SUPPORTED),
        ((0x65, 1), 0x0E, "03", Status.OBJECT_DOES_NOT_EXIST),
    ],
)
def test_a_refusal_has_its_general_status_code(
    made: Bench, asked: tuple[int, int], service: int, data: str, status: Status
) -> None:
    answer = made.option.serve(Request(service, *asked, bytes.fromhex(data)))
    assert answer == ErrorResponse(status, 0xFF)


@pytest.mark.fact("dev.ident")
def test_the_identity_says_what_it_is(made: Bench) -> None:
    assert whole(made, 1, 1, 1) == words(377)
    assert whole(made, 1, 1, 2) == words(2)
    assert whole(made, 1, 1, 3) == words(GATEWAY.devicenet.product_codes["vf-s15"])
    assert whole(made, 1, 1, 4) == b"\x01\x01"
    assert whole(made, 1, 1, 7) == b"\x07DEV003Z"
    assert whole(made, 1, 1, 8) == b"\x03"
    assert whole(bench(series="vf-mb1"), 1, 1, 3) == words(3000)


STATUS = ENTRIES["dev.identity.status"]
EXTENDED = {row["name"]: row["value"] << STATUS["number"]["lowest"] for row in STATUS["values"]}
FLAGS = {row["name"]: 1 << row["bit"] for row in STATUS["flags"]}


@pytest.mark.fact("dev.ident")
def test_the_status_of_the_identity_says_what_the_manual_says() -> None:
    made = bench(C203[21])

    def status(name: str, *flags: str) -> bool:
        wanted = EXTENDED[name] | sum(FLAGS[flag] for flag in flags)
        return whole(made, 1, 1, 5) == words(wanted)

    assert status("No I/O connection established")
    made.connect(rate_ms=50)
    assert status("Connection in idle mode", "Owned by Master")
    made.poll(words(0, 0))
    assert status("Connection in run mode", "Owned by Master")
    made.poll(b"")
    assert status("Connection in idle mode", "Owned by Master")
    made.drive.trip("OC1")
    assert status("Connection in idle mode", "Owned by Master", "Minor Recoverable Fault")
    assert whole(made, 1, 1, 8) == b"\x03", "the option itself works"
    made.run(300)
    assert status("Faulted I/O connection", "Owned by Master", "Minor Recoverable Fault")


def test_connections_that_only_send_are_in_run_mode() -> None:
    made = bench(C203[21])
    made.connect(Choice.CYCLIC)
    assert whole(made, 1, 1, 5) == words(
        EXTENDED["Connection in run mode"] | FLAGS["Owned by Master"]
    )


def test_the_router_lists_classes_and_connections(made: Bench) -> None:
    codes = [item.code for item in GATEWAY.objects]
    assert whole(made, 2, 1, 1) == words(len(codes), *codes)
    assert whole(made, 2, 1, 2) == words(16)
    assert whole(made, 2, 1, 4) == words(1, 2, 4)


@pytest.mark.fact("dev.conn")
def test_the_connections_say_what_goes_over_them(made: Bench) -> None:
    assert whole(made, 5, 2, 14) == bytes.fromhex("20 04 25 47 00 30 03"), "instance 71"
    assert whole(made, 5, 2, 13) == words(7)
    assert whole(made, 5, 2, 16) == bytes.fromhex("20 04 25 15 00 30 03")
    assert whole(made, 5, 2, 7) == whole(made, 5, 2, 8) == words(4)
    assert whole(made, 5, 2, 4) == words(0x3C0 + MAC)
    assert whole(made, 5, 1, 5) == words(0x400 + 8 * MAC + 4)
    assert whole(made, 5, 1, 12) == b"\x01"
    assert whole(made, 5, 2, 12) == b"\x00"
    assert whole(made, 5, 1, 13) == words(0)
    as_delivered = bench()
    as_delivered.connect()
    assert whole(as_delivered, 5, 2, 14) == bytes.fromhex("20 04 25 46 00 30 03")


@pytest.mark.fact("dev.param")
def test_cells_are_read_and_written_as_instances() -> None:
    made = bench()
    made.allocate(1)
    assert made.get(0x64, 0x4003, 3) == words(1)
    assert made.set(0x64, 0x4018, 3, words(2500)) == 0
    assert made.drive.read_parameter("0018") == 25.0
    assert made.get(0x64, 0x7D00, 3) == words(0)
    assert made.set(0x64, 0x0203, 3, words(3)) == 0
    assert made.option.own["assembly_instances"] == 3
    assert made.set(0x64, 0x0203, 3, words(6)) == Status.INVALID_ATTRIBUTE_VALUE
    written = ENTRIES["dev.parameter_object.examples"]["written"]
    number = int(written["instance"], 16)
    assert made.set(0x64, number, 3, words(int(written["word"], 16))) == 0
    assert made.drive.read_parameter(written["comno"]) == written["value"]


@pytest.mark.parametrize(("memory", "after"), [("ram", 0.0), ("eeprom", 25.0)])
def test_an_option_says_whether_values_outlive_a_restart(memory: str, after: float) -> None:
    made = bench(options={"register_memory": memory})
    made.allocate(1)
    made.set(0x64, 0x4018, 3, words(2500))
    made.drive.power_off()
    made.drive.power_on()
    assert made.drive.read_parameter("0018") == after


def test_c203_acts_after_a_reset_of_the_device() -> None:
    made = bench()
    made.allocate(1)
    made.set(0x64, 0x0203, 3, words(3))
    assert made.option.output_length == 4
    answer = made.ask(Request(Service.RESET, 1, 1))
    assert answer == Response(Service.RESET)
    made.run(2300)
    assert made.option.output_length == 8
    assert made.option.node.connections == {}
    made.allocate(1)
    made.ask(Request(Service.RESET, 1, 1, b"\x01"))
    made.run(2300)
    assert made.option.output_length == 4, "as delivered"


@pytest.mark.fact("dev.drive")
def test_the_drive_is_commanded_by_attributes_alone() -> None:
    made = bench()
    made.allocate(1)
    assert made.set(0x29, 1, 5, b"\x01") == made.set(0x2A, 1, 4, b"\x01") == 0
    assert made.set(0x2A, 1, 8, words(900)) == made.set(0x29, 1, 4, b"\x01") == 0
    made.run(300)
    assert made.drive.direction == "reverse"
    assert made.drive.frequency_hz == 30.0
    assert made.get(0x2A, 1, 7) == words(900)
    assert made.get(0x2A, 1, 3) == made.get(0x2A, 1, 29) == made.get(0x29, 1, 15) == b"\x01"
    assert (made.get(0x29, 1, 7), made.get(0x29, 1, 8)) == (b"\x00", b"\x01")
    assert made.get(0x29, 1, 6) == b"\x04"
    made.set(0x29, 1, 4, b"\x00")
    made.run(300)
    assert made.get(0x29, 1, 6) == b"\x03"


@pytest.mark.fact("dev.drive")
def test_times_and_limits_are_in_the_units_of_the_attributes() -> None:
    made = bench(drive={"0009": 10.0, "0011": 80.0, "0012": 40.0})
    made.allocate(1)
    assert made.get(0x2A, 1, 18) == words(5000), "10 s to 80 Hz are 5 s to the upper limit"
    assert made.set(0x2A, 1, 19, words(2000)) == 0
    assert made.drive.read_parameter("0010") == 4.0
    assert made.get(0x2A, 1, 21) == words(1200)
    assert made.set(0x2A, 1, 20, words(300)) == 0
    assert made.drive.read_parameter("0013") == 10.0


@pytest.mark.fact("dev.drive")
def test_time_scale_says_what_a_unit_of_the_times_is() -> None:
    made = bench(drive={"0009": 10.0, "0011": 80.0, "0012": 80.0})
    made.allocate(1)
    assert made.set(0x2A, 1, 28, b"\xfc") == 0
    assert made.get(0x2A, 1, 18) == words(625), "units of 2^4 ms"
    assert made.set(0x2A, 1, 19, words(1000)) == 0
    assert made.drive.read_parameter("0010") == 16.0
    assert made.set(0x2A, 1, 28, b"\x02") == 0
    assert made.get(0x2A, 1, 18) == words(40_000), "quarters of a ms"
    for extreme in (b"\x7f", b"\x80"):
        assert made.set(0x2A, 1, 28, extreme) == 0
        assert made.get(0x2A, 1, 18) == words(0xFFFF if extreme == b"\x7f" else 0)
        assert made.set(0x2A, 1, 19, words(0xFFFF)) in (0, Status.INVALID_ATTRIBUTE_VALUE)


def test_the_motor_has_the_poles_by_which_speeds_are_converted() -> None:
    made = bench(options={"motor_poles": 6})
    made.allocate(1)
    assert made.get(0x28, 1, 12) == words(6)
    assert made.set(0x28, 1, 12, words(4)) == Status.ATTRIBUTE_NOT_SETTABLE
    assert made.set(0x2A, 1, 8, words(900)) == 0
    assert made.drive.registers.ram[0xFA07] == 4500


def test_hours_of_operation_are_those_of_the_inverter() -> None:
    made = bench()
    made.drive.registers.ram[0xFE14] = 0
    made.allocate(1)
    assert made.get(0x2A, 1, 46) == made.drive.read_word("FE14").to_bytes(4, "little")


def test_current_and_torque_are_in_the_units_of_the_motor() -> None:
    made = bench(options={"rated_torque": 20})
    made.allocate(1)
    made.set(0x28, 1, 6, words(100))
    made.set(0x29, 1, 5, b"\x01")
    made.set(0x2A, 1, 4, b"\x01")
    made.set(0x2A, 1, 8, words(1500))
    made.set(0x29, 1, 3, b"\x01")
    made.run(300)
    tenths = round(made.drive.read_word("FD03") / 100)
    assert made.get(0x2A, 1, 9) == words(tenths)
    assert made.get(0x2A, 1, 11) == words(round(made.drive.read_word("FD18") * 20 / 10_000))
    assert tenths > 20


def test_an_output_assembly_can_be_written_by_an_explicit_message() -> None:
    made = bench()

    def put(instance: int, data: bytes) -> Response | ErrorResponse:
        request = Request(Service.SET_ATTRIBUTE_SINGLE, 4, instance, b"\x03" + data)
        return made.option.serve(request)

    assert put(100, words(0xC600, 3000)) == Response(Service.SET_ATTRIBUTE_SINGLE)
    made.run(300)
    assert made.drive.frequency_hz == 30.0
    assert whole(made, 4, 150, 3) == words(0x6600, 3000)
    assert whole(made, 4, 100, 3) == words(0xC600, 3000)
    assert put(100, b"\x00") == ErrorResponse(Status.NOT_ENOUGH_DATA, 0xFF)
    assert put(100, bytes(5)) == ErrorResponse(Status.TOO_MUCH_DATA, 0xFF)
    assert put(150, words(0, 0)) == ErrorResponse(Status.ATTRIBUTE_NOT_SETTABLE, 0xFF)
    made.connect(Choice.CYCLIC, rate_ms=0)
    assert put(100, words(0xC400, 1000)) == Response(Service.SET_ATTRIBUTE_SINGLE)
    made.allocate(Choice.POLLED)
    made.set(5, 2, 9, words(0))
    assert put(100, words(0xC400, 1000)) == ErrorResponse(Status.OBJECT_STATE_CONFLICT, 0xFF)
