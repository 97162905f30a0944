"""The blocks for gateways with process data (PBDP-110): a drive at each channel, parameters."""

from collections.abc import Iterator, Sequence

from fbgen.blocks.alarms import that_can_come
from fbgen.blocks.family import FamilyPlan
from fbgen.blocks.gateways import other_types
from fbgen.blocks.literals import SclText, one_line, word
from fbgen.blocks.pbdp_alarms import GATEWAY_ALARMS, PBDP_DRIVE_ALARMS
from fbgen.blocks.pbdp_gateways import (
    PbdpGatewayView,
    pbdp_gateway_view,
    trip_text_of,
    unknown_fields,
)
from fbgen.blocks.specs import BlockSpec, block, data_block, data_type
from fbgen.blocks.texts import Texts
from fbgen.blocks.trips import trip_texts
from fbgen.blocks.words import WordView
from fbgen.catalog import Catalog, ProcessDataGateway, origin
from fbgen.diagnostics import Diagnostic, Severity
from fbgen.plant import Plant, PlantGateway

_ERROR_STATUS = 0x8500
"""Status of a job that the gateway has refused; its error code stands in the low byte."""
_TYPES = (
    *("Input", "Output", "Inputs", "Outputs"),
    *("Control", "State", "Polled", "Job", "Drive", "Line", "LineParam", "DriveParam"),
)


def pbdp_problems(chosen: Sequence[PlantGateway], catalog: Catalog) -> Iterator[Diagnostic]:
    """FB5008 layouts that the blocks do not know, FB5009 gateways of several types."""
    yield from unknown_fields(chosen, catalog)
    yield from other_types(chosen)


def pbdp_family(
    plant: Plant, chosen: Sequence[PlantGateway], catalog: Catalog, texts: Texts
) -> FamilyPlan:
    """What the gateways for process data need; there is at least one."""
    gateways = tuple(pbdp_gateway_view(plant, item, catalog) for item in chosen)
    entry = catalog.process_data_gateway(chosen[0].type)
    series = catalog.drive(chosen[0].drives[0].series)
    context: dict[str, object] = {
        "pbdp": _gateway_context(entry, gateways, texts)
        | {"trip_hex": f"{series.comno(series.link.trip).hex}h"},
        "pbdp_alarms": {
            "line": that_can_come(GATEWAY_ALARMS, chosen),
            "drive": that_can_come(PBDP_DRIVE_ALARMS, chosen),
        },
    }
    types = [data_type(f"typePbdp{name}") for name in _TYPES]
    types += [
        data_type(f"{name}_{item.name}", name, {"gateway": item})
        for item in gateways
        for name in ("typePbdpGateway", "typePbdpParam")
    ]
    return FamilyPlan(
        units=gateways,
        types=types,
        blocks=list(_blocks(gateways, catalog)),
        data=[
            data_block(f"PBDP_Gateway_{item.name}_DB", "PBDP_Gateway_DB", {"gateway": item})
            for item in gateways
        ],
        context=context,
        warnings=tuple(_eeprom_writes(chosen)),
    )


def _blocks(gateways: tuple[PbdpGatewayView, ...], catalog: Catalog) -> Iterator[BlockSpec]:
    with_parameters = [item for item in gateways if item.has_parameters]
    if with_parameters:
        yield block("PBDP_Parameter")
        yield block("PBDP_Poll")
    series = dict.fromkeys(drive.series for item in with_parameters for drive in item.drives)
    for name in series:
        found = trip_texts(name, catalog)
        yield block(trip_text_of(name), "PBDP_TripText", {"texts_of": found})
    yield block("PBDP_Drive")
    yield block("PBDP_Alarms")
    for item in gateways:
        if item.diagnosis_laddr is not None:
            yield block(f"PBDP_Diagnosis_{item.name}", "PBDP_Diagnosis", {"gateway": item})
    for name in ("PBDP_Io", "PBDP_Gateway"):
        for item in gateways:
            yield block(f"{name}_{item.name}", name, {"gateway": item})


def _gateway_context(
    entry: ProcessDataGateway, gateways: tuple[PbdpGatewayView, ...], texts: Texts
) -> dict[str, object]:
    access, times = entry.parameter_channel, entry.times
    action, response = entry.word(access.action), entry.word(access.response_word)
    actions, responses = WordView(action, entry.id), WordView(response, entry.id)
    to_request = action.field(access.request)
    to_response = response.field(access.response)

    def request(name: str) -> SclText:
        value = access.request_code(name) << to_request.low
        return word(value, actions.mask(access.request).origin)

    def answer(name: str) -> SclText:
        value = access.response_code(name) << to_response.low
        return word(value, responses.mask(access.response).origin)

    longest = times.parameter_max
    return {
        "command": WordView(entry.word("command"), entry.id),
        "status": WordView(entry.word("status"), entry.id),
        "request_mask": actions.mask(access.request),
        "response_mask": responses.mask(access.response),
        "idle": answer("idle"),
        "read": request("read"),
        "write_ram": request("write_ram"),
        "write_eeprom": request("write_eeprom"),
        "answered": answer("read"),
        "written": answer("written"),
        "failed": answer("error"),
        "errors": [
            {
                "status": f"{_ERROR_STATUS | item.code:04X}",
                "text": SclText(
                    one_line(item.title),
                    origin(f"error {item.code:04X}", item, item.source or ""),
                ),
            }
            for item in access.errors
        ],
        "timeout": gateways[0].timeout,
        "parameter_comment": SclText(
            texts("{time} ms at most (unverified)", time=f"{longest.ms:g}"),
            origin(f"{entry.id} parameter_max", longest, longest.source or ""),
        ),
    }


def _eeprom_writes(chosen: Sequence[PlantGateway]) -> Iterator[Diagnostic]:
    for gateway in chosen:
        if gateway.eeprom:
            yield Diagnostic(
                "FB5005",
                f"the program may write parameters into the EEPROM of the drives of "
                f"'{gateway.name}' (mode 3 of PBDP_Parameter)",
                gateway.span_of("eeprom"),
                "a cell lasts about 10,000 writes: never do it cyclically; mode 2 uses the RAM",
                severity=Severity.WARNING,
            )
