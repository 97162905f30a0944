"""A plant that runs with rules looking on, of the generated blocks or of spoilt ones."""

from collections.abc import Sequence

from fbgen.catalog import Catalog
from fbgen.plant import Plant
from fbgen.source import Source
from harness.installation import PlantSetup, build_plant, generated_sources
from harness.kernel import NS_PER_MS
from harness.rules import RULES


class WatchedPlant:
    """It has just started. `broken` has what each of the rules has told so far.

    Each of `changes` is a piece of the blocks' text and what stands there instead.
    """

    def __init__(
        self,
        plan: Plant,
        catalog: Catalog,
        rules: Sequence[str],
        changes: Sequence[tuple[str, str]],
    ) -> None:
        sources = generated_sources(plan, catalog)
        for old, new in changes:
            assert any(old in source.text for source in sources)
            sources = [Source(item.name, item.text.replace(old, new)) for item in sources]
        self.plant = build_plant(plan, catalog, PlantSetup(sources=sources if changes else None))
        self.broken: dict[str, list[str]] = {}
        self._watches = {name: RULES[name].watch(self.plant) for name in rules}
        self.plant.cpu.after_scan.append(self.look)
        self.plant.start()

    def look(self) -> None:
        """As behind each scan; a scenario looks at the end of each step, too."""
        for name, watch in self._watches.items():
            if texts := list(watch()):
                self.broken.setdefault(name, []).extend(texts)

    def run_ms(self, milliseconds: int) -> None:
        self.plant.run_for(milliseconds * NS_PER_MS)
