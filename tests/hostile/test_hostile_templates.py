"""Templates of somebody else's: each attack ends with a diagnostic at its line, nothing written."""

import pickle
from pathlib import Path

import pytest

from fbgen.emit import sandbox
from tests.hostile.attack import TRIGGER, generate, with_template

PLACE = "templates/blocks/TOS_TriggerCounter.scl.jinja:21:"

ATTACKS = {
    "undefined_name": "{{ no_such_name }}",
    "undefined_attribute": "{{ plant.no_such_attribute }}",
    "classes": "{{ ''.__class__.__mro__[1].__subclasses__() }}",
    "attr_filter": "{{ ''|attr('__class__') }}",
    "globals_of_a_function": "{{ lipsum.__globals__.os.system('id') }}",
    "init_of_the_template": "{{ self.__init__.__globals__ }}",
    "format_string": "{{ '{0.__class__}'.format(plant) }}",
    "format_map": "{{ '{a.__class__}'.format_map({'a': plant}) }}",
    "model_reads_a_file": "{{ shake.parse_file('/etc/hostname') }}",
    "model_copies": "{{ shake.model_copy() }}",
    "model_of_a_word": "{{ control.entry.model_dump() }}",
    "changing_a_list": "{% set x = [] %}{{ x.append(1) }}",
    "huge_range": "{% for x in range(10 ** 12) %}{% endfor %}",
    "loops_in_loops": (
        "{% for a in range(99999) %}{% for b in range(99999) %}{% endfor %}{% endfor %}"
    ),
    "loops_over_a_list": (
        "{% set l = range(9999)|list %}{% for a in l %}{% for b in l %}{% endfor %}{% endfor %}"
    ),
    "huge_power": "{{ 9 ** (9 ** 9) }}",
    "huge_text": "{{ 'a' * 10 ** 12 }}",
    "huge_list": "{{ [1] * 999999999 }}",
    "huge_product": "{% set ns = namespace(n=3) %}{% for i in range(99) %}"
    "{% set ns.n = ns.n * ns.n %}{% endfor %}",
    "doubling": "{% set ns = namespace(s='ab') %}{% for i in range(99) %}"
    "{% set ns.s = ns.s ~ ns.s %}{% endfor %}",
    "adding": "{% set ns = namespace(s='ab') %}{% for i in range(99) %}"
    "{% set ns.s = ns.s + ns.s %}{% endfor %}",
    "huge_format": "{{ '%999999999999d' % 1 }}",
    "division_by_zero": "{{ 1 // 0 }}",
    "wrong_types": "{{ 1 + 'a' }}",
    "wrong_call": "{{ status.mask(1, 2) }}",
    "not_callable": "{{ plant() }}",
    "endless_macro": "{% macro m() %}{{ m() }}{% endmacro %}{{ m() }}",
    "syntax": "{% if %}",
    "unknown_tag": "{% nonsense %}",
    "unclosed": "{{ plant",
    "many_loops": "{% for a in [1] %}" * 30 + "{% endfor %}" * 30,
    "many_parentheses": "{{ " + "(" * 3000 + "1" + ")" * 3000 + " }}",
}


@pytest.mark.parametrize("attack", ATTACKS)
def test_an_attack_is_a_diagnostic_at_its_line(attack: str, tmp_path: Path) -> None:
    outcome = with_template(tmp_path, ATTACKS[attack])
    outcome.refused("FB5004")


IN_PLACE = set(ATTACKS) - {"endless_macro", "unclosed", "many_loops", "many_parentheses"}


@pytest.mark.parametrize("attack", sorted(IN_PLACE))
def test_the_diagnostic_shows_the_line_of_the_template(attack: str, tmp_path: Path) -> None:
    assert PLACE in with_template(tmp_path, ATTACKS[attack]).said


def test_a_model_of_the_catalogue_runs_no_pickle(tmp_path: Path) -> None:
    class Payload:
        def __reduce__(self) -> tuple[object, ...]:
            return (Path.touch, (tmp_path / "owned",))

    data = pickle.dumps(Payload(), protocol=0).decode("ascii")
    text = data.replace("\\", "\\\\").replace("'", "\\'").replace("\n", "\\n")
    line = f"{{{{ shake.parse_raw('{text}', proto='pickle', allow_pickle=true) }}}}"
    outcome = with_template(tmp_path, line)
    assert not (tmp_path / "owned").exists()
    outcome.refused("FB5004")


