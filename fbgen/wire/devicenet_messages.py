"""Explicit messages of DeviceNet, and the duplicate MAC check.

The first byte of an explicit message says whether it is a fragment, and holds the transaction ID
and the MAC ID of the other side. Behind it stands the body: service, class, instance and data of a
request; service with bit 7 and data of a response; 94 and two codes of an error response.
"""

from fbgen.dataclass import dataclass
from fbgen.wire.devicenet import MAX_MAC, BodyFormat, Service, Status

FRAGMENT = 0x80
_XID = 0x40
RESPONSE = 0x80
"""In the service: this is a response."""
_ERROR_LENGTH = 3
_CHECK_LENGTH = 7


class MessageError(ValueError):
    """Bytes that are no such message."""


@dataclass(frozen=True, slots=True)
class Header:
    """The first byte. `mac` is the sender of a request of a master, its receiver in a response."""

    mac: int
    xid: bool = False
    fragment: bool = False

    def __post_init__(self) -> None:
        if not 0 <= self.mac <= MAX_MAC:
            raise ValueError(f"{self.mac} is no MAC ID, they are 0 to 63")

    @property
    def byte(self) -> int:
        """The byte on the wire."""
        return (FRAGMENT if self.fragment else 0) | (_XID if self.xid else 0) | self.mac


def parse_header(byte: int) -> Header:
    """The first byte of an explicit message."""
    return Header(byte & MAX_MAC, bool(byte & _XID), bool(byte & FRAGMENT))


@dataclass(frozen=True, slots=True)
class Request:
    """The body of an explicit request."""

    service: int
    class_id: int
    instance: int
    data: bytes = b""


@dataclass(frozen=True, slots=True)
class Response:
    """The body of a response that says that the service was done."""

    service: int
    data: bytes = b""


@dataclass(frozen=True, slots=True)
class ErrorResponse:
    """The body of a response that says that it was not."""

    status: int
    additional: int


def encode_request(request: Request, form: BodyFormat) -> bytes:
    """The body. ValueError for numbers that do not fit."""
    if not 0 <= request.service < RESPONSE:
        raise ValueError(f"{request.service:X} is no service")
    return (
        bytes([request.service])
        + _number(request.class_id, form.class_bytes)
        + _number(request.instance, form.instance_bytes)
        + request.data
    )


def parse_request(body: bytes, form: BodyFormat) -> Request:
    """A body as a request. MessageError if it is too short, or a response."""
    behind = 1 + form.class_bytes
    end = behind + form.instance_bytes
    if len(body) < end:
        raise MessageError(f"{len(body)} bytes are no request with {end} bytes before its data")
    if body[0] & RESPONSE:
        raise MessageError("this is a response, no request")
    return Request(
        body[0],
        int.from_bytes(body[1:behind], "little"),
        int.from_bytes(body[behind:end], "little"),
        body[end:],
    )


def encode_response(response: Response | ErrorResponse) -> bytes:
    """The body. ValueError for numbers that do not fit."""
    if isinstance(response, ErrorResponse):
        return bytes([RESPONSE | Service.ERROR_RESPONSE, response.status, response.additional])
    return bytes([RESPONSE | response.service]) + response.data


def parse_response(body: bytes) -> Response | ErrorResponse:
    """A body as a response. MessageError if it is none."""
    if not body or not body[0] & RESPONSE:
        raise MessageError("this is no response")
    service = body[0] & ~RESPONSE
    if service != Service.ERROR_RESPONSE:
        return Response(service, body[1:])
    if len(body) != _ERROR_LENGTH:
        raise MessageError(f"an error response has three bytes, not {len(body)}")
    return ErrorResponse(body[1], body[2])


def status_name(status: int) -> str:
    """A general status code in words."""
    known = {item.value: item.name for item in Status}
    return known.get(status, f"status {status:02X}").replace("_", " ").lower()


@dataclass(frozen=True, slots=True)
class DuplicateCheck:
    """The data of a duplicate MAC check: what a node says when it comes, and who has its MAC ID."""

    response: bool
    vendor: int
    serial: int
    port: int = 0

    def encode(self) -> bytes:
        """The data on the wire."""
        first = (RESPONSE if self.response else 0) | self.port
        return bytes([first]) + _number(self.vendor, 2) + _number(self.serial, 4)


def parse_duplicate_check(data: bytes) -> DuplicateCheck:
    """The data of a duplicate MAC check. MessageError if they have another length."""
    if len(data) != _CHECK_LENGTH:
        raise MessageError(f"a duplicate MAC check has {_CHECK_LENGTH} bytes, not {len(data)}")
    return DuplicateCheck(
        bool(data[0] & RESPONSE),
        int.from_bytes(data[1:3], "little"),
        int.from_bytes(data[3:7], "little"),
        data[0] & ~RESPONSE,
    )


def _number(value: int, size: int) -> bytes:
    if not 0 <= value < 1 << 8 * size:
        raise ValueError(f"{value} does not fit into {size} bytes")
    return value.to_bytes(size, "little")
