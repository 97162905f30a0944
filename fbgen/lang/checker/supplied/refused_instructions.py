"""Instructions of TIA Portal that are refused by name, and what to do instead.

Source: TIA Portal help, the pages of the instructions.
"""

_OF_NAMES = "hand over what it gives as an input"
_OF_SYMBOLS = "access the variables by their names"
_OF_ARRAYS = 'use the elements of the block: "Block".THIS[i]'

NOT_SUPPORTED: dict[str, str] = {
    **dict.fromkeys(
        (
            *("VARIANT_TO_DB_ANY", "DB_ANY_TO_VARIANT", "GETSYMBOLNAME", "GETSYMBOLPATH"),
            *("GETSYMBOLFORREFERENCE", "GETINSTANCENAME", "GETINSTANCEPATH", "GETBLOCKNAME"),
        ),
        _OF_NAMES,
    ),
    **dict.fromkeys(
        (
            *("RESOLVESYMBOLS", "MOVEFROMRESOLVEDSYMBOL", "MOVETORESOLVEDSYMBOL"),
            *("MOVERESOLVEDSYMBOLSTOBUFFER", "MOVERESOLVEDSYMBOLSFROMBUFFER"),
        ),
        _OF_SYMBOLS,
    ),
    **dict.fromkeys(
        ("READFROMARRAYDB", "WRITETOARRAYDB", "READFROMARRAYDBL", "WRITETOARRAYDBL"), _OF_ARRAYS
    ),
    "TYPEOFDB": "ask a VARIANT by TypeOf",
    **dict.fromkeys(("JOIN", "SPLIT"), "take the texts apart with FIND, LEFT and MID"),
}
"""By upper-case name: those for the names and numbers of what a program is made of, for ARRAY data
blocks, for lists of texts."""

WRITTEN_OTHERWISE: dict[str, str] = {
    "CONVERT": "write both types: INT_TO_REAL(x)",
    "S_COMP": "compare: text1 = text2",
    "T_COMP": "compare: time1 >= time2",
}
"""What the editor offers under a name that no text has, and what it writes."""
