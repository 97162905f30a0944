"""A file that does two things is two files, and no two modules of tests are called the same."""

from collections import Counter

from tests.architecture.sources import ROOT, files

LONGEST = 500


def test_no_module_is_longer_than_500_lines() -> None:
    lengths = {
        path.relative_to(ROOT).as_posix(): path.read_text(encoding="utf-8").count("\n")
        for path in files(".py")
    }
    assert {name: length for name, length in lengths.items() if length > LONGEST} == {}


def test_no_two_modules_of_tests_have_one_name() -> None:
    """Pytest imports a module by its name alone where its folder is no package."""
    names = Counter(
        path.name
        for path in files(".py")
        if path.name.startswith("test_") and not (path.parent / "__init__.py").exists()
    )
    assert [name for name, count in names.items() if count > 1] == []
