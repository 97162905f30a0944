"""Texts and numbers with a format, and texts as arrays of characters.

Source: TIA Portal help, "String + Char" (S_MOVE, S_CONV, STRG_VAL, VAL_STRG, Strg_TO_Chars,
Chars_TO_Strg, ATH, HTA).
"""

TEXTS = {
    "STRG_VAL": "(IN STRING|WSTRING, FORMAT WORD, P UINT, OUT => ANY_NUM)",
    "VAL_STRG": "(IN ANY_NUM, SIZE USINT, PREC USINT, FORMAT WORD, P UINT, OUT <> STRING|WSTRING)",
    "STRG_TO_CHARS": "(STRG STRING|WSTRING, PCHARS DINT, CNT => UINT, CHARS <> ANY)",
    "CHARS_TO_STRG": "(CHARS ANY, PCHARS DINT, CNT UINT, STRG => STRING|WSTRING)",
    "ATH": "WORD(IN ANY, N INT, OUT <> ANY)",
    "HTA": "WORD(IN ANY, N UINT, OUT <> ANY)",
}
