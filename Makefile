# make demo and make test need only Python 3.11+ and PyPI: everything else goes into .venv.
# Another Python: make test PYTHON=python3.12

# The Python of an existing .venv, otherwise the first on the path that is new enough.
PYTHON ?= $(or $(wildcard .venv/bin/python),$(shell \
  for python in python3 python3.13 python3.12 python3.11 python; do \
    $$python -c 'import sys; sys.exit(sys.version_info < (3, 11))' 2>/dev/null && echo $$python && break; \
  done),python3)
BIN := .venv/bin
# The tests and the phase sweep run in this many processes at once.
JOBS ?= 2

.PHONY: help demo test check spelling bench sweep phases golden schemas pages format environment

help:
	@echo "make demo     run the manual's example on the example plant: from YAML to inverter and back"
	@echo "make test     ruff, mypy --strict and all tests; ends with what was skipped and why"
	@echo "make check    ruff and mypy alone"
	@echo "make sweep    the tests marked slow"
	@echo "make phases   the phase sweep over every combination, with its table; ended early, it"
	@echo "              goes on from build/phases.jsonl (JOBS=4: in four processes)"
	@echo "make bench    speed and size"
	@echo "make golden   write the golden files anew (look at the difference before you commit)"
	@echo "make schemas  write the JSON Schemas anew"
	@echo "make pages    write the pages of docs/reference that are made from the program anew"
	@echo "make format   let ruff format and mend"

environment:
	@$(PYTHON) tools/environment.py

demo: environment
	@$(BIN)/fbgen demo

test: spelling
	$(BIN)/python tools/checks.py -n $(JOBS) --dist worksteal

check: spelling
	$(BIN)/mypy

spelling: environment
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .

sweep: environment
	$(BIN)/python -m pytest -n $(JOBS) --dist worksteal -m slow

phases: environment
	$(BIN)/python -m harness.sweep tests/unit/sweep/line.yaml -j $(JOBS) --journal build/phases.jsonl

bench: environment
	$(BIN)/python -m bench

golden: environment
	$(BIN)/python -m pytest -n $(JOBS) --update-golden

schemas: environment
	$(BIN)/fbgen schemas schemas

pages: environment
	$(BIN)/python tools/diagnostics_index.py
	$(BIN)/python -m tools.pages

format: environment
	$(BIN)/ruff check --fix .
	$(BIN)/ruff format .
