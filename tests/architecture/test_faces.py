"""Packages whose names come from modules that are imported when somebody asks for one."""

from importlib import import_module

import pytest

from tests.architecture.sources import modules

FACES = ["fbgen.lang.checker", "fbgen.lang.containers", "harness", "harness.trace"]


@pytest.mark.parametrize("package", FACES)
def test_a_face_gives_every_name_that_it_promises(package: str) -> None:
    face = import_module(package)
    assert sorted(face._HOMES) == sorted(face.__all__)
    for name in face.__all__:
        assert getattr(face, name) is not None
    with pytest.raises(AttributeError, match=f"module '{package}' has no attribute 'nothing'"):
        _ = face.nothing


@pytest.mark.parametrize("package", FACES)
def test_no_name_of_a_face_is_a_module_too(package: str) -> None:
    """Python would bind the name to the module once that was imported."""
    inside = {name.removeprefix(f"{package}.").partition(".")[0] for name in modules()}
    assert not inside & set(import_module(package).__all__)
