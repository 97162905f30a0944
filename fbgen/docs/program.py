"""The PLC text of a plant, read again as it is written, together with sources of the user's own."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from fbgen.dataclass import dataclass
from fbgen.emit.generated import CanonicalProgram, GeneratedFile, GeneratedSet
from fbgen.lang.checked import Program
from fbgen.lang.checker import check, rules_for
from fbgen.lang.collector import collector_at_rest
from fbgen.lang.containers import XML_SUFFIXES, read_document, read_text
from fbgen.plant import LANGUAGES, Plant


@dataclass(frozen=True, slots=True)
class PlantProgram:
    """The checked program of a plant: `generated` files by their names, and those of the user."""

    plant: Plant
    generated: GeneratedSet
    files: Mapping[str, GeneratedFile]
    program: Program

    @property
    def devices(self) -> frozenset[str]:
        """Its types of gateways, DeviceNet options among them, and series of inverters."""
        series = {drive.series for drive in self.plant.drives}
        return frozenset(series | self.plant.gateway_types)

    @property
    def canonical(self) -> CanonicalProgram:
        """The same before it got its dialect."""
        assert self.generated.canonical is not None, "generate() keeps it"
        return self.generated.canonical


def read_program(
    plant: Plant, generated: GeneratedSet, sources: Sequence[Path] = ()
) -> PlantProgram:
    """The written text, parsed and checked in its dialect, with the user's `sources`.

    A source with the name of a generated file is that file and not read again. Raises
    DiagnosticError for sources that cannot be read or are no correct PLC text.
    """
    dialect = LANGUAGES[generated.dialect]
    files = {file.name: file for file in generated.files if file.is_program}
    with collector_at_rest():
        trees = [
            read_text(file.source, dialect, Path(name).suffix.lower() in XML_SUFFIXES).file
            for name, file in files.items()
        ]
        trees += [read_document(path, dialect).file for path in sources if path.name not in files]
        rules = replace(rules_for(dialect), iec_check_open=False)
        program = check(trees, dialect, rules=rules)
    return PlantProgram(plant, generated, files, program)
