"""The plant file: what the user has, and which blocks are wanted for it."""

from fbgen.plant.changing import changed, in_dialect, problems_of
from fbgen.plant.commented import write_commented_plant
from fbgen.plant.commented_sequence import OWN_SEQUENCE_FILE, write_own_sequence
from fbgen.plant.cpus import CPUS, Cpu, cpus_of
from fbgen.plant.devicenet import DeviceNetConnection, DeviceNetDrive, DeviceNetNetwork
from fbgen.plant.devicenet_checks import ACTIVE_LENGTH, assemblies_of, instances
from fbgen.plant.drive import PlantDrive
from fbgen.plant.families import (
    FAMILIES,
    FILE_LAYOUTS,
    LANGUAGES,
    Family,
    FileLayout,
    PlantDialect,
    PlcFamily,
)
from fbgen.plant.gsd_checks import gsd_warnings
from fbgen.plant.gsd_file import GsdFile, plugged, read_gsd_file
from fbgen.plant.loading import load_plant, read_plant
from fbgen.plant.modules import layout_of
from fbgen.plant.plant import (
    HIGHEST_BLOCK,
    BlockNumbers,
    Plant,
    PlantGateway,
    PlantUnit,
)
from fbgen.plant.prefix import with_prefix
from fbgen.plant.reach import OLDER_CPUS_MOVE, Move, Refusal, move_of, not_a_way, refusal
from fbgen.plant.serial_checks import buffer_numbers, module_of, place_of, port_of
from fbgen.plant.serial_line import SerialLine

__all__ = [
    "ACTIVE_LENGTH",
    "DeviceNetConnection",
    "DeviceNetDrive",
    "DeviceNetNetwork",
    "assemblies_of",
    "BlockNumbers",
    "CPUS",
    "Cpu",
    "FAMILIES",
    "FILE_LAYOUTS",
    "Family",
    "FileLayout",
    "GsdFile",
    "HIGHEST_BLOCK",
    "LANGUAGES",
    "Move",
    "OLDER_CPUS_MOVE",
    "OWN_SEQUENCE_FILE",
    "Plant",
    "PlantDialect",
    "PlantDrive",
    "PlantGateway",
    "PlantUnit",
    "PlcFamily",
    "Refusal",
    "SerialLine",
    "buffer_numbers",
    "changed",
    "cpus_of",
    "gsd_warnings",
    "in_dialect",
    "instances",
    "layout_of",
    "load_plant",
    "module_of",
    "move_of",
    "not_a_way",
    "place_of",
    "plugged",
    "port_of",
    "problems_of",
    "read_gsd_file",
    "read_plant",
    "refusal",
    "with_prefix",
    "write_commented_plant",
    "write_own_sequence",
]
