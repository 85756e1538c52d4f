# make run · make check · make test · make soak · make bench · make docs-pictures · make clean
# make run ARGS="--port 8090 --lang pt_BR"        make run PYTHON=python3.13

PYTHON ?= python3
ARGS ?=
VENV := .venv
IN_VENV := $(VENV)/bin/python
PIP := $(IN_VENV) -m pip install -qq --disable-pip-version-check -c constraints.txt
# Words pick tests by name; an option or a path goes to pytest as it is.
PICKED := $(if $(filter -% tests/%,$(firstword $(ARGS))),$(ARGS),$(if $(ARGS),-k "$(ARGS)"))

.PHONY: run check test soak bench docs-pictures clean

run: $(VENV)/ready-to-run
	@exec $(IN_VENV) -m helicoide $(ARGS)

check: $(VENV)/ready-to-test
	@$(IN_VENV) -m tests.parts check $(PICKED)

test: $(VENV)/ready-to-test
	@$(IN_VENV) -m tests.parts test $(PICKED)

soak: $(VENV)/ready-to-test
	-@$(IN_VENV) -m tests.system browser firefox webkit
	$(IN_VENV) -m pytest -m "soak or hypothesis" --hypothesis-profile search -n 2 $(PICKED)

bench: $(VENV)/ready-to-test
	$(IN_VENV) -m tests.benchmarks $(ARGS)

docs-pictures: $(VENV)/ready-to-test
	@$(IN_VENV) -m tests.system browser
	$(IN_VENV) -m tests.browser.pictures $(ARGS)

# The build backend is installed first and pinned like the rest, so that pip does not fetch another one to build with.
$(VENV)/ready-to-run: pyproject.toml constraints.txt
	@$(PYTHON) -c 'import sys; sys.exit("Helicoide needs Python 3.11 to 3.14, and this is %d.%d: make run PYTHON=python3.x" % sys.version_info[:2] if not (3, 11) <= sys.version_info < (3, 15) else 0)'
	@test -x $(IN_VENV) || echo "Setting up in $(VENV): this takes a minute or two, and happens once."
	@$(PYTHON) -m venv $(VENV)
	@$(PIP) hatchling
	@$(PIP) --no-build-isolation --editable .
	@touch $@

$(VENV)/ready-to-test: $(VENV)/ready-to-run
	@echo "Installing what the tests need."
	@$(PIP) --no-build-isolation --editable '.[test]'
	@touch $@

clean:
	rm -rf $(VENV) .venv-bench .pytest_cache .mypy_cache .ruff_cache .hypothesis
	find app lessons robots tests -name __pycache__ -type d -prune -exec rm -rf {} +
