# make run · make test · make soak · make bench · make docs-pictures · make clean
# make run ARGS="--port 8090 --lang pt_BR"        make run PYTHON=python3.13

PYTHON ?= python3
ARGS ?=
VENV := .venv
IN_VENV := $(VENV)/bin/python
PIP := $(IN_VENV) -m pip install -qq --disable-pip-version-check -c constraints.txt
# With ARGS="-k word" one of the two runs may have no test to choose from.
OR_NONE := $(if $(ARGS), || test $$? = 5)
BROWSERS := chromium chromium-browser google-chrome
OTHER_BROWSERS := firefox-esr webkit2gtk-driver xvfb libegl1

.PHONY: run test soak bench docs-pictures browser other-browsers clean

run: $(VENV)/ready-to-run
	@exec $(IN_VENV) -m helicoide $(ARGS)

test: $(VENV)/ready-to-test browser
	$(IN_VENV) -m ruff check
	$(IN_VENV) -m ruff format --check
	$(IN_VENV) -m mypy --strict app lessons robots
	$(IN_VENV) -m pytest -n 2 --dist loadfile --ignore=tests/browser $(ARGS)$(OR_NONE)
	$(IN_VENV) -m pytest tests/browser -n 2 --dist loadfile $(ARGS)$(OR_NONE)

soak: $(VENV)/ready-to-test browser other-browsers
	$(IN_VENV) -m pytest tests/soak -m soak -n 2 $(ARGS)

bench: $(VENV)/ready-to-test
	$(IN_VENV) -m tests.benchmarks $(ARGS)

docs-pictures: $(VENV)/ready-to-test browser
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

# Debian's Chromium: installed where that is allowed, named where it is not.
browser:
	@for name in $(BROWSERS); do command -v $$name >/dev/null && exit 0; done; \
	if [ "$$(id -u)" = 0 ]; then root=; else root="sudo -n"; fi; \
	if command -v apt-get >/dev/null && $$root true 2>/dev/null; then \
		echo "Installing Chromium for the tests."; \
		$$root apt-get update -qq && \
		$$root env DEBIAN_FRONTEND=noninteractive apt-get install -qq -y --no-install-recommends \
			chromium fonts-dejavu-core >/dev/null; \
	else \
		echo "The tests need a Chromium: install the package chromium, then run this again." >&2; exit 1; \
	fi

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
