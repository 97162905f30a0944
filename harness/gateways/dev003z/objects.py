"""Get and Set of attributes by the catalogue's tables, each refusal with its general status code.

What an attribute is at the moment, and what follows when it is set, the `Attributes` know.
"""

from collections.abc import Mapping
from typing import Protocol

from fbgen.catalog import DeviceNetGateway
from fbgen.catalog.devicenet_objects import Attribute, DataType, ObjectClass
from fbgen.wire.devicenet import NO_ADDITIONAL_CODE, Service, Status
from fbgen.wire.devicenet_messages import ErrorResponse, Request, Response

_SIZES: Mapping[DataType, int] = {
    "bool": 1, "byte": 1, "usint": 1, "sint": 1, "word": 2, "int": 2, "uint": 2,
    "dint": 4, "udint": 4,
}  # fmt: skip
_SIGNED = ("sint", "int", "dint")

Value = int | bytes
"""A number, or the bytes of what is none."""


class Attributes(Protocol):
    """What the attributes are."""

    def exists(self, object_class: ObjectClass, instance: int) -> bool:
        """Whether there is such an instance now; 0 is the class and is not asked for."""

    def get(self, object_class: ObjectClass, attribute: Attribute, instance: int) -> Value | Status:
        """The value now, or why it cannot be had."""

    def set(
        self, object_class: ObjectClass, attribute: Attribute, instance: int, value: Value
    ) -> Status | None:
        """Set it to a value that its type and range allow; why it is refused, or None."""

    def call(self, object_class: ObjectClass, request: Request) -> bytes | Status:
        """A service that is neither Get nor Set: its data, or why it is refused."""


class ObjectModel:
    """All classes of an adapter."""

    __slots__ = ("_attributes", "_classes")

    def __init__(self, gateway: DeviceNetGateway, attributes: Attributes) -> None:
        self._classes = {item.code: item for item in gateway.objects}
        self._attributes = attributes

    def serve(self, request: Request) -> Response | ErrorResponse:
        """Carry out a request."""
        found = self._serve(request)
        if isinstance(found, Status):
            return ErrorResponse(found, NO_ADDITIONAL_CODE)
        return Response(request.service, found)

    def _serve(self, request: Request) -> bytes | Status:
        known = self._classes.get(request.class_id)
        if known is None:
            return Status.OBJECT_DOES_NOT_EXIST
        on_class = request.instance == 0
        if not on_class and not self._attributes.exists(known, request.instance):
            return Status.OBJECT_DOES_NOT_EXIST
        offered = {
            item.code for item in known.services
            if (item.on_class if on_class else item.on_instance)
        }  # fmt: skip
        if request.service not in offered:
            return Status.SERVICE_NOT_SUPPORTED
        if request.service == Service.GET_ATTRIBUTE_SINGLE:
            return self._get(known, request)
        if request.service == Service.SET_ATTRIBUTE_SINGLE:
            return self._set(known, request)
        return self._attributes.call(known, request)

    def _get(self, known: ObjectClass, request: Request) -> bytes | Status:
        if not request.data:
            return Status.NOT_ENOUGH_DATA
        if len(request.data) > 1:
            return Status.TOO_MUCH_DATA
        attribute = _attribute(known, request)
        if attribute is None:
            return Status.ATTRIBUTE_NOT_SUPPORTED
        if request.instance == 0:
            assert attribute.default is not None, "class attributes are constants"
            return _encode(attribute, attribute.default)
        value = self._attributes.get(known, attribute, request.instance)
        return value if isinstance(value, Status) else _encode(attribute, value)

    def _set(self, known: ObjectClass, request: Request) -> bytes | Status:
        if not request.data:
            return Status.NOT_ENOUGH_DATA
        attribute = _attribute(known, request)
        if attribute is None:
            return Status.ATTRIBUTE_NOT_SUPPORTED
        if not attribute.settable or request.instance == 0:
            return Status.ATTRIBUTE_NOT_SETTABLE
        value = _decode(attribute, request.data[1:])
        if isinstance(value, Status):
            return value
        refused = self._attributes.set(known, attribute, request.instance, value)
        return b"" if refused is None else refused


def _attribute(known: ObjectClass, request: Request) -> Attribute | None:
    rows = known.class_attributes if request.instance == 0 else known.attributes
    for item in rows:
        if item.id == request.data[0]:
            has = not item.instances or request.instance in item.instances
            return item if has else None
    return None


def _encode(attribute: Attribute, value: Value) -> bytes:
    if isinstance(value, bytes):
        return value
    size = _SIZES[attribute.type]
    return (value & (1 << 8 * size) - 1).to_bytes(size, "little")


def _decode(attribute: Attribute, data: bytes) -> Value | Status:
    size = _SIZES.get(attribute.type)
    if size is None:
        return data
    if len(data) != size:
        return Status.NOT_ENOUGH_DATA if len(data) < size else Status.TOO_MUCH_DATA
    value = int.from_bytes(data, "little", signed=attribute.type in _SIGNED)
    low, high = attribute.limits
    return value if low <= value <= high else Status.INVALID_ATTRIBUTE_VALUE
