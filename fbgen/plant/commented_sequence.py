"""A sequence of the user's own as `fbgen init` writes it beside the plant file."""

OWN_SEQUENCE_FILE = "start_and_wait.yaml"

_TEXT = """\
# A command sequence of your own. Name it in the plant file, below sequences:, and it becomes the
# block TOS_Seq_start_and_wait for every drive, like those of the catalogue. The file is called like
# its id. docs/reference/sequences.md has every kind of step.
version: 1
id: start_and_wait
title: Start forward and wait until it runs
description: >-
  Writes the set-point, starts, and is done when the inverter says that it runs. Does nothing and
  ends with the trip code if the inverter has tripped.
does_not_protect: This is no safety function. Whoever starts a drive answers for the machine.
source: written for this plant
series: [vf-s11]

# Inputs of the block. scaled_by names the ComNo whose unit and resolution count.
parameters:
  - {name: frequency, type: REAL, unit: Hz, scaled_by: frequency_setpoint, title: Set-point}

# Outputs of the block.
results:
  - {name: trip, type: WORD, title: "Trip code, 0000 for none"}

# ComNos and bits have their names in the catalogue: fbgen catalog show vf-s11.
steps:
  - read: trip_code
    into: trip
  - branch: trip               # tripped: nothing to start
    when: {at_least: 1}
    to: end
  - write: frequency_setpoint
    parameter: frequency
  - write: command_word
    bits: [network_command, network_frequency, run]
  - wait: status
    until: {bits: {running: 1, tripped: 0}}
    limit_ms: 5000
"""


def write_own_sequence() -> str:
    """The text of a complete, valid sequence in which every part is explained."""
    return _TEXT
