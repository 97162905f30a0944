"""Why a function of the library cannot go on. The engine turns these into diagnostics."""


class Stop(Exception):  # noqa: N818  # it is no error of this program, but of the PLC's
    """The running program stops here."""


class IndexOutside(Stop):
    """An array index outside its bounds; `dimension` counts from 1.

    `bounds` are those of an ARRAY[*]; of any other array they stand in its type.
    """

    def __init__(
        self, index: int, dimension: int = 1, bounds: tuple[int, int] | None = None
    ) -> None:
        super().__init__(index)
        self.bounds = bounds
        self.index = index
        self.dimension = dimension


class ZeroDivisor(Stop):
    """A whole number or a duration divided by zero."""


class NoFit(Stop):
    """A number that the target type cannot hold."""

    def __init__(self, value: float) -> None:
        super().__init__(value)
        self.value = value


class OutsideLimits(Stop):
    """A whole number that the subrange it is meant for does not allow."""

    def __init__(self, value: int) -> None:
        super().__init__(value)
        self.value = value


class NullReference(Stop):
    """A reference is followed that refers to nothing."""


class NoDate(Stop):
    """The parts of a DTL are no date and time."""


class NoNumber(Stop):
    """A text that is no number of the target type."""

    def __init__(self, text: str) -> None:
        super().__init__(text)
        self.text = text


class NoDecimal(Stop):
    """A BCD number with a digit above 9."""

    def __init__(self, value: int) -> None:
        super().__init__(value)
        self.value = value


class NoInput(Stop):
    """MUX with a selector for which there is no input; there are `count` inputs."""

    def __init__(self, selector: int, count: int) -> None:
        super().__init__(selector)
        self.selector = selector
        self.count = count


class Endless(Stop):
    """The loops have begun more passes than one call may."""


class StepZero(Stop):
    """FOR with a step of zero."""


class TooDeep(Stop):
    """Blocks are nested deeper than allowed; `block` is the one that was to be entered."""

    def __init__(self, block: str) -> None:
        super().__init__(block)
        self.block = block


class NoAddress(Stop):
    """An absolute address behind the end of its area of `size` bytes."""

    def __init__(self, size: int) -> None:
        super().__init__(size)
        self.size = size


class NoBlock(Stop):
    """There is no data block with this number."""

    def __init__(self, number: int) -> None:
        super().__init__(number)
        self.number = number


class NoArea(Stop):
    """An ANY or POINTER is followed whose bytes mean no area."""

    def __init__(self, pattern: bytes, reason: str) -> None:
        super().__init__(reason)
        self.pattern = pattern
        self.reason = reason


class CannotRun(Stop):
    """A statement that is read and checked only."""

    def __init__(self, what: str) -> None:
        super().__init__(what)
        self.what = what


class NoSuchDate(Stop):
    """Numbers that make up no date or time of day."""

    def __init__(self, text: str) -> None:
        super().__init__(text)
        self.text = text
