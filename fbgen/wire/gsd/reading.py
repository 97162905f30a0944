"""A GSD file -> `GsdStation`. Whatever bytes a file holds, there is a station or a diagnostic."""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from difflib import get_close_matches

from fbgen.diagnostics import Diagnostic, DiagnosticError, Severity
from fbgen.source import Source, Span
from fbgen.wire.gsd.keywords import BLOCKS, KEYWORDS, RATES
from fbgen.wire.gsd.lines import Kind, gsd_lines
from fbgen.wire.gsd.parameters import (
    NamedParameter,
    named_parameter,
    preset_parameters,
)
from fbgen.wire.gsd.slots import slot_definitions
from fbgen.wire.gsd.statements import Block, Statement, Tree, gsd_tree, number_of
from fbgen.wire.gsd.station import DiagnosisText, GsdModule, GsdStation, Limits, Rate
from fbgen.wire.gsd.text import gsd_source
from fbgen.wire.gsd.values import Values, not_a, numbers_of, octets_of
from fbgen.wire.profibus import IdentifierError, decode_identifiers

_INTERVAL_US = 100
"""Unit of Min_Slave_Intervall."""
_MOST_IDENTIFIERS = 244
"""Chk_Cfg has up to 244 bytes."""
_ALIKE = 0.87
_ALIKE_SEARCHED = 100
"""So many unknown keywords are compared with the known ones; a file with more is no slip."""


def read_gsd(data: bytes, name: str) -> GsdStation:
    """The station that a GSD file describes; `name` is the file's, for messages.

    Raises DiagnosticError with everything that is wrong: FB1301 no GSD file, FB1303 values, FB1304
    blocks, FB1305 identifiers, FB1306 no ident number. What does no harm is in its `warnings`.
    """
    source = gsd_source(data, name)
    tree = gsd_tree(gsd_lines(source))
    findings = list(tree.findings)
    station = _station(source, tree, findings)
    findings += _unknown_keywords(tree)
    findings = sorted(dict.fromkeys(findings), key=lambda item: item.span.start if item.span else 0)
    if any(item.severity is Severity.ERROR for item in findings):
        raise DiagnosticError(item for item in findings if item.severity is Severity.ERROR)
    return replace(station, warnings=tuple(findings))


def _station(source: Source, tree: Tree, findings: list[Diagnostic]) -> GsdStation:
    values = Values(tree.statements, findings)
    if "ident_number" not in values.known:
        first = source.text.partition("\n")[0]
        findings.append(
            Diagnostic(
                "FB1306",
                f"{source.name} has no Ident_Number",
                Span(source, 0, len(first)),
                "a slave refuses a master that does not send its ident number: take the whole file "
                "of the device's maker",
            )
        )
    found = (named_parameter(block, findings) for block in tree.blocks_of("ExtUserPrmData"))
    named = dict(item for item in found if item is not None)
    length = values.optional_number("User_Prm_Data_Len", 0xFF)
    if any(line.key.startswith("ext_user_prm_data") for line in tree.statements):
        length = None
    findings += _wrong_length(values, length)
    return GsdStation(
        source=source,
        ident_number=values.number("Ident_Number", 0),
        gsd_revision=values.number("GSD_Revision", 0, 0xFF),
        vendor=values.text("Vendor_Name"),
        model=values.text("Model_Name"),
        revision=values.text("Revision"),
        hardware_release=values.text("Hardware_Release"),
        software_release=values.text("Software_Release"),
        order_number=values.text("OrderNumber"),
        implementation=values.text("Implementation_Type"),
        is_master=values.flag("Station_Type"),
        rates=tuple(_rates(values)),
        auto_baud=values.flag("Auto_Baud_supp"),
        sync=values.flag("Sync_Mode_supp"),
        freeze=values.flag("Freeze_Mode_supp"),
        set_slave_address=values.flag("Set_Slave_Add_supp"),
        fail_safe=values.flag("Fail_Safe"),
        dpv1=values.flag("DPV1_Slave"),
        watchdog_base_1ms=values.flag("WD_Base_1ms_supp"),
        min_slave_interval_us=values.number("Min_Slave_Intervall", 0) * _INTERVAL_US,
        max_diagnosis_bytes=values.number("Max_Diag_Data_Len", 6, 0xFF),
        modular=values.flag("Modular_Station"),
        fixed_presets=values.flag("FixPresetModules"),
        module_offset=values.number("Modul_Offset", 0, 0xFF),
        limits=Limits(
            values.optional_number("Max_Module"),
            values.optional_number("Max_Input_Len"),
            values.optional_number("Max_Output_Len"),
            values.optional_number("Max_Data_Len"),
        ),
        parameters=preset_parameters(tree.statements, named, length, findings),
        modules=tuple(_modules(tree, named, findings)),
        slots=tuple(slot_definitions(tree, findings)),
        diagnosis=tuple(_diagnosis(tree)),
        unknown=tuple(_unknown(tree.statements)),
    )


