"""A file that does two things is two files."""

from tests.architecture.sources import ROOT, files

LONGEST = 500


def test_no_module_is_longer_than_500_lines() -> None:
    lengths = {
        path.relative_to(ROOT).as_posix(): path.read_text(encoding="utf-8").count("\n")
        for path in files(".py")
    }
    assert {name: length for name, length in lengths.items() if length > LONGEST} == {}
