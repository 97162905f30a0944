"""Looking on while a program runs: probes, and who wrote what."""
