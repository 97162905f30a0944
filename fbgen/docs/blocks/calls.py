"""An example call of each block in every dialect, made by the same conversion as the blocks."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace

from fbgen.diagnostics import DiagnosticError
from fbgen.docs.blocks.reading import BlockText, Parameter, read_block
from fbgen.docs.program import PlantProgram
from fbgen.lang import ast
from fbgen.lang.conversion import convert, with_copies
from fbgen.lang.parser import parse
from fbgen.lang.printer import print_file
from fbgen.source import Source

DIALECTS = {
    "tia": "TIA Portal (SCL)",
    "step7": "STEP 7 V5 (SCL)",
    "iec": "IEC 61131-3 (Structured Text)",
    "twincat": "TwinCAT, CODESYS",
}
_PREFIX = "FbgenExample"


def example_calls(program: PlantProgram) -> Mapping[str, tuple[tuple[str, str], ...]]:
    """Block -> dialect's title and text, for the function blocks and functions of a plant.

    A dialect that cannot say the names or types of the plant has no examples.
    """
    units = [
        replace(
            file,
            units=tuple(
                replace(unit, body=()) if isinstance(unit, ast.Block) else unit
                for unit in file.units
            ),
        )
        for file in program.canonical.units
    ]
    blocks = list(callable_blocks(program.canonical.units))
    names = [block.name.name for block in blocks]
    text = "\n".join(
        _example(f"{_PREFIX}{number}", block, read_block(block))
        for number, block in enumerate(blocks)
    )
    example = parse(Source("examples.scl", text), "tia")
    found: dict[str, list[tuple[str, str]]] = {name: [] for name in names}
    for dialect, title in DIALECTS.items():
        files: Sequence[ast.File] = [*units, example]
        try:
            converted = convert(with_copies(files) if dialect == "step7" else files, dialect)
        except DiagnosticError:
            continue
        for number, lines in _printed(converted):
            found[names[number]].append((title, lines))
    return {name: tuple(rows) for name, rows in found.items()}


def callable_blocks(files: Iterable[ast.File]) -> Iterator[ast.Block]:
    """Blocks that somebody calls: no error organisation blocks, no programs."""
    kinds = (ast.BlockKind.FUNCTION_BLOCK, ast.BlockKind.FUNCTION)
    for file in files:
        for unit in file.units:
            if isinstance(unit, ast.Block) and unit.kind in kinds:
                yield unit


def _example(own: str, block: ast.Block, text: BlockText) -> str:
    """A block that calls this one with variables of the same names."""
    rows = [f"      {one.name} : {_type(block, one)};" for one in text.parameters]
    name = block.name.name
    given = [_given(one) for one in text.parameters]
    if block.kind is ast.BlockKind.FUNCTION_BLOCK:
        rows.insert(0, f'      inst{_short(name)} : "{name}";')
        call = f"#inst{_short(name)}({', '.join(given)})"
    else:
        kind = block.return_type.span.text if block.return_type is not None else "Void"
        call = f'"{name}"({", ".join(given)})'
        if kind.upper() != "VOID":
            rows.append(f"      result : {kind};")
            call = f"#result := {call}"
    lines = [f'FUNCTION_BLOCK "{own}"', "   VAR", *rows, "   END_VAR", "BEGIN"]
    return "\n".join([*lines, f"   {call};", "END_FUNCTION_BLOCK", ""])


def _given(parameter: Parameter) -> str:
    sign = "=>" if parameter.direction == "out" else ":="
    return f"{parameter.name} {sign} #{parameter.name}"


def _short(name: str) -> str:
    return name.partition("_")[2] or name


def _type(block: ast.Block, parameter: Parameter) -> str:
    """The type as declared, quotes included."""
    for section in block.sections:
        for declaration in section.declarations:
            if any(name.name == parameter.name for name in declaration.names):
                attributes = declaration.type_attributes
                return f"{attributes} {declaration.type.span.text}".strip()
    raise AssertionError(parameter.name)


def _printed(files: Iterable[ast.File]) -> Iterator[tuple[int, str]]:
    """The statements alone: declarations are the same everywhere."""
    for file in files:
        for unit in file.units:
            if isinstance(unit, ast.Block) and unit.name.name.startswith(_PREFIX):
                whole = print_file(ast.File(file.source, file.dialect, (unit,), ())).text
                yield int(unit.name.name.removeprefix(_PREFIX)), _statements(whole)


def _statements(text: str) -> str:
    lines = text.rstrip().split("\n")
    begin = max(n for n, line in enumerate(lines) if line.strip() in ("END_VAR", "BEGIN")) + 1
    body = [line for line in lines[begin:] if line.strip() and not line.startswith("END_")]
    margin = min(len(line) - len(line.lstrip()) for line in body)
    return "\n".join(line[margin:] for line in body)
