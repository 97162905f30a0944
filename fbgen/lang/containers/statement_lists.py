"""Sources of Siemens' blocks whose bodies are instruction lists (STL, AWL).

Declarations, types and data blocks have the spelling that they have in SCL; behind BEGIN stand
networks with the list. Such a body is known to be there, and no more.
Source: STEP 7 V5, "Programming with STEP 7", "Creating STL source files"; published `.awl` sources.
"""

import re

from fbgen.lang.containers.embedded import Assembly
from fbgen.lang.containers.s7dcl import Declared
from fbgen.lang.other_languages import foreign_body, other_language
from fbgen.source import Source, Span

_BODY = re.compile(
    r"""^[ \t]*BEGIN\b[^\r\n]*\r?\n(?P<list>(?:[ \t]*(?://[^\r\n]*)?\r?\n)*
        [ \t]*(?P<network>NETWORK)[ \t]*(?:(?:TITLE[ \t]*=|//)[^\r\n]*)?\r?$.*?)
        ^[ \t]*END_(?:FUNCTION|FUNCTION_BLOCK|ORGANIZATION_BLOCK)\b""",
    re.DOTALL | re.MULTILINE | re.VERBOSE | re.IGNORECASE,
)
_NAME = re.compile(
    r"""^[ \t]*(?:FUNCTION|FUNCTION_BLOCK|ORGANIZATION_BLOCK)[ \t]+
        (?P<name>"[^"\r\n]*"|\w+(?:[ \t]+\d+)?)""",
    re.MULTILINE | re.VERBOSE | re.IGNORECASE,
)


def read_lists(text: Source) -> Declared | None:
    """The source without its instruction lists; None if it has none."""
    bodies = list(_BODY.finditer(text.text))
    if not bodies:
        return None
    assembly = Assembly(text)
    findings = []
    done = 0
    for body in bodies:
        place = Span(text, body.start("network"), body.end("network"))
        names = [one["name"] for one in _NAME.finditer(text.text, done, body.start())]
        findings.append(other_language(names[-1].strip('"') if names else "a block", "STL", place))
        assembly.add(text.text[done : body.start("list")], done)
        assembly.add_at(foreign_body("STL"), place.start)
        assembly.add_at("\n" * body["list"].count("\n"), place.start)
        done = body.end("list")
    assembly.add(text.text[done:], done)
    return Declared(assembly.source(), tuple(findings))