@pytest.mark.parametrize(
    "name", ["/etc/passwd", "../../../../etc/passwd", "no/such.jinja", "..", "", "C:\\\\x"]
)
def test_an_include_from_outside_the_template_folders_is_not_found(
    name: str, tmp_path: Path
) -> None:
    (tmp_path / "etc").mkdir()
    outcome = with_template(tmp_path, f"{{% include '{name}' %}}")
    outcome.refused("FB5003")
    assert PLACE in outcome.said


def test_an_include_of_itself_is_no_endless_loop(tmp_path: Path) -> None:
    with_template(tmp_path, f"{{% include 'blocks/{TRIGGER.name}' %}}").refused("FB5004")


@pytest.mark.parametrize("text", ["\ue0000\ue001", "\ue000999999\ue001", "\ue000", "\ue001x"])
def test_a_template_cannot_forge_marks_of_origin(text: str, tmp_path: Path) -> None:
    for folder, line in (("a", f"// {text}"), ("b", f"// {{{{ {text!a} }}}}")):
        (tmp_path / folder).mkdir()
        outcome = with_template(tmp_path / folder, line)
        assert outcome.status in (0, 1)
        assert "Traceback" not in outcome.said
        plc_text = [
            data for name, data in outcome.written.items() if name.endswith((".scl", ".udt", ".db"))
        ]
        assert all(data.isascii() for data in plc_text)


def test_what_is_no_plc_text_is_refused_at_the_line_of_the_template(tmp_path: Path) -> None:
    outcome = with_template(tmp_path, "   IF THEN")
    assert (outcome.status, outcome.written) == (1, {})
    assert PLACE.rsplit(":", 1)[0] in outcome.said
    assert "error[FB3" in outcome.said


def test_a_character_that_is_not_ascii_is_refused(tmp_path: Path) -> None:
    with_template(tmp_path, "   // Grüße").refused("FB3040")


def test_a_second_block_in_a_template_cannot_replace_the_users_main(tmp_path: Path) -> None:
    line = '   ;\nEND_FUNCTION_BLOCK\nORGANIZATION_BLOCK "Main"\nBEGIN\nEND_ORGANIZATION_BLOCK\n'
    outcome = with_template(tmp_path, line + 'FUNCTION_BLOCK "other"\nBEGIN\n')
    assert (outcome.status, outcome.written) == (1, {})


@pytest.mark.parametrize("content", [b"\xff\xfe\x00", b"\x80"])
def test_a_template_that_is_not_utf8_is_a_diagnostic(content: bytes, tmp_path: Path) -> None:
    (tmp_path / "templates" / "blocks").mkdir(parents=True)
    (tmp_path / "templates" / "blocks" / TRIGGER.name).write_bytes(content)
    generate(tmp_path, "--templates", str(tmp_path / "templates")).refused("FB5003")


def test_a_folder_in_the_place_of_a_template_is_a_diagnostic(tmp_path: Path) -> None:
    (tmp_path / "templates" / "blocks" / TRIGGER.name).mkdir(parents=True)
    outcome = generate(tmp_path, "--templates", str(tmp_path / "templates"))
    assert "Traceback" not in outcome.said


def test_a_template_folder_that_is_not_there_is_a_diagnostic(tmp_path: Path) -> None:
    generate(tmp_path, "--templates", str(tmp_path / "missing")).refused("FB5002")


def test_tags_over_several_lines_are_fine(tmp_path: Path) -> None:
    lines = "{% set x = [\n   'one',\n   'two',\n] %}\n   // {{ x[\n      0] }} {# a\n comment #}"
    outcome = with_template(tmp_path, lines)
    assert outcome.status == 0, outcome.said
    assert b"// one" in outcome.written["TOS_TriggerCounter.scl"]


def test_every_template_may_use_all_passes(tmp_path: Path) -> None:
    passes = sandbox.LOOP_PASSES - 1000
    outcome = with_template(tmp_path, f"{{% for x in range({passes}) %}}{{% endfor %}}")
    assert outcome.status == 0, outcome.said
