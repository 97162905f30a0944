"""Types, variables and values of PLCopen XML as text.

Source: PLCopen, schema of TC6 XML 2.01: dataType, value, varList.
"""

from fbgen.lang.containers.codesys_data import open_array_of
from fbgen.lang.containers.embedded import Assembly, content
from fbgen.lang.containers.xml_tree import Element

SECTIONS = {
    "inputVars": "VAR_INPUT",
    "outputVars": "VAR_OUTPUT",
    "inOutVars": "VAR_IN_OUT",
    "localVars": "VAR",
    "tempVars": "VAR_TEMP",
    "externalVars": "VAR_EXTERNAL",
    "globalVars": "VAR_GLOBAL",
    "accessVars": "VAR_ACCESS",
    "configVars": "VAR_CONFIG",
}
"""Elements with variables, and what such a section is called."""

QUALIFIERS = {
    "constant": "CONSTANT",
    "retain": "RETAIN",
    "nonretain": "NON_RETAIN",
    "persistent": "PERSISTENT",
}
"""Attributes of such an element, and the words for them."""


class DeclarationReader:
    """Adds the text of declarations to an assembly."""

    def __init__(self, text: Assembly) -> None:
        self._text = text

    def documentation(self, item: Element) -> None:
        """What is said about something, as a comment above it."""
        text = item.child("documentation")
        if text is None:
            return
        for part in text.children or [text]:
            words = content(part).strip().replace("(*", "( *").replace("*)", "* )")
            if words:
                self._text.add_at(f"(* {words} *)\n", part.inner_start)

    def sections(self, parent: Element) -> None:
        """All sections that an element has."""
        for item in parent.named(*SECTIONS):
            self.section(SECTIONS[item.tag], item)

    def section(self, keyword: str, item: Element) -> None:
        """One section."""
        words = [word for name, word in QUALIFIERS.items() if item.get(name) == "true"]
        head = " ".join((keyword, *words))
        self._text.add_at(head, item.start)
        self._text.add("\n")
        for variable in item.named("variable"):
            open_array = open_array_of(variable)
            if open_array is not None:
                self._text.add("END_VAR\n" + f"{open_array.keyword}\n")
            self._variable(variable)
            if open_array is not None:
                self._text.add("END_VAR\n" + f"{head}\n")
        self._text.add("END_VAR\n")

    def _variables(self, item: Element) -> None:
        for variable in item.named("variable"):
            self._variable(variable)

    def _variable(self, variable: Element) -> None:
        self.documentation(variable)
        self._text.add_attribute(variable, "name")
        if variable.get("address"):
            self._text.add(" AT ")
            self._text.add_attribute(variable, "address")
        self._text.add(" : ")
        open_array = open_array_of(variable)
        if open_array is not None:
            self._text.add_at(open_array.type, variable.start)
        else:
            self.type_of(variable.child("type"), variable)
        self.initial(variable)
        self._text.add(";\n")

    # --- types --------------------------------------------------------------------------------

    def type_of(self, wrapper: Element | None, owner: Element) -> None:
        """The type in a `type` or `baseType` element."""
        item = next(iter(wrapper.children), None) if wrapper is not None else None
        if item is None:
            self._text.add_at("?", owner.start)
            return
        kind = item.tag
        if kind == "derived":
            self._text.add_attribute(item, "name")
        elif kind in ("string", "wstring"):
            length = f"[{item.get('length')}]" if item.get("length") else ""
            self._text.add_at(f"{kind.upper()}{length}", item.start)
        elif kind == "array":
            self._array(item)
        elif kind == "struct":
            self._text.add_at("STRUCT\n", item.start)
            self._variables(item)
            self._text.add("END_STRUCT")
        elif kind == "enum":
            self._enumeration(item)
        elif kind in ("subrangeSigned", "subrangeUnsigned"):
            self.type_of(item.child("baseType"), item)
            self._text.add(" (")
            self._range(item.child("range"))
            self._text.add(")")
        elif kind == "pointer":
            self._text.add_at("POINTER TO ", item.start)
            self.type_of(item.child("baseType"), item)
        else:
            self._text.add_at(kind, item.start)

    def _array(self, item: Element) -> None:
        self._text.add_at("ARRAY[", item.start)
        for number, dimension in enumerate(item.named("dimension")):
            self._text.add(", " if number else "")
            self._range(dimension)
        self._text.add("] OF ")
        self.type_of(item.child("baseType"), item)

    def _range(self, item: Element | None) -> None:
        if item is not None:
            self._text.add_attribute(item, "lower")
            self._text.add("..")
            self._text.add_attribute(item, "upper")

    def _enumeration(self, item: Element) -> None:
        values = item.child("values")
        base = item.child("baseType")
        if base is not None:
            self.type_of(base, item)
            self._text.add(" ")
        self._text.add_at("(", item.start)
        for number, value in enumerate(values.named("value") if values else ()):
            self._text.add(", " if number else "")
            self._text.add_attribute(value, "name")
            if value.get("value"):
                self._text.add(" := ")
                self._text.add_attribute(value, "value")
        self._text.add(")")

    # --- values -------------------------------------------------------------------------------

    def initial(self, owner: Element) -> None:
        """` := value`, if there is one."""
        value = owner.child("initialValue")
        if value is not None and value.children:
            self._text.add(" := ")
            self._value(value)

    def _value(self, wrapper: Element) -> None:
        item = next(iter(wrapper.children), None)
        if item is None:
            return
        if item.tag == "simpleValue":
            self._text.add_attribute(item, "value")
            return
        is_array = item.tag == "arrayValue"
        self._text.add_at("[" if is_array else "(", item.start)
        for number, value in enumerate(item.named("value")):
            self._text.add(", " if number else "")
            if not is_array:
                self._text.add_attribute(value, "member")
                self._text.add(" := ")
            repeated = is_array and value.get("repetitionValue") not in ("", "1")
            if repeated:
                self._text.add_attribute(value, "repetitionValue")
                self._text.add("(")
            self._value(value)
            self._text.add(")" if repeated else "")
        self._text.add("]" if is_array else ")")
