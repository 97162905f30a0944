"""The examples below the help of each command."""


def examples(*lines: str) -> str:
    """An epilog that keeps its lines as they are."""
    return "\b\nExamples:\n" + "\n".join(f"  {line}" for line in lines)
