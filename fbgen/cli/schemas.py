"""`fbgen schemas`: JSON Schemas for editors, one for each kind of YAML file."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from fbgen.cli.examples import examples
from fbgen.cli.output import result

if TYPE_CHECKING:
    from pydantic import BaseModel


def register(program: typer.Typer) -> None:
    """Add the command to the program."""
    program.command(
        epilog=examples(
            "fbgen schemas schemas",
            "",
            "A first line in a YAML file tells editors where its schema is:",
            "# yaml-language-server: $schema=schemas/plant.schema.json",
        )
    )(schemas)


def schemas(
    folder: Annotated[Path, typer.Argument(metavar="DIR", help="Where the schemas go.")],
) -> None:
    """Write the JSON Schemas of all YAML files, for editors, and of the report of check."""
    from fbgen.cli.files import write_file

    for name, schema in schema_texts().items():
        write_file(folder / name, schema, overwrite=True)
        result(str(folder / name))


def schema_texts() -> dict[str, str]:
    """The schemas by file name, each generated from the model that reads such a file."""
    from fbgen.catalog import Drive, Manual, Sequence
    from fbgen.catalog.file_models import GatewayFile, ProtocolFile
    from fbgen.catalog.schema import schema_text
    from fbgen.cli.reports.check_report import CheckReport
    from fbgen.plant import Plant
    from harness.scenario.model import Scenario
    from harness.trace.lines import TraceFileLine

    models: dict[str, type[BaseModel]] = {
        "catalog-drive": Drive,
        "catalog-gateway": GatewayFile,
        "catalog-manual": Manual,
        "catalog-protocol": ProtocolFile,
        "catalog-sequence": Sequence,
        "check-report": CheckReport,
        "plant": Plant,
        "scenario": Scenario,
        "trace": TraceFileLine,
    }
    return {f"{name}.schema.json": schema_text(model) for name, model in models.items()}
