# make run · make check · make test · make soak · make bench · make docs-pictures · make clean
# make run ARGS="--port 8090 --lang pt_BR"        make run PYTHON=python3.13

PYTHON ?= python3
ARGS ?=
VENV := .venv
IN_VENV := $(VENV)/bin/python
PIP := $(IN_VENV) -m pip install -qq --disable-pip-version-check -c constraints.txt
# Words pick tests by name; an option or a path goes to pytest as it is.
PICKED := $(if $(filter -% tests/%,$(firstword $(ARGS))),$(ARGS),$(if $(ARGS),-k "$(ARGS)"))
OTHER_BROWSERS := firefox-esr webkit2gtk-driver xvfb libegl1

.PHONY: run check test soak bench docs-pictures other-browsers clean

run: $(VENV)/ready-to-run
	@exec $(IN_VENV) -m helicoide $(ARGS)

check: $(VENV)/ready-to-test
	@$(IN_VENV) -m tests.parts check $(PICKED)

test: $(VENV)/ready-to-test
	@$(IN_VENV) -m tests.parts test $(PICKED)

soak: $(VENV)/ready-to-test other-browsers
	$(IN_VENV) -m pytest -m "soak or hypothesis" --hypothesis-profile search -n 2 $(PICKED)

bench: $(VENV)/ready-to-test
	$(IN_VENV) -m tests.benchmarks $(ARGS)

docs-pictures: $(VENV)/ready-to-test
	@$(IN_VENV) -m tests.system browser
	$(IN_VENV) -m tests.browser.pictures

# The build backend is installed first and pinned like the rest, so that pip does not fetch another one to build with.
$(VENV)/ready-to-run: pyproject.toml constraints.txt
	@$(PYTHON) -c 'import sys; sys.exit("Helicoide needs Python 3.11 or newer, and this is %d.%d: make run PYTHON=python3.x" % sys.version_info[:2] if sys.version_info < (3, 11) else 0)'
	@test -x $(IN_VENV) || echo "Setting up in $(VENV): this takes a minute or two, and happens once."
	@$(PYTHON) -m venv $(VENV)
	@$(PIP) hatchling
	@$(PIP) --no-build-isolation --editable .
	@touch $@

$(VENV)/ready-to-test: $(VENV)/ready-to-run
	@echo "Installing what the tests need."
	@$(PIP) --no-build-isolation --editable '.[test]'
	@touch $@

# Debian's Firefox and WebKit, and a screen that nobody sees: installed where that is allowed. Where it is not, the rest
# of the long counts can still be had, and the tests of a browser that is missing fail.
other-browsers:
	@absent=; for name in $(OTHER_BROWSERS); do \
		dpkg -s $$name 2>/dev/null | grep -q '^Status: .* installed' || absent="$$absent $$name"; \
	done; \
	test -n "$$absent" || exit 0; \
	if [ "$$(id -u)" = 0 ]; then root=; else root="sudo -n"; fi; \
	if command -v apt-get >/dev/null && $$root true 2>/dev/null; then \
		echo "Installing for the tests:$$absent."; \
		$$root apt-get update -qq && \
		$$root env DEBIAN_FRONTEND=noninteractive apt-get install -qq -y --no-install-recommends $$absent >/dev/null; \
	else \
		echo "Some tests need Firefox and WebKit: install the packages$$absent." >&2; \
	fi

clean:
	rm -rf $(VENV) .venv-bench .pytest_cache .mypy_cache .ruff_cache .hypothesis
	find app lessons robots tests -name __pycache__ -type d -prune -exec rm -rf {} +
