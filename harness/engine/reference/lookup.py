"""From a path given from outside to the storage it names."""

from collections.abc import Sequence

from harness.engine.faults import unknown_name, wrong_path
from harness.engine.paths import FOLLOW, Step
from harness.engine.reference.places import flat_index
from harness.engine.reference.pointers import Pointed
from harness.engine.reference.storage import Array, InstanceStorage, Storage, Structure


def find_part(storage: Storage, steps: Sequence[Step], path: str) -> Storage:
    """The part that the steps lead to. Raises FB6002, FB6020 and FB6024."""
    for step in steps:
        storage = _named(storage, step, path) if isinstance(step, str) else _at(storage, step, path)
    return storage


def _named(storage: Storage, name: str, path: str) -> Storage:
    key = name.casefold()
    if name == FOLLOW:
        pointed = storage.read()
        target = pointed.find(None) if isinstance(pointed, Pointed) else None
        if target is None:
            raise wrong_path(path, "there is no reference in front of ^, or it refers to nothing")
        return target
    if isinstance(storage, Structure):
        if key not in storage.parts:
            names = [field.name for field in storage.kind.fields]
            raise unknown_name(f"part of {storage.kind}", name, names)
        return storage.parts[key]
    if isinstance(storage, InstanceStorage):
        variable = storage.variable(key)
        if variable is None or (key not in storage.parts and key not in storage.connections):
            names = [
                declared.name
                for declared in storage.block.variables
                if declared.name.casefold() in storage.parts
                or declared.name.casefold() in storage.connections
            ]
            raise unknown_name(f"variable of {storage.block.name}", name, names)
        return storage.part(key)
    raise wrong_path(path, f"{storage.kind} has no part '{name}'")


def _at(storage: Storage, indices: tuple[int, ...], path: str) -> Storage:
    if not isinstance(storage, Array):
        raise wrong_path(path, f"{storage.kind} is not an array")
    bounds = storage.kind.bounds
    if len(indices) != len(bounds):
        raise wrong_path(path, f"{storage.kind} takes {len(bounds)} indices")
    return storage.elements[flat_index(bounds, indices, None)]
