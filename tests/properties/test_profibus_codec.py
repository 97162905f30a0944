"""Configuration identifiers: decoding undoes encoding, and any bytes are decoded or refused."""

from hypothesis import given
from hypothesis import strategies as st

from fbgen.wire.profibus import (
    Consistency,
    Extent,
    IdentifierError,
    decode_identifiers,
    encode_identifier,
)

extents = st.none() | st.builds(
    Extent, st.integers(1, 64), st.sampled_from([1, 2]), st.sampled_from(Consistency)
)


@given(extents, extents, st.binary(max_size=14))
def test_decoding_gives_back_what_was_encoded(outputs, inputs, manufacturer):
    identifier = encode_identifier(outputs, inputs, manufacturer)
    assert decode_identifiers(identifier.code) == (identifier,)
    assert (identifier.outputs, identifier.inputs) == (outputs, inputs)


@given(st.binary(max_size=40))
def test_any_bytes_are_decoded_completely_or_refused(code):
    try:
        identifiers = decode_identifiers(code)
    except IdentifierError:
        return
    assert b"".join(identifier.code for identifier in identifiers) == code
