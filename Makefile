# Two commands do everything: `make demo` and `make test`.

PYTHON ?= $(firstword $(foreach name,python3.11 python3.12 python3.13 python3,$(shell command -v $(name) 2>/dev/null)))
VENV := .venv
BIN := $(VENV)/bin
PICTURES := tests/pictures
SOURCES := app tests examples

.PHONY: demo quick test check bench compare wheel clean browser page-scripts protocol

# Hundreds of short processes are started by the tests; each would compile all it imports.
export PYTHONDONTWRITEBYTECODE :=

# The environment and the browser are installed at the same time.
MAKEFLAGS += --jobs=2

demo: $(VENV)/ready-to-run
	$(BIN)/keyphase open data/setup1.npz

# No server, no browser, no simulation: what a change to the domain is tried with, over and over.
# Ten examples of each property here, as many as each asks for in `make test`.
quick: $(VENV)/ready-to-test
	OMP_NUM_THREADS=1 $(BIN)/pytest -q -n 2 --hypothesis-profile quick -m "not browser and not slow" tests/readers tests/segmentation tests/labeling tests/skills tests/test_*.py

# Processes are killed and a browser drawing in software is driven here: what a busy machine
# upsets is tried again, and the summary says so. What is broken stays broken.
test: $(VENV)/ready-to-test browser page-scripts
	$(BIN)/ruff format --check --quiet $(SOURCES)
	$(BIN)/ruff check --quiet $(SOURCES)
	PYTHONPATH=app $(BIN)/lint-imports --no-cache --no-logo
	OMP_NUM_THREADS=1 $(BIN)/pytest -q -n 2 --dist worksteal --reruns 1 -rR -m "not browser" --ignore tests/browser
	OMP_NUM_THREADS=1 $(BIN)/pytest -q -n 3 --dist worksteal --reruns 2 -rR -m browser tests/browser

browser:
	sh tests/ensure_chromium.sh

# The page's types and docs/protocol.md, made of the structs of the protocol.
protocol: $(VENV)/ready-to-test
	PYTHONPATH=app $(BIN)/python tests/web/write_protocol.py

# The page's scripts are read as they are written; Node checks them and is not needed to run them.
page-scripts: node_modules/ready
	npm run --silent check
	npm run --silent format
	npm run --silent test

node_modules/ready: package.json
	npm install --no-package-lock --no-audit --no-fund --silent
	@touch $@

check: $(VENV)/ready-to-test page-scripts
	$(BIN)/ruff format --check $(SOURCES)
	$(BIN)/ruff check $(SOURCES)
	PYTHONPATH=app $(BIN)/lint-imports --no-cache --no-logo
	$(BIN)/pyright

bench: $(VENV)/ready-to-test
	OMP_NUM_THREADS=1 $(BIN)/pytest tests/benchmarks -q -o python_files='bench_*.py' -o addopts= --benchmark-only

# keyphase beside other methods; claspy needs older packages, so it gets an environment of its own.
compare: $(VENV)/ready-to-test
	$(BIN)/python -m pip install --quiet --constraint constraints.txt --editable '.[compare]'
	test -x .venv-claspy/bin/python || $(PYTHON) -m venv .venv-claspy
	.venv-claspy/bin/python -m pip install --quiet claspy==0.2.8
	OMP_NUM_THREADS=1 $(BIN)/python tests/benchmarks/compare --claspy .venv-claspy/bin/python $(COMPARE)

wheel: $(VENV)/ready-to-test
	$(BIN)/python -m build --wheel

clean:
	rm -rf $(VENV) $(PICTURES) node_modules dist build

define environment
@test -n "$(PYTHON)" || { echo "keyphase needs Python 3.11 or newer; on Debian: apt-get install python3 python3-venv"; exit 1; }
@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || { echo "keyphase needs Python 3.11 or newer, but $(PYTHON) is older; run make PYTHON=/path/to/python3.11"; exit 1; }
test -x $(BIN)/python || $(PYTHON) -m venv $(VENV)
endef

INSTALL := $(BIN)/python -m pip install --quiet --no-compile --disable-pip-version-check --constraint constraints.txt --editable

$(VENV)/ready-to-run: pyproject.toml constraints.txt
	$(environment)
	$(INSTALL) .
	@touch $@

$(VENV)/ready-to-test: pyproject.toml constraints.txt
	$(environment)
	$(INSTALL) '.[dev]'
	@touch $(VENV)/ready-to-run $@
