"""What is allowed and likely a mistake: the warnings that need the paths through a program.

`analyse` follows all paths through each block (`flow`), which tells what is set, read and called
where; `effects` says what one expression does. Each other module is one kind of finding. Errors
belong to the checker; here everything is a warning or a hint that a comment may allow (`allow`).
"""

from fbgen.lang.analysis.allow import without_allowed
from fbgen.lang.analysis.program import analyse

__all__ = ["analyse", "without_allowed"]
