"""DEV_Parameter against an option that answers late, torn images, and a network that goes.

The option here is not the simulated one: it gives the number back as late as it likes, and says
what it was told to write. So what the block promises does not rest on how the simulated one is.
"""

from collections import deque
from dataclasses import field
from pathlib import Path
from random import Random

import pytest

from fbgen.catalog import load_catalog
from fbgen.dataclass import dataclass
from fbgen.emit.generator import generate
from fbgen.plant import load_plant
from harness import load_program
from harness.engine.loading import LoadedProgram, engine_name
from harness.engine.variables import BlockInstance

PLANT = Path(__file__).parents[2] / "scenarios" / "devicenet" / "two_channels.yaml"
NUMBERS = (0x0000, 0x0001, 0x0091, 0x0880, 0xFA01, 0xFC36, 0xFD01, 0xFE01)
"""Some begin like the numbers that are read at rest, some end like them."""
TIMEOUT_MS = 300


@dataclass(slots=True)
class Option:
    """Takes the bytes of a poll, and answers with what it has made of one of the last polls."""

    shared: bool
    lag: int
    values: dict[int, int] = field(default_factory=dict)
    writes: list[tuple[int, int]] = field(default_factory=list)
    asked: tuple[bool, int, int] = (False, 0, 0)
    answers: deque[bytes] = field(default_factory=deque)

    def poll(self, data: bytes) -> bytes:
        request, number, value = (int.from_bytes(data[at : at + 2], "little") for at in (0, 2, 4))
        write = bool(number & 0x8000) if self.shared else bool(request & 1)
        index = number & 0x7FFF if self.shared else number
        asked = (write, index, value if write else 0)
        if write and asked != self.asked:
            self.writes.append((index, value))
            self.values[index] = value
        self.asked = asked
        refused = write and index & 0x7000 == 0x7000
        answer = 3 if refused else value if write else self.values.get(index, 0)
        if self.shared:
            words = (0, index | refused << 15, answer)
        else:
            words = (int(write) | refused << 15, index, answer)
        self.answers.append(b"".join(word.to_bytes(2, "little") for word in words))
        while len(self.answers) > self.lag + 1:
            self.answers.popleft()
        return self.answers[0]


def torn(random: Random, old: bytes, new: bytes, unit: int = 1) -> bytes:
    """A copy of `new` over `old` that is not through, in one direction or the other."""
    done = random.randrange(0, 7, unit)
    return new[:done] + old[done:] if random.random() < 0.5 else old[:done] + new[done:]


@dataclass(slots=True)
class Bench:
    program: LoadedProgram
    block: BlockInstance
    option: Option
    random: Random
    out: bytes = bytes(6)
    given: bytes = bytes(6)
    seen: bytes = bytes(6)
    connected: bool = True
    clock: int = 0

    def scan(self, **inputs: object) -> None:
        """One cycle of the PLC, with some polls in it, and what is torn."""
        random, block = self.random, self.block
        for _ in range(random.choice((0, 0, 1, 1, 2, 3))):
            self._poll(self.out)
        image = torn(random, self.seen, self.given, 2) if random.random() < 0.3 else self.given
        self.seen = self.given
        if not self.connected:
            image = bytes(6)
        words = [int.from_bytes(image[at : at + 2], "little") for at in (0, 2, 4)]
        frame = block.frameIn
        frame.response, frame.number, frame.data = words
        block(online=self.connected, shared=self.option.shared, **inputs)
        sent = block.frameOut
        new = b"".join(
            word.to_bytes(2, "little") for word in (sent.request, sent.number, sent.data)
        )
        if random.random() < 0.3:
            self._poll(torn(random, self.out, new))
        self.out = new
        self.program.clock.advance(ms=10)
        self.clock += 1
        self.option.values[0x0880] = self.clock

    def _poll(self, data: bytes) -> None:
        if self.connected:
            self.given = self.option.poll(data)


@pytest.fixture(scope="module", params=["compiled", "reference"])
def program(
    request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory
) -> LoadedProgram:
    """The generated text of a plant with both kinds of channels."""
    folder = tmp_path_factory.mktemp("generated")
    catalog = load_catalog()
    found = [
        file for file in generate(load_plant(PLANT, catalog), catalog).files if file.is_program
    ]
    for file in found:
        (folder / file.name).write_text(file.text, encoding="utf-8")
    names = [folder / file.name for file in found]
    return load_program(names, dialect="tia", engine=request.param)


@pytest.mark.parametrize("shared", [True, False])
@pytest.mark.parametrize("lag", [0, 3])
def test_no_answer_is_of_another_job_and_no_write_is_another_one(
    program: LoadedProgram, shared: bool, lag: int
) -> None:
    jobs = 400 if engine_name(program.engine) == "compiled" else 25
    random = Random(lag)
    made = Bench(program, program.instance("DEV_Parameter"), Option(shared, lag), random)
    block, option = made.block, made.option
    ended = set()
    made.scan(restart=True)
    made.scan(restart=False)
    for _ in range(jobs):
        number, mode, value = (
            random.choice(NUMBERS),
            random.choice((1, 2)),
            random.randrange(0x10000),
        )
        option.writes.clear()
        began, left = made.clock, dict(option.values)
        give_up = random.choice((None, None, random.randrange(8)))
        lose = random.choice((None, None, None, random.randrange(8)))
        at_start = {"mode": mode, "number": number, "value": value, "timeout": TIMEOUT_MS}
        made.scan(execute=True, **at_start)
        calls = 0
        while block.busy:
            calls += 1
            assert calls < 60
            if calls == lose:
                made.connected = False
            made.scan(execute=True, abort=calls == give_up, number=0x1111, value=0x2222)
        ended.add(block.status)
        made.connected = True
        index = number & 0x7FFF if shared else number
        wanted = [(index, value)] if mode == 2 else []
        at_rest = [item for item in option.writes if item not in wanted]
        assert all(item[0] & 0x7000 == 0x7000 for item in at_rest), "something else was written"
        assert not at_rest or not shared
        assert len(option.writes) - len(at_rest) <= len(wanted)
        if block.done:
            assert option.writes.count((index, value)) == len(wanted)
            if mode == 1 and index == 0x0880:
                assert began <= block.result <= made.clock
            elif mode == 1:
                assert block.result == left.get(index, 0)
            else:
                assert block.result == (value if index & 0x7000 != 0x7000 else 0)
        else:
            assert block.result == 0
        for _ in range(random.choice((1, 1, 2, 6))):
            before = len(option.writes)
            made.scan(execute=False, abort=False)
        assert len(option.writes) - before == 0 or not block.done
    assert ended >= {0x0000, 0x8404, 0x8405}
    assert jobs < 400 or 0x840C in ended
