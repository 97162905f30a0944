"""The communication modules of one CPU, by hardware identifier or start address."""

from collections.abc import Callable, Iterator

from fbgen.diagnostics import error
from harness.kernel import Kernel
from harness.plc.serial.module import SerialModule


class SerialPorts:
    """What the instructions reach. `let_happen` lets the world go on up to the access itself."""

    __slots__ = ("_kernel", "_let_happen", "_modules", "data_block")

    def __init__(
        self,
        kernel: Kernel,
        let_happen: Callable[[], None],
        data_block: Callable[[int], bytearray | None],
    ) -> None:
        """`data_block` gives the bytes of a data block of the program that runs."""
        self._kernel = kernel
        self._let_happen = let_happen
        self._modules: dict[int, SerialModule] = {}
        self.data_block = data_block

    def __iter__(self) -> Iterator[SerialModule]:
        return iter(self._modules.values())

    def plug(self, port: int, module: SerialModule) -> None:
        """A module in its place. Raises DiagnosticError FB7402 for one that is taken."""
        if port in self._modules:
            raise error(
                "FB7402",
                f"the port {port} belongs to both '{self._modules[port].name}' and '{module.name}'",
                None,
                "choose hardware identifiers or addresses that differ",
            )
        self._modules[port] = module

    @property
    def now_ns(self) -> int:
        """The instant of the access that `reach` was called for."""
        return self._kernel.now_ns

    def reach(self, port: int) -> SerialModule | None:
        """The module at a port, at the instant of this access; None if nobody answers."""
        self._let_happen()
        module = self._modules.get(port)
        return module if module is not None and module.available else None
