"""A state machine as a picture: states from top to bottom, ways down at the right, up at the left.

Each way has the number of its row in the table below the picture.
"""

from collections.abc import Iterator

from fbgen.docs.blocks.states import StateMachine
from fbgen.docs.drawing import Anchor, Box, Colour, Drawing, Label, Line, Shape

_BOX_WIDTH, _BOX_HEIGHT, _STEP, _LANE, _TOP = 270.0, 26.0, 54.0, 30.0, 10.0
_ANY = -1


def state_picture(machine: StateMachine) -> Drawing:
    """The picture; what can begin in every state begins at a box of its own on top."""
    ways = _ways(machine)
    rows = [_ANY] if any(source == _ANY for source, _ in ways) else []
    rows += list(machine.names)
    place = {state: index for index, state in enumerate(rows)}
    lanes = _lanes({way: (place[way[0]], place[way[1]]) for way in ways})
    left_lanes = max((lane for way, lane in lanes.items() if _is_up(way, place)), default=-1) + 1
    right_lanes = max((lane for way, lane in lanes.items() if not _is_up(way, place)), default=-1)
    left = 14 + _LANE * left_lanes
    shapes: list[Shape] = []
    for way, numbers in ways.items():
        shapes += _way(way, numbers, place, lanes[way], left)
    for state, index in place.items():
        y = _TOP + _STEP * index
        any_state = state == _ANY
        shapes.append(
            Box(
                left,
                y,
                _BOX_WIDTH,
                _BOX_HEIGHT,
                "panel" if any_state else "fill",
                "line" if any_state else "accent",
                13,
            )
        )
        text = "from every state" if any_state else machine.name(state)
        middle = left + _BOX_WIDTH / 2
        shapes.append(Label(middle, y + 17.5, _cut(text), 12, "middle", strong=not any_state))
    width = left + _BOX_WIDTH + _LANE * (right_lanes + 1) + 40
    return Drawing(width, _TOP + _STEP * len(rows) - _STEP + _BOX_HEIGHT + 12, tuple(shapes))


def _ways(machine: StateMachine) -> dict[tuple[int, int], list[int]]:
    """From and to -> the numbers of the transitions, from 1."""
    found: dict[tuple[int, int], list[int]] = {}
    for number, transition in enumerate(machine.transitions, start=1):
        if transition.target is None:
            continue
        sources = (_ANY,) if machine.is_any(transition) else transition.sources
        for source in sources:
            found.setdefault((source, transition.target), []).append(number)
    return found


def _is_up(way: tuple[int, int], place: dict[int, int]) -> bool:
    return place[way[0]] > place[way[1]]


def _lanes(spans: dict[tuple[int, int], tuple[int, int]]) -> dict[tuple[int, int], int]:
    """Ways that overlap get lanes of their own, short ones the inner lanes."""
    found: dict[tuple[int, int], int] = {}
    for up in (False, True):
        taken: list[list[tuple[int, int]]] = []
        side = [item for item in spans.items() if (item[1][0] > item[1][1]) == up]
        for way, (first, last) in sorted(side, key=lambda item: abs(item[1][0] - item[1][1])):
            low, high = min(first, last), max(first, last)
            lane = next(
                (
                    number
                    for number, row in enumerate(taken)
                    if all(high < other or last_one < low for other, last_one in row)
                ),
                len(taken),
            )
            if lane == len(taken):
                taken.append([])
            taken[lane].append((low, high))
            found[way] = lane
    return found


def _way(
    way: tuple[int, int], numbers: list[int], place: dict[int, int], lane: int, left: float
) -> Iterator[Shape]:
    source, target = place[way[0]], place[way[1]]
    text = ",".join(map(str, numbers))
    down = source <= target
    edge = left + _BOX_WIDTH if down else left
    x = edge + (14 + _LANE * lane) * (1 if down else -1)
    begin = _TOP + _STEP * source + _BOX_HEIGHT * (0.72 if down else 0.28)
    end = _TOP + _STEP * target + _BOX_HEIGHT * (0.28 if down else 0.72)
    if source == target:
        begin, end = begin - 14, end + 14
    colour: Colour = "muted" if way[0] == _ANY else "accent"
    yield Line(((edge, begin), (x, begin), (x, end), (edge, end)), colour, 1.3, arrow=True)
    anchor: Anchor = "start" if down else "end"
    shift = 3 if down else -3
    yield Label(x + shift, (begin + end) / 2 + 4, text, 10.5, anchor, "ink", fixed=True)


def _cut(text: str) -> str:
    return text if len(text) <= 40 else text[:38] + ".."
