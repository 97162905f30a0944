"""Words that all dialects reserve: elementary types, statements, blocks.

Source: IEC 61131-3, table of keywords; TIA Portal help, "Reserved keywords".
"""


def words(text: str) -> frozenset[str]:
    """The words of a text, as a set."""
    return frozenset(text.split())


ELEMENTARY_TYPES = words(
    "BOOL BYTE WORD DWORD LWORD SINT INT DINT LINT USINT UINT UDINT ULINT REAL LREAL TIME LTIME "
    "DATE TIME_OF_DAY TOD LTIME_OF_DAY LTOD DATE_AND_TIME DT LDT CHAR WCHAR STRING WSTRING"
)

STATEMENTS = words(
    "IF THEN ELSIF ELSE END_IF CASE OF END_CASE FOR TO BY DO END_FOR WHILE END_WHILE REPEAT UNTIL "
    "END_REPEAT EXIT CONTINUE RETURN AND OR XOR NOT MOD TRUE FALSE"
)

DECLARATIONS = words(
    "FUNCTION END_FUNCTION FUNCTION_BLOCK END_FUNCTION_BLOCK TYPE END_TYPE STRUCT END_STRUCT ARRAY "
    "VAR VAR_INPUT VAR_OUTPUT VAR_IN_OUT VAR_TEMP END_VAR AT CONSTANT RETAIN NON_RETAIN"
)

COMMON = ELEMENTARY_TYPES | STATEMENTS | DECLARATIONS

STANDARD_NAMES = words(
    "ABS SQRT LN LOG EXP SIN COS TAN ASIN ACOS ATAN ADD MUL SUB DIV EXPT MOVE SHL SHR ROR ROL SEL "
    "MAX MIN LIMIT MUX GT GE EQ LE LT NE LEN LEFT RIGHT MID CONCAT INSERT DELETE REPLACE FIND "
    "SR RS R_TRIG F_TRIG CTU CTD CTUD TP TON TOF RTC SEMA"
)
"""Functions and function blocks that every controller has. What is generated calls nothing else so:
CODESYS takes its operators, and MATIEC all of these, for keywords.

Source: IEC 61131-3 second edition, tables 22 to 38; CODESYS help, "Keywords".
"""
