"""The commented plant file that `fbgen init` writes: every key with what it means."""

_TEXT = """\
# A plant for fbgen: one PLC, its gateways, the inverters on their lines.
#
#   fbgen generate plant.yaml -o out      writes the PLC blocks
#   fbgen catalog list                    shows gateways, drive series and sequences
#
# None of the generated blocks is a safety function. An emergency stop by communication stops a
# process; people are protected by STO and hard-wired terminals.
version: 1

# A name for a PLC program: letters, digits and single underscores, a letter first.
name: my_plant

# Optional, for people.
title: Two inverters on one gateway

# The language of the generated text:
#   tia      SCL of TIA Portal, one source for each block
#   step7    classic SCL of STEP 7 V5: one source and its symbol table
#   iec      Structured Text of IEC 61131-3, one file
#   twincat  objects of TwinCAT 3
#   plcopen  the text of iec in PLCopen XML
dialect: tia

# The PLC: s7-1200, s7-1500 (dialect tia), s7-300, s7-400 (tia or step7), iec (iec or plcopen) or
# twincat (twincat or plcopen).
plc: s7-1500

# The language of comments, titles and trip texts in the generated blocks: en or de.
language: en

# How the names of generated blocks begin.
prefix: TOS_

# Optional: one file with all blocks, or per_block, each in a file of its own. Without it what is
# usual for the dialect; twincat and plcopen leave no choice.
# files: one

# For dialect step7: the numbers that FBs, FCs, DBs and UDTs may have.
block_numbers: {first: 200, last: 399}

# For s7-300 and s7-400: without OB82, OB85, OB86 and OB122 a lost gateway takes the CPU to STOP.
#   generate  fbgen writes them, in sources of their own; they note what happened in TOS_Errors
#   mine      the project has its own: nothing is written that could overwrite them
error_obs: generate

# Time between two calls of TOS_Main in milliseconds.
cycle_time_ms: 10

# How long it may take to read the state of all drives of a gateway once. What it takes is
# calculated; more than this is a warning.
poll_limit_ms: 2000

# Optional: the CPU, to compare the work memory that the blocks take with what it has.
# cpu: 1513-1

# Command sequences of the catalogue; each becomes a block TOS_Seq_<name>.
sequences:
  - start_forward
  - start_reverse
  - stop            # has an input `reverse`: the stop telegram keeps the direction
  - set_frequency
  - read_current
  - read_status
  - fault_reset
  - check_parameters   # reads back what must be set at the inverter; see the parameter sheets
  - emergency_stop
  # - start_and_wait  # one of your own: sequences/start_and_wait.yaml beside this file

# Drives straight on RS-485, at a communication module of the PLC itself, instead of gateways or
# beside them (Toshiba protocol or MODBUS-RTU):
#
#   serial:
#     - name: line1
#       module: cm_ptp             # cm_1241 (S7-1200), cp_340, cp_341 (S7-300), cp_440
#                                  # (S7-400), adapter (iec, twincat); else the usual one
#       hardware_identifier: 271   # of its port, on S7-1200 and S7-1500; on S7-300/400 address:
#       protocol: toshiba_binary   # or toshiba_ascii, modbus
#       baud: 19200
#       parity: even               # none, even, odd
#       wires: 4                   # 2 or 4
#       drives:
#         - {name: press, inv_no: 1, series: vf-s11, max_frequency_hz: 50.0}
#
# status_poll, parameters and drives are as with a gateway for telegrams.
#
# All lines with MODBUS: who builds the frames.
#   instruction  Modbus_Master of the CPU; what it is without this key on S7-1200 and S7-1500
#   own          the blocks themselves, for modules without MODBUS; everywhere else it is so anyway
#
#   modbus_frames: own
#
# Drives with a DeviceNet option, at a scanner of the PLC:
#
#   devicenet:
#     - name: net1
#       rate: 500                  # kbit/s
#       active_address: 300        # of 8 input bytes: bit N % 8 of byte N / 8: MAC ID N is there
#       drives:
#         - name: infeed
#           type: dev003z
#           series: vf-s15
#           max_frequency_hz: 60.0
#           mac: 5
#           assemblies: 100/150    # instances of output and input
#           connection: polled     # or change_of_state, cyclic
#           input_address: 310
#           output_address: 310
#           parameters: {speed_unit: hz}    # or rpm: set-points in 1/min of the motor
#           options: {motor_poles: 4}       # by which 1/min and Hz are converted
#           settings: {timeout_action: 2}   # c101: stop when the network is lost

gateways:
  - name: gw1
    title: Conveyor hall       # optional
    type: tospbdp001

    # How the cyclic data are laid out. The manual and its GSD file disagree:
    #   gsd10   10 bytes out, 8 in, as the printed GSD file ESCO1803.GSD configures it
    #   doc9     9 bytes out, 8 in, as the tables of the manual say
    #   whole10 10 bytes out, 8 in behind one consistent identifier; invented, no real GSD has it
    layout: gsd10

    # Better: the GSD file of your device, beside this file, and by name which of its modules are
    # plugged, where there are several. Layout and identifiers then come from there, so layout can
    # be left out, and what contradicts the catalogue is told. `fbgen gsd FILE` shows the names.
    # gsd: esco1803.gsd
    # modules: ["Binary Mode"]

    # Of gateways for process data (pbdp110, layouts module1 to module4) the GSD file is not public:
    # the identifiers of the module as that file has them, if not those of the catalogue.
    # identifiers: C0 C7 CB

    # As set on the rotary switches (B x 10 + A); a change counts after switching off and on.
    profibus_address: 2

    # Which DP master system, where the PLC has several: more than 99 gateways need them.
    dp_master: 1

    # How the blocks reach the data:
    #   per_identifier  identifier by identifier, the trigger byte last (gsd10, doc9)
    #   process_image   through the process image, the trigger one cycle after its data; on iec and
    #                   twincat the only way
    #   dpxx_dat        the whole frame by DPRD_DAT/DPWR_DAT, SFC14/15 (whole10)
    access: per_identifier

    # First byte in the input and in the output area of the PLC.
    input_address: 256
    output_address: 256

    # For dpxx_dat on S7-1200 and S7-1500 instead of the two addresses:
    # hardware_identifier: 270

    # For gateways for process data on an S7: the diagnostic address of the station (S7-300/400), or
    # its hardware identifier (S7-1200, S7-1500), as the device configuration shows it. With it the
    # blocks read the slave's diagnosis (DPNRM_DG, SFC13), and know a trip in modules 3 and 4.
    # diagnosis_address: 2046

    # Read trip code and status of every drive in turn while no command waits.
    status_poll: true

    # For gateways for process data: the program may write parameters into the EEPROM of the drives,
    # whose cells last about 10,000 writes.
    # eeprom: true

    # First values of the line's parameters in TOS_Parameters; in iec and plcopen they count each
    # time. Without timeout_ms (limit for one attempt of a telegram) it is calculated.
    parameters:
      retries: 2

    # What the documents leave open, with the documented default. `fbgen catalog show tospbdp001`
    # explains each; all but the first concern the simulated gateway only.
    options:
      handshake: true
      trigger_poll: false
      error_counter: restart
      error_status_code: hms
      status_toggle: when_taken
      offline_timeout_ms: 0
      offline_inputs: freeze
      offline_outputs: no_scanning
      startup_lock: none
      subnet_error_led: device_status
      startup_ms: 0
      heartbeat_frame: "(**P08800001)"

    drives:
      - name: infeed
        title: Infeed conveyor   # optional
        inv_no: 1                # 0 to 63, parameter F802; number 0 also answers broadcasts
        # channel: A             # behind a pbdp110 instead of inv_no: A or B
        series: vf-s11
        max_frequency_hz: 50.0   # parameter FH
        parameters:              # first values of the drive's parameters in TOS_Parameters
          min_frequency_hz: 0    # a lower set-point is raised to it
          at_setpoint_hz: 0.5    # so far off it counts as at set-point
          error_pause_ms: 1000   # before a command without acknowledgement is tried again
          local_inhibits: true   # one that obeys its panel or terminals is not told to run
          interlock_inhibits: true   # its interlock back, it waits for a new run
      - name: outfeed
        inv_no: 2
        series: vf-s11
        max_frequency_hz: 60.0
        options:
          timeout_restart: any_answered
          broadcast_reads: false
"""


def write_commented_plant() -> str:
    """The text of a complete, valid plant file in which every key is explained."""
    return _TEXT
