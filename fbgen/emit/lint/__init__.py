"""Import rules of the PLC's own tools, checked on the text as it is written to disk.

Nobody has imported the output into a real TIA Portal or STEP 7 yet, so what is known of their
rules stands here and is checked every time something is generated.
"""

from collections.abc import Callable, Iterator
from pathlib import Path

from fbgen.diagnostics import Diagnostic
from fbgen.emit.lint import cpu_rules, iec_rules, plain_text, step7_rules, tia_rules, twincat_rules
from fbgen.emit.lint.emitted import EmittedText
from fbgen.lang.containers import XML_SUFFIXES, read_text
from fbgen.lang.walk import by_kind
from fbgen.plant import LANGUAGES, PlcFamily
from fbgen.source import Source

Rule = Callable[[EmittedText], Iterator[Diagnostic]]

_RULES: dict[str, tuple[Rule, ...]] = {
    "tia": (*plain_text.RULES, *tia_rules.RULES, *cpu_rules.RULES),
    "step7": (*plain_text.RULES, *step7_rules.RULES, tia_rules.no_block_of_the_user),
    "iec": (*plain_text.RULES, *iec_rules.RULES),
    "twincat": (
        *plain_text.RULES,
        *twincat_rules.RULES,
        iec_rules.plain_names,
        iec_rules.addresses_only_declared,
        tia_rules.no_block_of_the_user,
    ),
    "plcopen": (*plain_text.RULES, *iec_rules.RULES),
}


def lint(source: Source, dialect: str, plc: PlcFamily) -> list[Diagnostic]:
    """Everything in a generated text that its tools or the CPU would refuse or take wrongly."""
    is_xml = Path(source.name).suffix.lower() in XML_SUFFIXES
    document = read_text(source, LANGUAGES[dialect], is_xml)
    emitted = EmittedText(source, document.file, by_kind(document.file), plc)
    return [*document.findings] + [found for rule in _RULES[dialect] for found in rule(emitted)]
