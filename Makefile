# Every target sets up what it needs in .venv; `make` alone lists the targets.
PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
READY := $(VENV)/ready
DEV := $(VENV)/dev
DOCS := $(VENV)/docs
# The tests of a file share what they made: they run in one process.
IN_PARALLEL := -n 2 --dist loadfile
# The heading of the last release. Its tag is the base of `make same`; without one, the commit that dated it.
RELEASE = $(shell sed -n '/^\#\# [0-9.]* ([0-9-]*)$$/{p;q;}' CHANGELOG.md)

# The tests start kurbel a thousand times; what Python has compiled is kept from one to the next.
unexport PYTHONDONTWRITEBYTECODE

.DEFAULT_GOAL := help
.PHONY: help demo handbook test test-all check bench peers docs links playground golden same certify fuzz faults mutants lock tools clean

help: ## list the targets
	@awk -F ':.*## ' '/^[a-z-]+:.*## / { printf "make %-8s %s\n", $$1, $$2 }' $(MAKEFILE_LIST)

# kurbel alone: what the first table needs.
$(READY): pyproject.toml
	$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11) and "kurbel needs Python 3.11 or newer")'
	$(PYTHON) -m venv $(VENV)
	$(BIN)/python -m pip install --quiet --editable .
	touch $(READY)

# What the tests need.
$(DEV): $(READY)
	$(BIN)/python -m pip install --quiet --upgrade 'pip>=25.1'
	$(BIN)/python -m pip install --quiet --editable '.[units,plot,pdf]' --group dev
	touch $(DEV)

# What the site of the documentation needs.
$(DOCS): $(READY)
	$(BIN)/python -m pip install --quiet --upgrade 'pip>=25.1'
	$(BIN)/python -m pip install --quiet --editable '.[units,plot,pdf]' --group docs
	touch $(DOCS)

demo: $(READY) ## print the table for R:L = 1:5
	@$(BIN)/kurbel table --ratio 1:5

handbook: $(READY) ## build the example handbooks, pages/handbook.pdf and .html in examples/appendix and appendix-en
	$(BIN)/python -m pip install --quiet --editable '.[units,plot,pdf]'
	$(BIN)/kurbel handbook build examples/appendix examples/appendix-en

test: $(DEV) check ## run linters, type checks and the tests, in CI all of them
	$(BIN)/python -m pytest $(IN_PARALLEL) $(if $(filter true,$(CI)),,-m 'not slow')

test-all: $(DEV) check ## run the slow tests too
	$(BIN)/python -m pytest $(IN_PARALLEL)

check: $(DEV)
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy
	$(BIN)/lint-imports --no-cache

bench: $(DEV) ## measure kurbel beside its peers, some ten minutes, and write docs/speed.md
	$(BIN)/python -m pip install --quiet --group bench
	$(BIN)/python -m benchmarks --write

peers: $(DEV) ## set one table with kurbel and its peers side by side, docs/gallery/peers/*.png; needs make tools
	$(BIN)/python -m pip install --quiet --group peers
	$(BIN)/python docs/gallery/peers

docs: $(DOCS) ## build the site of the documentation in build/site and manual pages in build/man
	$(BIN)/python docs/generate/schemas.py
	$(BIN)/python docs/generate/front.py
	$(BIN)/python docs/generate/website.py build/site --playground

links: docs ## try the links of the documentation that lead elsewhere; needs a network
	$(BIN)/python -m sphinx -q -b linkcheck -d build/site-read build/site-source build/links

playground: $(DOCS) ## build kurbel for browsers in build/site/playground; needs npm
	$(BIN)/python docs/playground/build.py build/site/playground

golden: $(DEV) ## write anew what pages and golden files print, and show the difference, which is to be read
	KURBEL_PROMOTE=1 $(BIN)/python -m pytest -q $(IN_PARALLEL) tests
	git diff --stat --patch -- tests docs README.md examples/notes.md

same: $(DEV) ## compare what the command lines of scripts/corpus print with the last release, or those of ONLY=^delta
	rm -rf build/base && mkdir -p build/base
	commit=$$(git rev-parse --quiet --verify "v$(word 2,$(RELEASE))^{commit}" || \
		git log --first-parent -m -S'$(RELEASE)' --format=%h -- CHANGELOG.md | tail -1) && \
		echo "the base is $$commit" && git archive "$$commit" | tar -x -C build/base
	PYTHONPATH=$(CURDIR)/build/base/src $(BIN)/python scripts/same_bytes.py record build/base.jsonl --only '$(ONLY)'
	$(BIN)/python scripts/same_bytes.py record build/now.jsonl --only '$(ONLY)'
	$(BIN)/python scripts/same_bytes.py compare build/base.jsonl build/now.jsonl

certify: $(DEV) ## compute N=10000 printed numbers a second time, drawn by SEED=1
	$(BIN)/python scripts/certify.py $(or $(N),10000) --seed $(or $(SEED),1)

fuzz: $(DEV) ## make N=20000 random command lines and damaged files, drawn by SEED=1: each prints or says why not
	$(BIN)/python scripts/fuzz.py $(or $(N),20000) --seed $(or $(SEED),1)

faults: $(DEV) ## kill N=100 runs at random moments, drawn by SEED=1, and disturb others: the same bytes in the end
	$(BIN)/python scripts/faults.py $(or $(N),100) --seed $(or $(SEED),1)

mutants: $(DEV) ## put N=300 faults into the code, drawn by SEED=1, and tell which of them no test sees
	$(BIN)/python scripts/mutants.py $(or $(N),300) --seed $(or $(SEED),1)

# Each library with the hashes of all its files, for every system and from the lowest Python on.
LOCKED := -m uv pip compile --quiet --upgrade --universal --generate-hashes --no-annotate --no-emit-index-url \
	--custom-compile-command 'make lock' --python-version 3.11

lock: $(DEV) ## write the libraries of the action and of CI anew, with their hashes
	echo hatchling | $(BIN)/python $(LOCKED) --extra units --extra plot --extra pdf pyproject.toml - -o requirements/action.txt
	$(BIN)/python $(LOCKED) --all-extras --group dev pyproject.toml -o requirements/ci.txt

tools: $(DEV) ## install TeX, Chromium, poppler, fish, axe and veraPDF, which some tests need (Debian, as root)
	sh scripts/debian-tools.sh
	npm ci --prefix tests --ignore-scripts --no-audit --no-fund
	$(BIN)/python docs/playground/build.py --fetch
	$(BIN)/python -m pip install --quiet --group tools

clean: ## remove what was built
	rm -rf $(VENV) build dist .pytest_cache .mypy_cache .ruff_cache .hypothesis
