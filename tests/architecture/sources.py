"""The source files of the project and what they import."""

import ast
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path

ROOT = Path(__file__).parents[2]
PACKAGES = ("fbgen", "harness")
IGNORED = {".venv", ".git", "__pycache__", ".mypy_cache", ".ruff_cache", ".pytest_cache"}
IGNORED |= {".hypothesis", "build", "dist", "out", "node_modules"}


@dataclass(frozen=True, slots=True)
class Import:
    """`importer` imports `imported`; `lazily` if inside a function or for type checkers only."""

    importer: str
    imported: str
    line: int
    lazily: bool


@cache
def modules() -> dict[str, Path]:
    """Dotted name -> file, of both packages."""
    return {
        ".".join(path.relative_to(ROOT).with_suffix("").parts).removesuffix(".__init__"): path
        for package in PACKAGES
        for path in sorted((ROOT / package).rglob("*.py"))
    }


@cache
def tree(path: Path) -> ast.Module:
    """The syntax tree of a file."""
    return ast.parse(path.read_text(encoding="utf-8"), str(path))


@cache
def imports() -> tuple[Import, ...]:
    """Every import of a module of ours by a module of ours."""
    return tuple(
        found
        for name, path in modules().items()
        for found in _imports_in(name, tree(path), lazily=False)
        if found.imported.split(".")[0] in PACKAGES
    )


def _imports_in(name: str, node: ast.AST, *, lazily: bool) -> Iterator[Import]:
    for child in ast.iter_child_nodes(node):
        if isinstance(child, ast.Import):
            for alias in child.names:
                yield Import(name, alias.name, child.lineno, lazily)
        elif isinstance(child, ast.ImportFrom):
            source = child.module or ""
            for alias in child.names:
                full = f"{source}.{alias.name}"
                imported = full if full in modules() else source
                yield Import(name, imported, child.lineno, lazily)
        else:
            later = isinstance(child, (ast.FunctionDef, ast.AsyncFunctionDef)) or (
                isinstance(child, ast.If) and ast.unparse(child.test) == "TYPE_CHECKING"
            )
            yield from _imports_in(name, child, lazily=lazily or later)


def files(*suffixes: str) -> Iterator[Path]:
    """Every file of the checkout that a person wrote, with one of the suffixes."""
    for folder in sorted(ROOT.iterdir()):
        if folder.name in IGNORED:
            continue
        candidates = [folder] if folder.is_file() else sorted(folder.rglob("*"))
        for path in candidates:
            inside = set(path.relative_to(ROOT).parts)
            if path.suffix in suffixes and path.is_file() and not IGNORED & inside:
                yield path
