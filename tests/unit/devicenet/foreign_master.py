"""A master that others wrote: runs under Python 3.12 with devicenet-py 0.0.1, without fbgen.

Frames go by standard output and input, one a line, identifier and data in hexadecimal; behind "="
stands a result, as JSON.
"""

import json
import queue
import sys
import threading

import can

from devicenet.cid import DeviceNetCID
from devicenet.devicenet import DeviceNet
from devicenet.enums import DeviceNetConnectionObjectAttributes as Attributes
from devicenet.fields import DeviceNetAllocationChoiceByte

SLAVE = 5


class PipeBus(can.BusABC):
    """A bus of python-can whose cable are the standard streams."""

    def __init__(self):
        super().__init__(channel="pipe")
        self._come = queue.Queue()
        threading.Thread(target=self._listen, daemon=True).start()

    def _listen(self):
        for line in sys.stdin:
            identifier, _, data = line.strip().partition(" ")
            self._come.put((int(identifier, 16), bytes.fromhex(data)))

    def _recv_internal(self, timeout):
        try:
            identifier, data = self._come.get(timeout=timeout)
        except queue.Empty:
            return None, False
        message = can.Message(arbitration_id=identifier, data=data, is_extended_id=False)
        return message, False

    def send(self, msg, timeout=None):
        print(f"{msg.arbitration_id:03X} {bytes(msg.data).hex()}", flush=True)


def tell(name, value):
    print("=" + json.dumps({name: value}), flush=True)


# It gives an answer a tenth of a second, which is too little on a busy machine.
DeviceNet.handle_messages.__defaults__ = (0.3,)


def main():
    net = DeviceNet(PipeBus(), mac_id=0, vendor_id=1, serial_number=2)
    net.connect(quick_connect=True)
    choice = DeviceNetAllocationChoiceByte(explicit_message=True, polled=True)
    try:
        net.master_slave_connect(SLAVE, choice)
    except RuntimeError as problem:
        tell("allocated at the connected port", str(problem))
    # What the library sends to the port of connected requests belongs to the unconnected one.
    usual = DeviceNetCID.master_explicit_request
    DeviceNetCID.master_explicit_request = DeviceNetCID.group_2_unconnected_explicit_request
    tell("body format", int(net.master_slave_connect(SLAVE, choice)))
    DeviceNetCID.master_explicit_request = usual
    net.set_attribute_single(SLAVE, Attributes.EXPECTED_PACKET_RATE, 1000)
    for name in ("STATE", "EXPECTED_PACKET_RATE", "PRODUCED_CONNECTION_SIZE"):
        tell(name, net.get_attribute_single(SLAVE, Attributes[name]))
    for data in sys.argv[1:]:
        answers = [net.poll_io(SLAVE, bytes.fromhex(data)).hex() for _ in range(2)]
        tell(data, answers[-1])


main()
