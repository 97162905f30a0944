"""Who may allocate which connections of the predefined set, and release them.

The codes are those of ODVA's DeviceNet object, as public implementations have them; the DEV003Z-1
manual E6581737, page 14, has the services only.
"""

from fbgen.dataclass import dataclass
from fbgen.wire.devicenet import (
    MAX_MAC,
    NO_ADDITIONAL_CODE,
    AllocationError,
    Choice,
    Service,
    Status,
)
from fbgen.wire.devicenet_messages import ErrorResponse, Request
from harness.fieldbus.devicenet.settings import SUPPORTED

NO_MASTER = 255
"""The MAC ID of the master in the allocation information while there is none."""
_CONNECTIONS = Choice.EXPLICIT | Choice.POLLED | Choice.CHANGE_OF_STATE | Choice.CYCLIC
_COS = Choice.CHANGE_OF_STATE | Choice.CYCLIC
_ALLOCATE_BYTES, _RELEASE_BYTES = 2, 1


@dataclass(frozen=True, slots=True)
class Allocation:
    """What is allocated, and to whom."""

    choice: Choice = Choice(0)
    master: int = NO_MASTER


def refuse_allocation(now: Allocation, request: Request) -> ErrorResponse | None:
    """Why a request to allocate is refused, None if it is not."""
    if (wrong := _wrong_length(request.data, _ALLOCATE_BYTES)) is not None:
        return wrong
    choice, master = request.data
    if master > MAX_MAC or not choice & _CONNECTIONS or _contradicts(choice):
        return _refusal(Status.INVALID_ATTRIBUTE_VALUE, AllocationError.INVALID_CHOICE)
    if choice & ~SUPPORTED:
        return _refusal(Status.RESOURCE_UNAVAILABLE, AllocationError.INVALID_CHOICE)
    if now.master not in (NO_MASTER, master):
        return _refusal(Status.OBJECT_STATE_CONFLICT, AllocationError.ALLOCATED_TO_ANOTHER)
    if choice & now.choice & _CONNECTIONS or (choice & _COS and now.choice & _COS):
        return _refusal(Status.ALREADY_IN_REQUESTED_STATE, AllocationError.INVALID_CHOICE)
    if not (choice | now.choice) & Choice.EXPLICIT:
        return _refusal(Status.INVALID_ATTRIBUTE_VALUE, AllocationError.INVALID_CHOICE)
    return None


def refuse_release(now: Allocation, request: Request, master: int) -> ErrorResponse | None:
    """Why a request to release is refused, None if it is not."""
    if (wrong := _wrong_length(request.data, _RELEASE_BYTES)) is not None:
        return wrong
    choice = request.data[0]
    if not choice & _CONNECTIONS:
        return _refusal(Status.INVALID_ATTRIBUTE_VALUE, AllocationError.INVALID_CHOICE)
    if choice & ~SUPPORTED:
        return _refusal(Status.RESOURCE_UNAVAILABLE, AllocationError.INVALID_CHOICE)
    if now.master not in (NO_MASTER, master):
        return _refusal(Status.PRIVILEGE_VIOLATION, AllocationError.ALLOCATED_TO_ANOTHER)
    if choice & _CONNECTIONS & ~now.choice:
        return _refusal(Status.ALREADY_IN_REQUESTED_STATE, AllocationError.INVALID_CHOICE)
    return None


def is_allocation(request: Request) -> bool:
    """Whether a request is one of the DeviceNet object's own services, for its one instance."""
    own = (Service.ALLOCATE, Service.RELEASE)
    return request.service in own and (request.class_id, request.instance) == (3, 1)


def refuse_unconnected() -> ErrorResponse:
    """The answer to what the unconnected port does not take."""
    return _refusal(Status.OBJECT_STATE_CONFLICT, AllocationError.NEITHER_ALLOCATE_NOR_RELEASE)


def _contradicts(choice: int) -> bool:
    if choice & 0x80 or choice & _COS == _COS:
        return True
    return bool(choice & Choice.ACK_SUPPRESSION) and not choice & _COS


def _wrong_length(data: bytes, wanted: int) -> ErrorResponse | None:
    if len(data) < wanted:
        return ErrorResponse(Status.NOT_ENOUGH_DATA, NO_ADDITIONAL_CODE)
    if len(data) > wanted:
        return ErrorResponse(Status.TOO_MUCH_DATA, NO_ADDITIONAL_CODE)
    return None


def _refusal(status: Status, additional: AllocationError) -> ErrorResponse:
    return ErrorResponse(status, additional)
