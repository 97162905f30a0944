"""In which configuration a seed tries a plant: its PLC, how it reaches the data, and all the times.

What takes a program of its own (language, PLC, access way, layout, options, cycle) is the same for
`SEEDS_PER_PROGRAM` seeds, because generating and reading one takes as long as running a seed. The
times of PLC, PROFIBUS and drives, and what a gateway has left from before the start, are drawn by
each seed: boundary values of the trigger on purpose, as no counter wraps around by chance.
"""

from itertools import product
from random import Random

from fbgen.catalog import Catalog, TelegramGateway
from fbgen.catalog.options import Option
from fbgen.diagnostics import DiagnosticError
from fbgen.plant import Plant, PlantGateway, SerialLine
from harness.kernel import NS_PER_MS, NS_PER_US
from harness.scenario.model import Variation
from harness.scenario.plant_changes import varied_plant
from harness.verify.campaign.entries import Entry, written_time

SEEDS_PER_PROGRAM = 10
TRIGGERS = (0, 1, 253, 254, 255)
"""Where a trigger stands at the start; those at its wrap-around."""
_PLCS = (
    ("tia", "s7-1500"),
    ("tia", "s7-1200"),
    ("tia", "s7-300"),
    ("tia", "s7-400"),
    ("step7", "s7-300"),
    ("step7", "s7-400"),
    ("iec", "iec"),
    ("twincat", "twincat"),
)
_ACCESS = ("per_identifier", "dpxx_dat", "process_image")
_CYCLES_MS = (5, 20, 40)
_BUS_CYCLES_MS = (1, 2, 3, 5)
_PHASES_NS = 60 * NS_PER_MS
"""All bus cycles, the gateway's look at the trigger and the PLC's cycle begin together so often."""
_SHARES_OF_CYCLE = (0.1, 0.4, 0.8)
_STATUS_BITS = (0x0000, 0x4000, 0x8000, 0xC000)
_NO_ERROR, _ERRORS = 0x1F00, (1, 254, 255)
_READS = (0xFC90, 0xFD01, 0xFD00, 0xFE03, 0xFA00)


def variations(plan: Plant, catalog: Catalog) -> tuple[Entry, ...]:
    """The plant as it is, and every other PLC, access way and layout that its file allows.

    A plant with gateways of several types keeps their layouts, as none of them is for all.
    """
    types = {item.type for item in plan.gateways}
    layouts: list[Entry] = [{}]
    if len(types) == 1:
        layouts = [{"layout": item.name} for item in catalog.profibus_gateway(types.pop()).layouts]
    found: list[Entry] = [{}]
    for (dialect, plc), access, layout in product(_PLCS, _ACCESS, layouts):
        entry = {"dialect": dialect, "plc": plc, "access": access, **layout}
        if is_allowed(plan, entry, catalog):
            found.append(entry)
    return tuple(found)


def telegram_gateways(plan: Plant, catalog: Catalog) -> list[PlantGateway]:
    """Those of a plant that carry telegrams: the others have no trigger, and forget everything."""
    return [
        item for item in plan.gateways if isinstance(catalog.gateway(item.type), TelegramGateway)
    ]


def asked_units(plan: Plant, catalog: Catalog) -> list[PlantGateway | SerialLine]:
    """Gateways and serial lines whose drives are asked by telegrams."""
    return [*telegram_gateways(plan, catalog), *plan.serial]


def is_allowed(plan: Plant, entry: Entry, catalog: Catalog) -> bool:
    """Whether the plant file allows these changes."""
    try:
        varied_plant(plan, Variation.model_validate(entry), catalog)
    except DiagnosticError:
        return False
    return True


def draw_program(
    random: Random, plan: Plant, allowed: tuple[Entry, ...], catalog: Catalog
) -> Entry:
    """The variation of the plant: one of those that are allowed, mostly with the cycle of the plant
    file, and one of the gateway's options in another position."""
    entry = dict(random.choice(allowed))
    wilder = dict(entry)
    if random.random() < 0.5:
        wilder["cycle_time_ms"] = float(random.choice(_CYCLES_MS))
    switches = _switches(catalog, plan.gateways[0]) if plan.gateways else []
    if random.random() < 0.5 and switches:
        option = random.choice(switches)
        positions = (True, False) if option.type == "flag" else tuple(option.choices)
        chosen = plan.gateways[0].options.get(option.id, option.default)
        others = [position for position in positions if position != chosen]
        wilder["options"] = {option.id: random.choice(others)}
    return wilder if is_allowed(plan, wilder, catalog) else entry


def _switches(catalog: Catalog, gateway: PlantGateway) -> list[Option]:
    """The options with few positions."""
    options = catalog.profibus_gateway(gateway.type).options
    return [option for option in options if option.type in ("flag", "choice")]


def draw_start(random: Random, plan: Plant, program: Entry, catalog: Catalog) -> Entry:
    """Times of bus, PLC and drives, and what is left in the gateways."""
    cycle_ms = program.get("cycle_time_ms", plan.cycle_time_ms)
    execution_ns = round(random.choice(_SHARES_OF_CYCLE) * cycle_ms * NS_PER_MS)
    times = {
        "profibus": f"{random.choice(_BUS_CYCLES_MS)} ms",
        "start": written_time(random.randrange(_PHASES_NS // NS_PER_US) * NS_PER_US),
        "execution": written_time(execution_ns),
    }
    drives: Entry = {}
    on_devicenet = {drive.name for drive in plan.devicenet_drives}
    for drive in plan.drives:
        if drive.name not in on_devicenet and random.random() < 0.5:
            longest_ms = int(catalog.drive(drive.series).times.reply_max.ms)
            drives[drive.name] = {"reply_time": f"{random.randint(1, longest_ms)} ms"}
    gateways = {
        gateway.name: _left(random, gateway)
        for gateway in telegram_gateways(plan, catalog)
        if random.random() < 0.5
    }
    parts = {"times": times, "drives": drives, "gateways": gateways}
    return {key: part for key, part in parts.items() if part}


def _left(random: Random, gateway: PlantGateway) -> Entry:
    """A gateway that had its supply before: with the reply to something that the PLC reads soon."""
    status = _NO_ERROR if random.random() < 0.5 else random.choice(_ERRORS)
    reply = bytes((random.choice(gateway.drives).inv_no, random.choice(b"Gg")))
    reply += random.choice(_READS).to_bytes(2, "big") + random.choice((b"\0\0", b"\xff\xff"))
    return {
        "trigger": random.choice(TRIGGERS),
        "status": f"16#{status | random.choice(_STATUS_BITS):04X}",
        "reply": reply.hex(" ").upper(),
    }
