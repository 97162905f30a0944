"""pytest and mypy at the same time: `python tools/checks.py -n 2`; the options are pytest's.

mypy keeps one processor busy for half a minute, so it does not make the tests wait. What it says
comes behind what pytest says. The exit status is that of the tests, or else that of mypy.
"""

import subprocess
import sys


def main(options: list[str]) -> int:
    """Run both; the exit status."""
    mypy = [sys.executable, "-m", "mypy"]
    pytest = [sys.executable, "-m", "pytest", *options]
    with subprocess.Popen(mypy, stdout=subprocess.PIPE, stderr=subprocess.STDOUT) as types:
        try:
            tests = subprocess.run(pytest, check=False)
            said, _ = types.communicate()
        except KeyboardInterrupt:
            types.kill()
            return 130
    sys.stdout.write("== mypy\n" + said.decode(errors="replace"))
    return tests.returncode or types.returncode


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
