"""Sequences that lie in the folder `sequences` beside a plant file."""

from pathlib import Path

import pytest

from fbgen.catalog import load_catalog, with_own_sequences
from fbgen.diagnostics import DiagnosticError
from fbgen.plant import write_own_sequence


def write(folder: Path, name: str, text: str) -> None:
    (folder / "sequences").mkdir(exist_ok=True)
    (folder / "sequences" / name).write_text(text, encoding="utf-8")


def test_they_stand_beside_those_of_the_catalogue(tmp_path: Path) -> None:
    write(tmp_path, "start_and_wait.yaml", write_own_sequence())
    known = with_own_sequences(load_catalog(), tmp_path)
    assert known.sequence("start_and_wait").title.startswith("Start forward")
    assert known.sequence("stop").id == "stop"
    assert known.sources[-1].name.endswith("sequences/start_and_wait.yaml")


def test_one_with_a_known_id_takes_its_place(tmp_path: Path) -> None:
    write(tmp_path, "stop.yaml", write_own_sequence().replace("id: start_and_wait", "id: stop"))
    known = with_own_sequences(load_catalog(), tmp_path)
    assert known.sequence("stop").title.startswith("Start forward")
    assert [item.id for item in known.replaced] == ["stop"]
    assert not load_catalog().replaced


def test_without_the_folder_the_catalogue_stays_what_it_is(tmp_path: Path) -> None:
    assert with_own_sequences(load_catalog(), tmp_path) is load_catalog()


def test_what_is_wrong_in_one_is_told_at_its_place(tmp_path: Path) -> None:
    text = write_own_sequence().replace("- wait: status", "- wait: no_such_comno")
    write(tmp_path, "start_and_wait.yaml", text)
    with pytest.raises(DiagnosticError) as caught:
        with_own_sequences(load_catalog(), tmp_path)
    (found,) = caught.value.diagnostics
    assert found.code == "FB1105"
    assert found.span is not None
    assert found.span.source.name.endswith("sequences/start_and_wait.yaml")
    assert text.splitlines()[found.span.line - 1].strip() == "- wait: no_such_comno"


def test_the_file_is_called_like_its_id(tmp_path: Path) -> None:
    write(tmp_path, "other.yaml", write_own_sequence())
    with pytest.raises(DiagnosticError) as caught:
        with_own_sequences(load_catalog(), tmp_path)
    assert [found.code for found in caught.value.diagnostics] == ["FB1111"]
