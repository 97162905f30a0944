"""Objects come back from the cache as they were."""

from types import MappingProxyType

import pytest

from fbgen.cache import remembered, remembering
from fbgen.cache.objects import packed_objects, unpacked_objects
from fbgen.catalog import Catalog, catalog, load_catalog
from fbgen.lang import types


def through(content: object) -> object:
    packed = packed_objects(content)
    assert packed is not None
    return unpacked_objects(packed)


def test_compiled_python_runs_as_before() -> None:
    names: dict[str, object] = {}
    exec(through(compile("x = 6 * 7", "<text>", "exec")), names)
    assert names["x"] == 42


def test_read_only_mappings_stay_so() -> None:
    found = through(MappingProxyType({"a": (1, 2)}))
    assert isinstance(found, MappingProxyType)
    assert found == {"a": (1, 2)}


def test_each_elementary_type_is_the_same_object_again() -> None:
    every = [kind for kind in vars(types).values() if isinstance(kind, types.Elementary)]
    again = through(every)
    assert isinstance(again, list)
    assert len(every) > 30
    assert all(one is other for one, other in zip(every, again, strict=True))


def test_what_is_nested_too_deep_is_not_packed() -> None:
    nested: list[object] = []
    for _ in range(100_000):
        nested = [nested]
    assert packed_objects(nested) is None
    while nested:  # Python itself would take its end as deep as it is nested
        (nested,) = nested


@pytest.mark.parametrize("content", [lambda: 1, memoryview(b"x")])
def test_what_cannot_be_packed_is_not_kept(content: object) -> None:
    assert packed_objects([content]) is None


@pytest.fixture
def empty(tmp_path: object, monkeypatch: pytest.MonkeyPatch) -> None:
    """A cache in which nothing is yet."""
    monkeypatch.setenv("FBGEN_CACHE", str(tmp_path))


@pytest.mark.usefixtures("empty")
def test_what_is_remembered_is_made_once_for_the_same_parts() -> None:
    made: list[str] = []

    def make(text: str) -> list[str]:
        return remembered(["a test", text], lambda: made.append(text) or [text, text])

    assert [make("a"), make("b"), make("a")] == [["a", "a"], ["b", "b"], ["a", "a"]]
    assert made == ["a", "b"]


@pytest.mark.usefixtures("empty")
def test_what_is_wrong_is_told_each_time() -> None:
    for _ in range(2):
        with pytest.raises(ZeroDivisionError):
            remembered(["a test"], lambda: 1 / 0)


@pytest.mark.usefixtures("empty")
def test_the_catalogue_comes_back_as_it_was_with_all_its_places(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    read = catalog._shipped_catalog.__wrapped__
    first = read()
    monkeypatch.setattr(catalog, "_load", lambda folders: pytest.fail("it is kept"))
    second = read()
    for kind in catalog.KINDS:
        assert getattr(second, kind) == getattr(first, kind) == getattr(load_catalog(), kind)
    assert list(places(second)) == list(places(first))


def places(known: Catalog) -> list[object]:
    """Where entries, some of their fields and their items stand."""
    return [
        (span.source.name, span.source.text, span.start, span.end)
        for drive in known.drives.values()
        for model in (drive, *drive.comnos, *drive.words)
        for span in (
            model.span,
            *(model.span_of(name) for name in type(model).model_fields),
            *(model.key_span_of(name) for name in type(model).model_fields),
            drive.item_span_of("comnos", 1),
        )
        if span is not None
    ]


@pytest.mark.usefixtures("empty")
def test_where_nothing_can_be_kept_everything_is_made_anew(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setenv("FBGEN_CACHE", "off")
    monkeypatch.setattr(remembering, "packed_objects", lambda content: pytest.fail("what for?"))
    assert [remembered(["a test"], list) for _ in range(2)] == [[], []]
