"""What a seed does behind a gateway for process data, and on DeviceNet: jobs in parameter channels,
and when a drive there is well again."""

from collections.abc import Mapping
from random import Random

from fbgen.catalog import Catalog
from fbgen.plant import DeviceNetDrive, Plant, PlantDrive, PlantGateway, layout_of
from harness.verify.campaign.entries import Entry

_READ, _WRITE_RAM = 1, 2
_RAMP = 0x0009
"""ACC, which every series has: a ramp may have any of the values below."""
_READS = (_RAMP, 0xFC82, 0xFD00, 0x7FFF, 0x0000)
"""A parameter, the gateway's own, a value that changes, none at all, and the number of zeros."""
_RAMPS = (1, 10, 50, 0xFFFF)


def asked_in_parameter_channel(
    random: Random, unit: str, drive: PlantDrive | DeviceNetDrive
) -> Entry:
    """A job, or the end of the one before; in modules without parameter channel it is refused."""
    job = f"plc.TOS_Plant.{unit}.{drive.name}.parameter"
    if random.random() < 0.4:
        return {f"{job}.execute": False, f"{job}.abort": random.random() < 0.3}
    ask: Mapping[str, int]
    if random.random() < 0.6:
        ask = {"mode": _READ, "number": random.choice(_READS)}
    else:
        ask = {"mode": _WRITE_RAM, "number": _RAMP, "value": random.choice(_RAMPS)}
    begin: Entry = {f"{job}.execute": True, f"{job}.abort": False}
    return {f"{job}.{name}": value for name, value in ask.items()} | begin


def well_at_an_interface(
    plan: Plant, gateway: PlantGateway, drive: PlantDrive, catalog: Catalog
) -> Entry:
    """What is expected of a drive when all faults are over. A trip of which nothing tells the PLC
    cannot be reset by it."""
    known = catalog.process_data_gateway(gateway.type)
    base = f"plc.TOS_Plant.{gateway.name}.{drive.name}"
    well: Entry = {f"{base}.state.online": True, f"{base}.state.inhibited": False}
    told = gateway.diagnosis_address is not None and plan.family.whole_frame
    if known.has_parameter_channel(layout_of(gateway, known)):
        well[f"{base}.parameter.busy"] = False
        if gateway.status_poll:
            well[f"{base}.polled.valid"] = told = True
    return well | {f"drive.{drive.name}.tripped": False} if told else well
