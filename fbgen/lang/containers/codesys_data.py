"""What CODESYS adds to PLCopen XML, and where it puts what the standard has another place for.

Blocks, types and interfaces stand in the `addData` of the application or of the project, each in a
`data` of its own, lists of global variables directly in the application. Methods, properties, bases
and access modifiers are data of their block. A list with several sections stands there twice: once
whole, and once in sections with their qualifiers, which is the one that counts.
Source: exports of CODESYS 3.5 and TwinCAT 3 in published projects: `pou`, `datatype`, `interface`,
`globalvars`, `mixedattrsvarlist`, `interfaceasplaintext`, `method`, `property`, `pouinheritance`,
`datatypeinheritance`, `accessmodifiers`, `attributes`.
"""

from collections.abc import Iterator, Mapping

from fbgen.dataclass import dataclass
from fbgen.lang.containers.embedded import content
from fbgen.lang.containers.xml_tree import Element

_MODIFIERS = ("Public", "Private", "Protected", "Internal", "Abstract", "Final")


@dataclass(frozen=True, slots=True)
class ProjectParts:
    """Everything with code in a project, in the order of the file."""

    types: tuple[Element, ...]
    globals: tuple[Element, ...]
    interfaces: tuple[Element, ...]
    pous: tuple[Element, ...]
    configurations: tuple[Element, ...]


def project_parts(root: Element) -> ProjectParts:
    """The parts of a project, wherever they stand."""
    types, instances = root.child("types"), root.child("instances")
    configurations: tuple[Element, ...] = ()
    if instances is not None:
        configurations = tuple(children(instances, "configurations", "configuration"))
    resources = [one for configuration in configurations for one in configuration.named("resource")]
    holders = (*resources, *configurations, root)
    standard: dict[str, Iterator[Element]] = {
        "dataType": iter(()) if types is None else children(types, "dataTypes", "dataType"),
        "pou": iter(()) if types is None else children(types, "pous", "pou"),
    }

    def everywhere(tag: str) -> Iterator[Element]:
        yield from standard.get(tag, ())
        for holder in holders:
            yield from added(holder, tag)

    lists = (one for resource in resources for one in resource.named("globalVars") if _is_list(one))
    return ProjectParts(
        types=tuple(everywhere("dataType")),
        globals=(*lists, *everywhere("globalVars")),
        interfaces=tuple(everywhere("Interface")),
        pous=tuple(everywhere("pou")),
        configurations=configurations,
    )


def _is_list(item: Element) -> bool:
    """True for a list of CODESYS: what the standard has in a resource belongs to its text."""
    return "3s-software.com" in item.source.text and bool(item.get("name"))


def children(parent: Element, group: str, tag: str) -> Iterator[Element]:
    """The elements with one name in elements with another."""
    for one in parent.named(group):
        yield from one.named(tag)


def added(element: Element, *tags: str) -> Iterator[Element]:
    """What vendors add to an element."""
    for data in children(element, "addData", "data"):
        yield from data.named(*tags)


def _added_to_head(item: Element, tag: str) -> Iterator[Element]:
    """What is added to the interface of a block or method, or to itself."""
    interface = item.child("interface")
    if interface is not None:
        yield from added(interface, tag)
    yield from added(item, tag)


def sections_of_list(item: Element) -> list[Element]:
    """The sections of a list of global variables."""
    sections = [one for mixed in added(item, "MixedAttrsVarList") for one in mixed.children]
    return [one for one in sections if one.tag == "globalVars"] or [item]


def members_of_interface(item: Element) -> Iterator[Element]:
    """The methods and properties that an interface promises."""
    yield from children(item, "Methods", "Method")
    yield from children(item, "Properties", "Property")
    yield from item.named("Method", "Property")
    yield from added(item, "Method", "Property")


def plain_text(item: Element) -> Element | None:
    """A declaration as CODESYS adds it in its own words."""
    for plain in (*_added_to_head(item, "InterfaceAsPlainText"), *_direct_plain_text(item)):
        return next(iter(plain.children), plain)
    return None


def _direct_plain_text(item: Element) -> Iterator[Element]:
    yield from item.named("InterfaceAsPlainText")
    interface = item.child("interface")
    if interface is not None:
        yield from interface.named("InterfaceAsPlainText")


def modifiers(item: Element) -> tuple[str, ...]:
    """ABSTRACT, PRIVATE and the like of a block or member."""
    return tuple(
        word.upper()
        for one in _added_to_head(item, "AccessModifiers")
        for word in _MODIFIERS
        if one.get(word).casefold() == "true"
    )


def bases(item: Element) -> Mapping[str, list[str]]:
    """EXTENDS and IMPLEMENTS with the names behind them."""
    found: dict[str, list[str]] = {}
    for inheritance in _added_to_head(item, "Inheritance"):
        for one in inheritance.named("Extends", "Implements"):
            found.setdefault(one.tag.upper(), []).append(content(one).strip())
    return found


@dataclass(frozen=True, slots=True)
class OpenArray:
    """An ARRAY[*], which CODESYS exports as a pointer: its type, and the section it stood in."""

    type: str
    keyword: str


def open_array_of(variable: Element) -> OpenArray | None:
    """What a variable was before it was exported; None for all but ARRAY[*]."""
    values = {
        one.get("Name"): one.get("Value")
        for group in added(variable, "Attributes")
        for one in group.named("Attribute")
    }
    if "variable_length_array" not in values:
        return None
    scope = values.get("variable_length_array_original_scope", "").casefold()
    return OpenArray(
        values["variable_length_array"], "VAR_INPUT" if scope == "input" else "VAR_IN_OUT"
    )


def attributes(item: Element) -> Iterator[str]:
    """Pragmas such as {attribute 'qualified_only'}."""
    for group in _added_to_head(item, "Attributes"):
        for one in group.named("Attribute"):
            value = f" := '{one.get('Value')}'" if one.get("Value") else ""
            yield f"{{attribute '{one.get('Name')}'{value}}}"
