# make run    opens the application on the built-in demo shot (without a display: tracks the demo and says so)
# make test   runs every check; each target may be the first command on a fresh machine
# make translations   takes the window's texts out of the code, and compiles what is translated
# make wheel  makes the wheel; make bundle: ROAM with all it needs in one archive, for machines without Python
# make docs   makes the reference of the library from its docstrings
PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
READY := $(VENV)/.ready
MADE_IN := $(shell cat $(READY) 2>/dev/null)
FRESH :=

# What is installed in .venv names the folder that it was installed in, and is for the Python that it was made with: where
# that was moved or renamed, or this one is another by now or gone (a new release of Debian, Homebrew), it is made anew.
ifneq "$(MADE_IN)" ""
WORKS := $(shell $(BIN)/python -c 'import pip' >/dev/null 2>&1 && echo yes)
ifneq "$(MADE_IN) $(WORKS)" "$(CURDIR) yes"
FRESH := yes
.PHONY: $(READY)
endif
endif

.PHONY: run test setup lint bench docs screenshots translations wheel bundle clean

setup: $(READY)

$(READY): pyproject.toml constraints.txt scripts/system-libraries
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || { echo "ROAM needs Python 3.11 or newer: make setup PYTHON=python3.11"; exit 1; }
	@scripts/system-libraries --test
	@$(PYTHON) -c 'import ensurepip' 2>/dev/null || { echo "Python's venv module is missing: sudo apt-get install python3-venv"; exit 1; }
	@{ test -z "$(FRESH)" && test -x $(BIN)/python; } || $(PYTHON) -m venv --clear $(VENV)
	@echo "Installing ROAM and its libraries into $(VENV) ..."
	@$(BIN)/python -m pip install --quiet --disable-pip-version-check --constraint constraints.txt --editable '.[window,docs,dev,studio]'
	@echo "$(CURDIR)" > $(READY)

run: setup
	@$(BIN)/roam demo

lint: setup
	$(BIN)/ruff check .
	$(BIN)/mypy
	$(BIN)/lint-imports

test: setup
	$(BIN)/python -m scripts.run_tests

bench: setup
	$(BIN)/python -m benchmarks

docs: setup
	$(BIN)/sphinx-build --quiet --fail-on-warning --keep-going docs/reference build/reference
	@echo "The reference of the library: build/reference/index.html"

screenshots: setup
	$(BIN)/python -m scripts.screenshots

translations: setup
	$(BIN)/python -m scripts.translations

wheel: setup
	$(BIN)/python -m pip wheel --quiet --disable-pip-version-check --no-deps --no-build-isolation --wheel-dir dist .

bundle: setup
	$(BIN)/python -m bundle

clean:
	rm -rf $(VENV) build dist *.egg-info
