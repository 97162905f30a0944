"""What the simulated devices leave out: the one list, which the reference site shows.

A change of a device that makes an entry wrong mends it here.
"""

NOT_MODELLED: tuple[tuple[str, str, str], ...] = (
    (
        "PLC",
        "How long each instruction takes on a CPU.",
        "A scan takes the time and jitter of the plant file or the scenario, whatever is in it.",
    ),
    (
        "PLC",
        "Communication load, online access and other tasks than those of the program.",
        "Faults make the cycle longer, let it overrun and stop the CPU.",
    ),
    (
        "PROFIBUS",
        "Levels, cables, terminators, single bits and repeats of telegrams.",
        "A bus cycle of a given time with jitter; faults interrupt it or pull a plug.",
    ),
    (
        "PROFIBUS",
        "Further masters, the token, acyclic services of DP-V1.",
        "One master of class 1 with its slaves.",
    ),
    (
        "PROFIBUS",
        "The times of the bus where a real master talks to the simulated gateway at a port.",
        "Replies go out as early as the computer manages.",
    ),
    (
        "TOSPBDP001",
        "Its configuration tool, its firmware's own errors, ageing of its memory.",
        "The states and times of its manual and those of HMS for the same hardware; faults lose "
        "its memory, stick its trigger, slow it down.",
    ),
    (
        "PBDP-110",
        "Which identifiers the real module has: its GSD file is not public.",
        "Those of the catalogue, marked as unverified, or those of the plant file.",
    ),
    (
        "DeviceNet",
        "Bit-strobed and multicast connections, heartbeat messages, quick connect, offline groups.",
        "The predefined set with explicit, polled, change of state and cyclic connections.",
    ),
    (
        "DeviceNet",
        "Stuff bits, error frames and repeats of CAN, missing acknowledgement of a lonely node.",
        "A bus with bit rate and arbitration; bus-off on demand, not from a real interface.",
    ),
    (
        "DEV003Z",
        "What the lost pages of its manual say: error codes, some codes of selections, times.",
        "What CIP, the options of other series or we ourselves have, marked as unverified.",
    ),
    (
        "Line of the inverters",
        "Voltages, reflections, bias and termination.",
        "Byte times, parity, collisions; faults add noise, lose, double and delay bytes.",
    ),
    (
        "Inverter",
        "Currents and torques of the motor in a physical sense, slip, temperature of motor and "
        "inverter, regeneration into the intermediate circuit.",
        "The frequency follows ramps; a load with a torque curve gives the current.",
    ),
    (
        "Inverter",
        "Parameters that change how it runs, beyond those that the catalogue gives a behaviour.",
        "They are kept, checked against their range and given back.",
    ),
    (
        "Inverter",
        "What leads to a trip inside of the inverter.",
        "Emergency stop and loss of communication trip by themselves, every other trip is a fault "
        "of the scenario.",
    ),
    (
        "Inverter",
        "Functions of terminals but those that take command and frequency from the network.",
        "Commands of the panel and terminals as a whole.",
    ),
)
"""Part, what is left out, what there is instead."""
