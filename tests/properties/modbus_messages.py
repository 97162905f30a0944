"""Every message of MODBUS-RTU that a frame can say, as strategies."""

from hypothesis import strategies as st

from fbgen.wire import modbus

words = st.integers(0, 0xFFFF)
bytes_ = st.integers(0, 0xFF)
to = st.integers(0, 247)
by = st.integers(1, 247)
read_counts = st.integers(1, 125)
codes = st.integers(1, 4)


def _some(most: int) -> st.SearchStrategy[tuple[int, ...]]:
    few = st.lists(words, min_size=1, max_size=8)
    return st.one_of(few, st.lists(words, min_size=most, max_size=most)).map(tuple)


objects = st.dictionaries(bytes_, st.binary(max_size=20), max_size=5).map(
    lambda found: tuple(found.items())
)

requests: st.SearchStrategy[modbus.Request] = st.one_of(
    st.builds(modbus.ReadRequest, to, words, read_counts),
    st.builds(modbus.WriteRequest, to, words, words),
    st.builds(modbus.WriteSeveralRequest, to, words, _some(123)),
    st.builds(modbus.ReadWriteRequest, to, words, read_counts, words, _some(121)),
    st.builds(modbus.IdentifyRequest, to, codes, bytes_),
)
replies: st.SearchStrategy[modbus.Reply] = st.one_of(
    st.builds(modbus.ReadReply, by, _some(125)),
    st.builds(modbus.WriteReply, by, words, words),
    st.builds(modbus.WriteSeveralReply, by, words, st.integers(1, 123)),
    st.builds(modbus.ReadWriteReply, by, _some(125)),
    st.builds(modbus.IdentifyReply, by, codes, bytes_, objects, st.booleans(), bytes_),
    st.builds(modbus.ExceptionReply, by, st.integers(1, 0x7F), st.integers(1, 0xFF)),
)
