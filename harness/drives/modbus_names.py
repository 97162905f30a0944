"""Functions and exceptions of MODBUS by their names in the catalogue, and causes of refusals."""

from collections.abc import Mapping

from fbgen.catalog.communication import Cause
from fbgen.wire.modbus import ExceptionCode, Function
from fbgen.wire.toshiba import ErrorCode

FUNCTIONS: Mapping[str, Function] = {
    "read": Function.READ,
    "write": Function.WRITE,
    "write_several": Function.WRITE_SEVERAL,
    "write_and_read": Function.READ_WRITE,
    "identify": Function.IDENTIFY,
}
EXCEPTIONS: Mapping[str, ExceptionCode] = {
    "illegal_function": ExceptionCode.FUNCTION,
    "illegal_address": ExceptionCode.ADDRESS,
    "illegal_value": ExceptionCode.VALUE,
    "device_failure": ExceptionCode.CANNOT_EXECUTE,
}
"""Functions and exceptions by their names in the catalogue."""

USUAL: Mapping[Cause, ExceptionCode] = {
    "unknown_function": ExceptionCode.FUNCTION,
    "unknown_comno": ExceptionCode.ADDRESS,
    "wrong_quantity": ExceptionCode.VALUE,
    "wrong_data": ExceptionCode.VALUE,
    "not_executable": ExceptionCode.CANNOT_EXECUTE,
}
"""What the specification has for a cause of which a series says nothing."""

CAUSES: Mapping[ErrorCode, Cause] = {
    ErrorCode.CANNOT_EXECUTE: "not_executable",
    ErrorCode.DATA: "wrong_data",
    ErrorCode.COM_NO: "unknown_comno",
}
