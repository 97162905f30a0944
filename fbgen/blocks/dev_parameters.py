"""The parameter channel of a DeviceNet option as the templates see it."""

from fbgen.blocks.literals import ComNoText, SclText, comno, truth, word
from fbgen.blocks.words import WordView
from fbgen.catalog import AssemblyPair, Catalog, DeviceNetGateway, Drive, origin
from fbgen.catalog.devicenet_gateways import OF_F, RegisterChannel, Selection
from fbgen.dataclass import dataclass
from fbgen.plant import DeviceNetDrive, DeviceNetNetwork, Plant, assemblies_of

_AT_REST = 3
"""So many numbers are read in turn while no job is under way: not the last, nor one that begins as
the job's does."""
_WHOLE_WORD = 0xFFFF

_EXCHANGES = 6
"""A job takes three, each of a scan and a cycle; as many again are in reserve."""
_WRITE_MS = 500
"""How long a write takes in the drive no document says."""


@dataclass(frozen=True, slots=True)
class ChannelView:
    """A parameter channel: the output instance that it lies in, and the bits of its words.

    `shared`: number and write bit, and number and error bit, are one word; then a response does not
    say whether it is one to a write.
    """

    instance: SclText
    shared: bool
    write_mask: SclText
    written_mask: SclText | None
    error_mask: SclText
    index_mask: SclText


@dataclass(frozen=True, slots=True)
class DriveChannelView:
    """The parameter channel of one drive: what DEV_Poll and the text of the trip need."""

    shared: SclText
    trip_number: ComNoText
    trip_text: str


def drive_channel(
    entry: DeviceNetGateway, pair: AssemblyPair, series: Drive
) -> DriveChannelView | None:
    """The channel of a drive by its assemblies, None if these have none."""
    found = _channel_of(entry, pair)
    if found is None:
        return None
    place = origin(f"{entry.id} {pair.name}", found, found.source or "")
    return DriveChannelView(
        shared=truth(_is_shared(found), place),
        trip_number=comno(series.comno(series.link.trip)),
        trip_text=trip_text_of(series.id),
    )


def has_channel(drive: DeviceNetDrive, catalog: Catalog) -> bool:
    """Whether the assemblies of a drive have a parameter channel."""
    entry = catalog.devicenet_gateway(drive.type)
    pair = assemblies_of(drive, entry)
    return pair is not None and _channel_of(entry, pair) is not None


def trip_text_of(series: str) -> str:
    """The function with the trips of a series in words: `DEV_TripText_vf_s15`."""
    return f"DEV_TripText_{series.replace('-', '_')}"


def job_timeout_ms(plant: Plant, network: DeviceNetNetwork) -> float:
    """How long a job may take."""
    return _WRITE_MS + _EXCHANGES * (network.scan_ms + plant.cycle_time_ms)


def _channel_of(entry: DeviceNetGateway, pair: AssemblyPair) -> RegisterChannel | None:
    return next((item for item in entry.register_channels if item.assemblies == pair.name), None)


def _is_shared(channel: RegisterChannel) -> bool:
    return channel.index == channel.request


def parameter_context(entry: DeviceNetGateway) -> dict[str, object]:
    """What DEV_Parameter needs of the catalogue, whatever assemblies a drive exchanges."""
    rule = entry.parameter_object
    place = origin(f"{entry.id} numbers that begin with F", rule, rule.source or "")
    views = [_view(entry, channel) for channel in entry.register_channels]
    return {
        "shared": next(view for view in views if view.shared),
        "separate": next(view for view in views if not view.shared),
        "rest": [
            word(item.comno, origin(f"{entry.id} monitor {item.code}", item, item.source or ""))
            for item in _at_rest(entry)
        ],
        "of_f": word(OF_F, place),
    }


def _at_rest(entry: DeviceNetGateway) -> list[Selection]:
    """Monitors, which can only be read: the first of each high byte."""
    firsts = {item.comno >> 8: item for item in reversed(entry.monitors) if item.comno >= OF_F}
    found = [item for item in entry.monitors if item in firsts.values()]
    return found[:_AT_REST]


def _view(entry: DeviceNetGateway, channel: RegisterChannel) -> ChannelView:
    pair = entry.pair(channel.assemblies)
    place = origin(f"{entry.id} {pair.name}", channel, channel.source or "")
    request = WordView(entry.word(pair.output.field(channel.request).word or ""), entry.id)
    response = WordView(entry.word(pair.input.field(channel.response).word or ""), entry.id)
    shared = _is_shared(channel)
    return ChannelView(
        instance=SclText(str(pair.output.instance), place),
        shared=shared,
        write_mask=request.mask("write"),
        written_mask=None if shared else response.mask("write"),
        error_mask=response.mask("error"),
        index_mask=request.mask("index") if shared else word(_WHOLE_WORD, place),
    )
