"""The reference evaluator: walks the checked program and so defines what it means.

It is written to be read and to be right, not to be fast. It shares no arithmetic and no standard
library with the compiler, so that comparing the two proves something.
"""

from harness.engine.reference.engine import ReferenceEngine, ReferenceInstance

__all__ = ["ReferenceEngine", "ReferenceInstance"]
