"""The checker gives a program or diagnostics on anything that the parser reads, never more."""

from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from fbgen.lang.checker import check_reporting
from fbgen.lang.parser import parse_recovering
from fbgen.source import Source

_NAMES = st.sampled_from(["a", "b", "i", "r", "w", "t", "arr", "rec", "inst", "f", "K", "nope"])
_LITERALS = st.sampled_from(
    ["0", "1", "-1", "16#FF", "70000", "1.5", "TRUE", "'x'", "T#5s", "WORD#16#1", "TOD#1:2:3"]
)
_TYPES = st.sampled_from(
    [
        *("BOOL", "BYTE", "WORD", "INT", "UINT", "DINT", "LINT", "REAL", "LREAL", "TIME", "TOD"),
        *("STRING[4]", "CHAR", "TON", "Rec", "Fb", "ARRAY[0..3] OF INT", "ARRAY[0..K] OF Rec"),
        *("ARRAY[1..2, 0..1] OF REAL", "Nope", "F"),
    ]
)
_OPERATORS = st.sampled_from(
    ["+", "-", "*", "/", "MOD", "**", "AND", "OR", "XOR", "=", "<>", "<", ">", "<=", ">="]
)
_FUNCTIONS = st.sampled_from(
    [
        *("ABS", "SQRT", "SHL", "ROR", "MAX", "LIMIT", "SEL", "MUX", "LEN", "CONCAT", "TRUNC"),
        *("INT_TO_REAL", "REAL_TO_INT", "WORD_TO_BOOL", "TO_INT", "INT_TO_STRING", "F", "Fb"),
        *("inst", "ROUND_SINT", "ADD", "GT", "NOT_THERE", "MOVE", "TIME_TO_DINT"),
    ]
)
_places = st.recursive(
    _NAMES,
    lambda inner: st.one_of(
        st.builds("{}.{}".format, inner, st.sampled_from(["x", "n", "Q", "inner", "nope"])),
        st.builds("{}[{}]".format, inner, st.one_of(_LITERALS, _NAMES)),
    ),
    max_leaves=3,
)
_expressions = st.recursive(
    st.one_of(_LITERALS, _places),
    lambda inner: st.one_of(
        st.builds("({} {} {})".format, inner, _OPERATORS, inner),
        st.builds("NOT {}".format, inner),
        st.builds("(-{})".format, inner),
        st.builds("{}({})".format, _FUNCTIONS, inner),
        st.builds("{}({}, {})".format, _FUNCTIONS, inner, inner),
        st.builds("{}(IN := {}, N := {})".format, _FUNCTIONS, inner, inner),
    ),
    max_leaves=8,
)
_statements = st.recursive(
    st.one_of(
        st.builds("{} := {};".format, _places, _expressions),
        st.builds("{}(IN := {}, Q => {});".format, _places, _expressions, _places),
        st.sampled_from(["EXIT;", "RETURN;", ";"]),
    ),
    lambda inner: st.one_of(
        st.builds("IF {} THEN {} ELSE {} END_IF;".format, _expressions, inner, inner),
        st.builds(
            "FOR {} := {} TO {} DO {} END_FOR;".format, _places, _expressions, _expressions, inner
        ),
        st.builds(
            "CASE {} OF {}: {} {}..9: {} END_CASE;".format,
            _expressions,
            _LITERALS,
            inner,
            _LITERALS,
            inner,
        ),
    ),
    max_leaves=4,
)
_declarations = st.lists(
    st.builds(
        "{} : {}{};".format,
        _NAMES,
        _TYPES,
        st.one_of(
            st.just(""),
            st.builds(" := {}".format, _expressions),
            st.sampled_from([" := [1, 2(3)]", " := (x := 5)", " := [2((x := 1))]"]),
        ),
    ),
    max_size=8,
).map(" ".join)

_REST = """
TYPE Rec : STRUCT x : INT := 4; n : REAL; inner : STRUCT x : WORD; END_STRUCT; END_STRUCT; END_TYPE
VAR_GLOBAL CONSTANT K : INT := 3; END_VAR
FUNCTION F : INT
VAR_INPUT x : INT; n : REAL; END_VAR
F := x;
END_FUNCTION
FUNCTION_BLOCK Fb
VAR_INPUT IN : BOOL; x : INT; END_VAR VAR_OUTPUT Q : BOOL; END_VAR
Q := IN AND x > 0;
END_FUNCTION_BLOCK
"""


@settings(max_examples=200, suppress_health_check=[HealthCheck.too_slow])
@given(_declarations, st.lists(_statements, max_size=4), st.sampled_from(["iec", "tia"]))
def test_any_text_gives_a_program_or_errors(
    declarations: str, statements: list[str], dialect: str
) -> None:
    body = "\n".join(statements)
    text = f"FUNCTION_BLOCK main\nVAR {declarations} END_VAR\n{body}\nEND_FUNCTION_BLOCK\n{_REST}"
    file, _ = parse_recovering(Source("text", text), dialect)
    program, findings = check_reporting([file], dialect)
    assert (program is None) == any(one.severity.value == "error" for one in findings)
    assert all(one.help and one.span is not None for one in findings)


@settings(max_examples=100)
@given(st.data())
def test_any_piece_cut_out_of_a_text_gives_a_program_or_errors(data: st.DataObject) -> None:
    start = data.draw(st.integers(0, len(_REST)))
    end = data.draw(st.integers(start, min(len(_REST), start + 40)))
    file, _ = parse_recovering(Source("text", _REST[:start] + _REST[end:]), "iec")
    check_reporting([file], "iec")
