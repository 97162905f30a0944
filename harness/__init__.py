"""The harness: runs PLC text scan by scan against simulated gateways and inverters."""

from harness.engine.loading import LoadedProgram, load_program

__all__ = ["LoadedProgram", "load_program"]
