"""What a DeviceNet slave asks of the device that it belongs to."""

from typing import Protocol

from fbgen.wire.devicenet_messages import ErrorResponse, Request, Response


class Application(Protocol):
    """The device behind the slave."""

    @property
    def output_length(self) -> int:
        """Bytes of I/O data from the master."""

    @property
    def input_length(self) -> int:
        """Bytes of I/O data to the master."""

    def serve(self, request: Request) -> Response | ErrorResponse:
        """Carry out an explicit request; requests to allocate and release never come here."""

    def consume(self, data: bytes) -> None:
        """Take I/O data of the master, as long as the device expects them."""

    def produce(self) -> bytes:
        """The I/O data for the master as they are now."""

    def communication_lost(self) -> None:
        """A connection that carried commands is gone: timed out, released, or with the network."""

    def reset(self) -> None:
        """The network object was reset: the connections are gone."""
