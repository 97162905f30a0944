"""A file that does two things is two files."""

from tests.architecture.sources import files

LONGEST = 500


def test_no_module_is_longer_than_500_lines() -> None:
    lengths = {path: path.read_text(encoding="utf-8").count("\n") for path in files(".py")}
    assert {str(path): length for path, length in lengths.items() if length > LONGEST} == {}
