"""Any bytes as a GSD file give a station or diagnostics; what is right pyprofibus reads alike."""

from hypothesis import Phase, given, settings
from hypothesis import strategies as st

from fbgen.diagnostics import DiagnosticError, render
from fbgen.wire.gsd import choose, read_gsd
from fbgen.wire.gsd.keywords import KEYWORDS
from tests.unit.wire.foreign_gsd import foreign_station

PIECES = [
    *KEYWORDS.values(),
    *("#Profibus_DP\n", "#", "=", "(", ")", ",", "-", "@", '"', "\\", "\\\n", ";", "\n", " "),
    *("0", "0x", "0x30", "255", "256", "99999999999999999999999", "Ä", "\x81", "\0"),
]
texts = st.lists(st.sampled_from(PIECES) | st.text(max_size=3), max_size=60).map("".join)
anything = st.binary(max_size=200) | texts.map(lambda text: text.encode("utf-8", "replace"))


@settings(max_examples=150)
@given(anything, st.booleans())
def test_any_bytes_give_a_station_or_diagnostics_with_places(data: bytes, begun: bool) -> None:
    head = b"#Profibus_DP\nIdent_Number=1\n" if begun else b""
    try:
        station = read_gsd(head + data, "any.gsd")
        choose(station)
        found = station.warnings
    except DiagnosticError as wrong:
        found = wrong.diagnostics
        assert found
    for diagnostic in found:
        assert render(diagnostic)


FULL = 7
"""Identifiers with 32 bytes each that fit into the 244 bytes of a slave."""
names = st.text("abcXYZ019 ", max_size=8)
named = names.map(lambda name: " ".join(f"m{name}".split()))
sizes = st.integers(0, 15)
kinds = st.sampled_from((0x10, 0x20, 0x30))
units = st.sampled_from((0, 0x40, 0x80, 0xC0))
identifiers = st.builds(lambda size, kind, unit: size | kind | unit, sizes, kinds, units)
modules = st.lists(
    st.tuples(named, st.lists(identifiers, min_size=1, max_size=6).map(bytes)),
    min_size=1,
    max_size=4,
    unique_by=lambda module: module[0].lower(),
).filter(lambda written: sum(len(code) for _, code in written) <= FULL)


@settings(max_examples=12, phases=[Phase.generate])
@given(modules, st.integers(0, 0xFFFF), st.binary(max_size=8), st.sampled_from(("\n", "\r\n")))
def test_pyprofibus_reads_the_same_stations(
    written: list[tuple[str, bytes]], ident: int, parameters: bytes, end: str
) -> None:
    lines = ["#Profibus_DP", f"Ident_Number = 0x{ident:04X}", "Modular_Station = 1"]
    if parameters:
        lines.append("User_Prm_Data = " + ",".join(map(hex, parameters)))
        lines.append(f"User_Prm_Data_Len = {len(parameters)}")
    for name, code in written:
        lines += [f'Module = "{name}" ' + ",\\\n".join(map(hex, code)), "EndModule"]
    text = end.join(lines)
    ours = choose(read_gsd(text.encode(), "made.gsd"), [name for name, _ in written])
    theirs = foreign_station(text.encode())
    for name, _ in written:
        theirs.setConfiguredModule(name)
    assert ours.station.ident_number == theirs.getIdentNumber()
    assert ours.code == b"".join(bytes(one.getDU()) for one in theirs.getCfgDataElements())
    assert ours.user_parameters == theirs.getUserPrmData()
