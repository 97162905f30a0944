"""Explicit messages of DeviceNet in words: requests, responses, refusals, allocation.

What a response is about stands in the request before it, so that is kept for each drive.
"""

from fbgen.catalog import DeviceNetGateway, Drive
from fbgen.catalog.devicenet_objects import NUMBERS, Attribute
from fbgen.wire.devicenet import NO_ADDITIONAL_CODE, BodyFormat, Choice, Service
from fbgen.wire.devicenet_messages import (
    ErrorResponse,
    MessageError,
    Request,
    parse_request,
    parse_response,
    status_name,
)
from harness.trace.meaning import cell_name, word_meaning
from harness.trace.model import FrameKind

_DEVICENET, _ALLOCATE_BYTES = 3, 2
_BY_NAME = (Service.GET_ATTRIBUTE_SINGLE, Service.SET_ATTRIBUTE_SINGLE)
_FORMS = {form.name.removeprefix("C").replace("_I", "_"): form for form in BodyFormat}


class ExplicitMeanings:
    """What the explicit messages of one drive say."""

    def __init__(self, name: str, gateway: DeviceNetGateway, series: Drive) -> None:
        self._name = name
        self._gateway = gateway
        self._series = series
        self._form = _FORMS[gateway.devicenet.body_format]
        self._asked: Request | None = None

    def request(self, body: bytes, *, unconnected: bool) -> tuple[FrameKind, str]:
        """A request of the scanner; those to the unconnected port have a byte for each number."""
        try:
            request = parse_request(body, BodyFormat.C8_I8 if unconnected else self._form)
        except MessageError:
            return "unknown", ""
        self._asked = request
        return "request", f"{self._name}: {self._asks(request)}"

    def response(self, body: bytes) -> tuple[FrameKind, str]:
        """What the drive says to it."""
        try:
            response = parse_response(body)
        except MessageError:
            return "unknown", ""
        asked, self._asked = self._asked, None
        if isinstance(response, ErrorResponse):
            code = response.additional
            more = "" if code == NO_ADDITIONAL_CODE else f", code {code:02X}"
            what = "" if asked is None else f" to {self._asks(asked)}"
            return "refusal", f"{self._name} refuses{what}: {status_name(response.status)}{more}"
        if asked is None or asked.service != response.service:
            return "reply", f"{self._name}: {response.data.hex(' ').upper()}".rstrip()
        return "reply", f"{self._name}: {self._did(asked, response.data)}"

    def _asks(self, request: Request) -> str:
        service, data = request.service, request.data
        own = (request.class_id, request.instance) == (_DEVICENET, 1)
        if own and service == Service.ALLOCATE and len(data) == _ALLOCATE_BYTES:
            return f"allocate {_choice(data[0])} for the master {data[1]}"
        if own and service == Service.RELEASE and len(data) == 1:
            return f"release {_choice(data[0])}"
        if service == Service.GET_ATTRIBUTE_SINGLE and len(data) == 1:
            return f"read {self._attribute(request)}"
        if service == Service.SET_ATTRIBUTE_SINGLE and data:
            return f"write {self._attribute(request)} = {self._value(request, data[1:])}"
        found = next((one for one in Service if one == service), None)
        name = f"service {service:02X}" if found is None else found.name.lower().replace("_", " ")
        return f"{name} {self._object(request)}"

    def _did(self, asked: Request, data: bytes) -> str:
        if asked.service == Service.GET_ATTRIBUTE_SINGLE and asked.data:
            return f"{self._attribute(asked)} is {self._value(asked, data)}"
        return f"done, {self._asks(asked)}"

    def _object(self, request: Request) -> str:
        found = next(
            (item for item in self._gateway.objects if item.code == request.class_id), None
        )
        name = f"class {request.class_id:02X}" if found is None else found.name
        return name if request.instance == 1 else f"{name} {request.instance:X}"

    def _attribute(self, request: Request) -> str:
        if (cell := self._cell(request)) is not None:
            return cell_name(self._series, cell)
        found = self._known(request)
        name = f"attribute {request.data[0]}" if found is None else found.name
        return f"{self._object(request)} {name}"

    def _known(self, request: Request) -> Attribute | None:
        """The attribute that a request is about, as the catalogue has it."""
        for known in self._gateway.objects:
            if known.code == request.class_id:
                attributes = known.attributes if request.instance else known.class_attributes
                return next((item for item in attributes if item.id == request.data[0]), None)
        return None

    def _cell(self, request: Request) -> int | None:
        """The cell of the inverter that an attribute is."""
        known = self._gateway.parameter_object
        if request.service not in _BY_NAME or request.class_id != known.code:
            return None
        return known.number(request.instance) if request.data[0] == known.attribute else None

    def _value(self, request: Request, data: bytes) -> str:
        cell = self._cell(request)
        if cell is not None and len(data) == 2:
            return word_meaning(self._series, cell, int.from_bytes(data, "little"))
        found = self._known(request)
        if found is None or found.type not in NUMBERS or not data:
            return data.hex(" ").upper() or "nothing"
        value = int.from_bytes(data, "little", signed=NUMBERS[found.type][0] < 0)
        meaning = found.values.get(value)
        return f"{value}" if meaning is None else f"{value} ({meaning})"


def _choice(choice: int) -> str:
    names = [bit.name.lower().replace("_", " ") for bit in Choice if choice & bit and bit.name]
    return ", ".join(names) or "nothing"
