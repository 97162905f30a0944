"""The fast engine: every block of a checked program becomes Python source, which is executed.

A function block is a class with slots and one method, a FUNCTION a function, a structure a class,
an array a list. The source keeps the names of the PLC text and can be read:
`CompiledEngine.python_source`. What it means is defined by `harness.engine.reference`, with which
it shares its face, the faults and the layout of memory, and nothing that calculates.
"""

from harness.engine.compiled.engine import CompiledEngine
from harness.engine.compiled.outside.instance import CompiledInstance
from harness.engine.compiled.watching.probes import Moment, Probe, ProbeMaker, writers_probe

__all__ = ["CompiledEngine", "CompiledInstance", "Moment", "Probe", "ProbeMaker", "writers_probe"]
