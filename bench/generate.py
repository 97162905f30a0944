"""Generating the text of large plants: 10, 50 and 100 gateways with five drives each.

What a user waits for: reading the plant file, the text of all blocks, checked and held to the
import rules. Processor time of this process, the smallest of some runs; the catalogue is read once.
"""

from collections.abc import Iterator
from time import process_time

from bench.measuring import Figure, measure
from fbgen.catalog import load_catalog
from fbgen.emit.generator import generate
from fbgen.plant import read_plant
from fbgen.source import Source

_SIZES = (10, 50, 100)
_DRIVES = 5
_RUNS = 3
_ADDRESSES = 99
_HEAD = """\
version: 1
name: bench
dialect: tia
plc: s7-1500
sequences: [start_forward, stop, fault_reset, set_frequency, read_current, emergency_stop]
gateways:
"""


def plant_text(gateways: int) -> str:
    """A plant file with that many gateways; every 99 of them have a DP master system."""
    text = _HEAD
    for number in range(gateways):
        master, address = divmod(number, _ADDRESSES)
        text += (
            f"  - name: gw{number}\n    type: tospbdp001\n    layout: gsd10\n"
            f"    profibus_address: {address + 1}\n    dp_master: {master + 1}\n"
            f"    access: per_identifier\n"
            f"    input_address: {number * 10}\n    output_address: {number * 10}\n    drives:\n"
        )
        for drive in range(_DRIVES):
            text += (
                f"      - {{name: drive{number}_{drive}, inv_no: {drive + 1}, series: vf-s11, "
                "max_frequency_hz: 50.0}\n"
            )
    return text


def figures() -> Iterator[Figure]:
    """Processor time of each size; it grows with the number of gateways."""
    catalog = load_catalog()
    empty = measure("", lambda: [None for _ in range(1000)], per=1000)
    turn = empty.seconds / max(empty.turns, 1e-9)
    for size in _SIZES:
        source = Source("plant.yaml", plant_text(size))
        best = float("inf")
        for _ in range(_RUNS):
            start = process_time()
            files = generate(read_plant(source, catalog), catalog).files
            best = min(best, process_time() - start)
        lines = sum(file.text.count("\n") for file in files)
        limit = "at most 3 s" if size == max(_SIZES) else ""
        yield Figure(f"{size} gateways, {lines:,} lines", best, best / turn, limit)
