"""What a scenario changes of its plant: variations of the plant file, drives set beforehand."""

from collections.abc import Iterator
from dataclasses import replace

from fbgen.catalog import Catalog, Drive, TelegramGateway
from fbgen.diagnostics import Diagnostic, DiagnosticError, Note
from fbgen.nearest import nearest
from fbgen.plant import Plant, problems_of
from harness.drives import Inverter, InverterSettings
from harness.installation import without_effect
from harness.kernel import Kernel
from harness.line import Line
from harness.scenario.model import DriveSetup, Scenario, Variation
from harness.scenario.places import at, key_span, value_span


def varied_plant(plant: Plant, variation: Variation, catalog: Catalog) -> Plant:
    """The plant with the changes of a variation. DiagnosticError if it does not allow them."""
    gateway_changes = {
        key: value
        for key, value in (("layout", variation.layout), ("access", variation.access))
        if value is not None
    }
    gateways = tuple(
        gateway.model_copy(
            update={**gateway_changes, "options": {**gateway.options, **variation.options}}
        )
        for gateway in plant.gateways
    )
    changes: dict[str, object] = {"gateways": gateways}
    changes |= {
        key: value
        for key, value in (
            ("dialect", variation.dialect),
            ("plc", variation.plc),
            ("prefix", variation.prefix),
            ("error_obs", variation.error_obs),
            ("cycle_time_ms", variation.cycle_time_ms),
        )
        if value is not None
    }
    changed = plant.model_copy(update=changes)
    if found := problems_of(changed, catalog):
        raise DiagnosticError(_of_variation(item, variation) for item in found)
    return changed


def _of_variation(found: Diagnostic, variation: Variation) -> Diagnostic:
    """What the plant does not allow, at the variation that asks for it."""
    notes = (*found.notes, Note("in the plant file the place is here", found.span))
    return replace(found, span=variation.span, notes=notes)


def device_problems(scenario: Scenario, plan: Plant, catalog: Catalog) -> Iterator[Diagnostic]:
    """FB8003 for devices that the plant does not have, FB7503 for what has no effect on them, and
    what series of drives do not take."""
    gateways = [
        item.name
        for item in plan.gateways
        if isinstance(catalog.gateway(item.type), TelegramGateway)
    ]
    for name in scenario.gateways:
        if name not in gateways:
            message = f"there is no gateway '{name}' in the plant '{plan.name}'"
            place = key_span(scenario, "gateways", name)
            yield Diagnostic("FB8003", message, place, nearest(name, gateways))
    known = plan.series_of_drives
    for name, setup in scenario.drives.items():
        if name in known:
            yield from _parameter_problems(setup, catalog.drive(known[name]))
            places = {key: setup.span_of(key) for key in ("port", "reply_time")}
            yield from without_effect(plan, name, setup.conditions(), places)
        else:
            message = f"there is no drive '{name}' in the plant '{plan.name}'"
            place = key_span(scenario, "drives", name)
            yield Diagnostic("FB8003", message, place, nearest(name, known))


def _parameter_problems(setup: DriveSetup, series: Drive) -> Iterator[Diagnostic]:
    """Port and each parameter tried on a drive of its own, so that each refusal has its place."""
    if setup.port is not None:
        kernel = Kernel()
        try:
            Inverter(kernel, Line(kernel), series, InverterSettings(port=setup.port))
        except DiagnosticError as refused:
            yield from at(setup.span_of("port"), refused.diagnostics)
    for key, value in setup.parameters.items():
        kernel = Kernel()
        try:
            Inverter(kernel, Line(kernel), series, InverterSettings(parameters={key: value}))
        except DiagnosticError as refused:
            yield from at(value_span(setup, "parameters", key), refused.diagnostics)
