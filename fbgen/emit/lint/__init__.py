"""Import rules of the PLC's own tools, checked on the text as it is written to disk.

Nobody has imported the output into a real TIA Portal or STEP 7 yet, so what is known of their
rules stands here and is checked every time something is generated.
"""

from collections.abc import Callable, Iterator

from fbgen.diagnostics import Diagnostic
from fbgen.emit.lint import cpu_rules, iec_rules, plain_text, tia_rules
from fbgen.emit.lint.emitted import EmittedText
from fbgen.lang.parser import parse_recovering
from fbgen.lang.walk import walk
from fbgen.plant.families import PlcFamily
from fbgen.source import Source

Rule = Callable[[EmittedText], Iterator[Diagnostic]]

_RULES: dict[str, tuple[Rule, ...]] = {
    "tia": (*plain_text.RULES, *tia_rules.RULES, *cpu_rules.RULES),
    "iec": (*plain_text.RULES, *iec_rules.RULES),
}


def lint(name: str, text: str, dialect: str, plc: PlcFamily) -> list[Diagnostic]:
    """Everything in a generated text that its tools or the CPU would refuse or take wrongly."""
    source = Source(name, text)
    file, findings = parse_recovering(source, dialect)
    emitted = EmittedText(source, file, tuple(walk(file)), plc)
    return findings + [found for rule in _RULES[dialect] for found in rule(emitted)]