def _rates(values: Values) -> Iterator[Rate]:
    for name in RATES:
        if values.flag(f"{name}_supp"):
            yield Rate(name, values.optional_number(f"MaxTsdr_{name}"))


def _modules(
    tree: Tree, named: Mapping[int, NamedParameter], findings: list[Diagnostic]
) -> Iterator[GsdModule]:
    for block in tree.blocks_of("Module"):
        head = block.head
        texts = [token for token in head.value if token.kind is Kind.TEXT]
        if not texts or head.value[0] is not texts[0]:
            findings.append(not_a("a name in quotes and the module's identifiers", head))
            continue
        code = octets_of(head.value[1:], head, findings)
        if code is None:
            continue
        if wrong := _wrong_identifiers(code, head):
            findings.append(wrong)
            continue
        values = Values(block.statements, findings)
        length = values.optional_number("Ext_Module_Prm_Data_Len", 0xFF)
        yield GsdModule(
            name=" ".join(texts[0].text.split()),
            code=code,
            span=head.span,
            reference=_reference(block),
            preset=values.flag("Preset"),
            info=values.text("Info_Text"),
            parameters=preset_parameters(block.statements, named, length, findings),
        )


def _reference(block: Block) -> int | None:
    """The number that stands alone in a line, or Module_Reference."""
    for line in block.statements:
        if not line.keyword:
            return number_of(line.value[0].text)
        if line.key == "module_reference":
            return next(iter(numbers_of(line.value)), None)
    return None


def _wrong_identifiers(code: bytes, head: Statement) -> Diagnostic | None:
    reason = ""
    if not code:
        reason = "a module has one configuration identifier at least"
    elif len(code) > _MOST_IDENTIFIERS:
        reason = f"{len(code)} bytes of identifiers: Chk_Cfg has {_MOST_IDENTIFIERS} at most"
    else:
        try:
            decode_identifiers(code)
        except IdentifierError as wrong:
            reason = str(wrong)
    if not reason:
        return None
    return Diagnostic(
        "FB1305",
        reason,
        head.value_span,
        "identifiers stand behind the module's name as bytes: 0x30,0x70",
    )


def _diagnosis(tree: Tree) -> Iterator[DiagnosisText]:
    for line in tree.statements:
        texts = [token.text for token in line.value if token.kind is Kind.TEXT]
        if line.key == "unit_diag_bit" and line.index and texts:
            yield DiagnosisText(line.index[0], line.index[0], None, texts[0].strip())
    for block in tree.blocks_of("Unit_Diag_Area"):
        numbers = numbers_of(block.head.value)
        for line in block.statements:
            texts = [token.text for token in line.value if token.kind is Kind.TEXT]
            if line.key == "value" and line.index and texts and numbers:
                yield DiagnosisText(numbers[0], numbers[-1], line.index[0], texts[0].strip())


def _unknown(statements: Iterable[Statement]) -> Iterator[Statement]:
    return (line for line in statements if line.keyword and line.key not in KEYWORDS)


def _unknown_keywords(tree: Tree) -> Iterator[Diagnostic]:
    """FB1308: a keyword that nobody knows and that is spelled nearly as a known one."""
    seen: dict[str, Statement] = {}
    for line in _unknown(_all_statements(tree.statements, tree.blocks)):
        if len(seen) < _ALIKE_SEARCHED:
            seen.setdefault(line.key, line)
    for key, line in seen.items():
        near = get_close_matches(key, KEYWORDS, n=1, cutoff=_ALIKE)
        if near:
            yield Diagnostic(
                "FB1308",
                f"the keyword {line.keyword} is not known",
                line.keyword_span,
                f"did you mean {KEYWORDS[near[0]]}? The line is not used",
                severity=Severity.WARNING,
            )


def _all_statements(
    statements: Iterable[Statement], blocks: Iterable[Block]
) -> Iterator[Statement]:
    yield from statements
    for block in blocks:
        if block.head.key in BLOCKS:
            yield from _all_statements(block.statements, block.blocks)


def _wrong_length(values: Values, length: int | None) -> Iterator[Diagnostic]:
    line = values.known.get("user_prm_data")
    if line is None or length is None:
        return
    found = sum(1 for token in line.value if token.kind is Kind.WORD)
    if found != length:
        yield Diagnostic(
            "FB1309",
            f"User_Prm_Data has {found} bytes, User_Prm_Data_Len says {length}",
            line.value_span,
            "a slave that gets another number of user parameters reports a parameter fault",
            severity=Severity.WARNING,
        )
