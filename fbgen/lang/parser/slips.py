"""What somebody meant who wrote the PLC language like another one: `==`, `&&`, `x++`, `ELSEIF`.

The places are found as any other mistake is; here stands only which help fits better than the
general one.
"""

WORDS = {
    "ELSEIF": "ELSIF",
    "ELIF": "ELSIF",
    "ENDIF": "END_IF",
    "ENDCASE": "END_CASE",
    "ENDFOR": "END_FOR",
    "ENDWHILE": "END_WHILE",
    "ENDREPEAT": "END_REPEAT",
}
"""Words that other languages have for a keyword."""
_ENDS = frozenset({"IF", "CASE", "FOR", "WHILE", "REPEAT"})
_PAIRS = {
    ("=", "="): "one '=' compares",
    (":", "="): "write := without a blank in it",
    ("=", "<"): "write <=",
    ("=", ">"): "write >=",
    (">", "<"): "write <> for not equal",
    ("&", "&"): "one & is enough, or write AND",
}
_CHARACTERS = {
    "!": "write NOT, and <> for not equal",
    "|": "write OR",
    "~": "write NOT",
}


def help_for_slip(before: str, found: str, behind: str, expected: str) -> str:
    """The help for the token `found`, from what stands around it; empty if nothing is known."""
    if pair := _PAIRS.get((before, found)):
        return pair
    if character := _CHARACTERS.get(found[:1]):
        return character
    if word := WORDS.get(before.upper()):
        return f"write {word}"
    if before.upper() == "END" and found.upper() in _ENDS:
        return f"write END_{found.upper()}"
    if found in ("+", "-") and found == behind:
        return f"write x := x {found} 1;"
    if found == "=>" and "operator" in expected:
        return "write >="
    if found == "=" and expected == "';'":
        return "an initial value is given by ':='"
    if found == "," and before[-1:].isdigit() and behind[:1].isdigit():
        return "the decimal sign is a point: 1.5"
    if found.upper() == "STEP" and "BY" in expected:
        return "the step is given by BY"
    if before.upper() == "RETURN":
        return "RETURN gives nothing back: assign the result to the name of the function"
    if before.endswith("'") and found.isidentifier():
        return "an apostrophe in a text is written $'"
    return ""
