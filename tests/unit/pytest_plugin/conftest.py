"""Sessions of pytester in this process forget the modules that they were the first to import, and
with them classes that others know already. So what the plugin imports is imported before."""

from importlib import import_module

for name in ("fbgen.emit.generator", "harness.scenario", "harness.verify.coverage.observing"):
    import_module(name)
