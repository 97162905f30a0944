"""The block of the page on serial ports carries a plant, in place of the part of the model."""

from collections.abc import Sequence
from pathlib import Path

import pytest

from fbgen.cli import main
from harness import load_program
from harness.plc.serial.adapter import SerialAdapter
from harness.plc.serial.module import SerialModule
from tests.unit.documentation.markdown import ROOT, blocks_of

PAGE = "docs/how-to/bind-a-serial-port.md"
GIVEN = ("sendCount", "sendLength", "takenCount")
TAKEN = ("sentCount", "receiveCount", "receiveLength", "damaged", "failed", "status")


class Bound:
    """One line: what the page's programs do around SerialBinding, with the simulated module."""

    def __init__(self, sources: Sequence[Path]) -> None:
        self._program = load_program(sources, dialect="iec")
        self._block = self._program.instance("SerialBinding")
        self._at_ms = 0
        self.sent = 0

    def exchange(self, adapter: SerialAdapter) -> None:
        """Behind a scan, as SerialAdapter.exchange."""
        now_ms = adapter._kernel.now_ns // 1_000_000
        self._program.clock.advance(ms=now_ms - self._at_ms)
        self._at_ms = now_ms
        block, meeting, module = self._block, self._block.adapter, adapter._module
        for name in GIVEN:
            setattr(meeting, name, adapter._number(name))
        for index, one in enumerate(adapter._octets("outBytes")):
            meeting.outBytes[index] = one
        data, broken = _received(module)
        for index, one in enumerate(data):
            block.fresh[index] = one
        block(usable=module.available, reason=0xFFFF, freshCount=len(data), broken=broken)
        if block.send:
            self.sent += 1
            module.send(bytes(meeting.outBytes[index] for index in range(meeting.sendLength)))
        for name in TAKEN:
            adapter._set(name, getattr(meeting, name))
        adapter._set("inBytes", [meeting.inBytes[index] for index in range(32)])


def _received(module: SerialModule) -> tuple[bytes, bool]:
    message = module.take() if module.available else None
    return (b"", False) if message is None else (message.data[:64], message.failed)


@pytest.mark.parametrize(
    ("plant", "scenario"),
    [
        ("examples/modbus/plant.yaml", "examples/modbus/modbus.scenario.yaml"),
        ("examples/serial/plant.yaml", "tests/scenarios/serial/unplugged.scenario.yaml"),
    ],
)
def test_the_block_of_the_page_carries_a_plant(
    plant: str,
    scenario: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    assert main(["generate", str(ROOT / plant), "-o", str(tmp_path), "--dialect", "iec"]) == 0
    binding = tmp_path / "binding.st"
    binding.write_text(next(one.text for one in blocks_of(PAGE) if one.name == binding.name))
    bound: dict[SerialAdapter, Bound] = {}

    def exchange(adapter: SerialAdapter) -> None:
        if adapter not in bound:
            bound[adapter] = Bound(sorted(tmp_path.glob("*.st")))
        bound[adapter].exchange(adapter)

    monkeypatch.setattr(SerialAdapter, "exchange", exchange)
    chosen = ("--dialect", "iec", "-k", '"[iec]"', "--jobs", "1")
    status = main(["test", str(ROOT / scenario), *chosen])
    assert status == 0, capsys.readouterr().out
    assert [one.sent > 50 for one in bound.values()] == [True]
