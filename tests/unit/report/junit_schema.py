"""What junit-10.xsd of Jenkins' xUnit plugin allows, written down from it by hand.

Source: jenkinsci/xunit-plugin, src/main/resources/.../types/model/xsd/junit-10.xsd.
"""

import re
from xml.etree.ElementTree import Element

_RESULT = {"type", "message"}
_CHILDREN = {
    "testsuites": {"testsuite"},
    "testsuite": {"testsuite", "properties", "testcase", "system-out", "system-err"},
    "properties": {"property"},
    "testcase": {"skipped", "error", "failure", "system-out", "system-err"},
}
_REQUIRED = {
    "testsuite": {"name", "tests", "failures", "errors"},
    "property": {"name", "value"},
    "testcase": {"name"},
}
_OPTIONAL = {
    "testsuites": {"name", "time", "tests", "failures", "errors"},
    "testsuite": {
        *("group", "time", "skipped", "timestamp", "hostname", "id", "package"),
        *("file", "log", "url"),
    },
    "testcase": {"time", "classname", "group"},
    "error": _RESULT,
    "failure": _RESULT,
    "skipped": _RESULT,
}
_TIME = re.compile(r"(([0-9]{0,3},)*[0-9]{3}|[0-9]{0,3})*(\.[0-9]*)?")


def against_the_schema(element: Element) -> list[str]:
    """Everything that the schema does not allow, in words."""
    name = element.tag
    required, given = _REQUIRED.get(name, set()), set(element.keys())
    wrong = [f"{name} lacks {item}" for item in sorted(required - given)]
    unknown = given - required - _OPTIONAL.get(name, set())
    wrong += [f"{name} has {item}" for item in sorted(unknown)]
    if name in {"testsuites", "testsuite"} and not _TIME.fullmatch(element.get("time", "")):
        wrong.append(f"{name} has the time {element.get('time')}")
    for child in element:
        if child.tag not in _CHILDREN.get(name, set()):
            wrong.append(f"{name} holds {child.tag}")
        wrong += against_the_schema(child)
    return wrong
