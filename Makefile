# Every step that CI takes, by the name a person would use.
VENV := .venv
BIN := $(VENV)/bin
PYTHON ?= python3
NOTEBOOKS := $(sort $(wildcard book/*.ipynb book/further/*.ipynb book/exercises/*.ipynb))
HTML := book/_build/html
# Each file of these folders may change a page. What a build writes there is no source.
SOURCES := $(shell find book helpers answers tools -type f -not -path 'book/_build/*' -not -path 'book/answers/*' \
  -not -path '*/.*' -not -path '*/__pycache__/*' 2>/dev/null)

# Where this is set, as in many containers, every process compiles SymPy and the tests anew: 3 s of each.
unexport PYTHONDONTWRITEBYTECODE

.PHONY: help book pdf lite release test notebooks elsewhere changed lab refresh lint lock bench clean bundles sheet coverage screenshots

help: ## list the targets
	@grep -E '^[a-z]+:.*##' $(MAKEFILE_LIST) | sed -E 's/:.*## /\t/' | expand -t 12

# A .venv without a pip that runs is half made, for instance where python3-venv was missing: it is made anew.
# Bytecode is left to the first import, since most of what is installed is never imported.
PIP := $(BIN)/python -m pip install --quiet --disable-pip-version-check --no-compile -c requirements.lock

# uv unpacks with all processors what pip does with one, in a third of the time; where it is not to be had, pip does it.
INSTALL = { $(PIP) uv==0.13.9 && $(BIN)/python -m uv pip install --quiet --python $(BIN)/python -c requirements.lock $(1); } 2>/dev/null || $(PIP) $(1)

$(BIN)/.installed: requirements.txt requirements.lock pyproject.toml
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11) and "Python 3.11 or newer is needed; say make PYTHON=python3.12, for instance")'
	@$(BIN)/python -m pip --version >/dev/null 2>&1 || $(PYTHON) -m venv --clear $(VENV) || \
	  { rm -rf $(VENV); echo "$(PYTHON) cannot make a virtual environment; on Debian and Ubuntu: sudo apt install python3-venv"; exit 1; }
	$(call INSTALL,-r requirements.txt)
	@touch $@

$(BIN)/.installed-dev: $(BIN)/.installed requirements-dev.txt
	$(call INSTALL,-r requirements-dev.txt)
	@touch $@

# Sphinx warns of a page only when it writes it: where the last build failed or broke off, every page is built anew,
# until one build has nothing to warn of; and where more than pages changed, of which Sphinx knows nothing.
# The stamp has the time at which the build began: a file edited meanwhile is newer, and is built next time.
BOOK := $(HTML)/.whole

$(BOOK): $(BIN)/.installed $(SOURCES)
	@rm -f $@ && mkdir -p $(HTML) && touch $@.begun
	$(BIN)/jupyter-book build book -W -n --keep-going --quiet $(if $(wildcard $@),$(if $(filter-out $(wildcard book/*.* book/exercises/*.* book/further/*.*),$?),--all),--all)
	@mv $@.begun $@

book: $(BOOK) ## build the book and say where it is
	@echo "The book: $(CURDIR)/$(HTML)/index.html"
	@$(BIN)/python -c 'import pathlib; print(pathlib.Path("$(HTML)/index.html").resolve().as_uri())'

# The book is built while the tests are installed and the notebooks run; what looks at it waits for this file, which
# says how that ended. Meanwhile SymPy is compiled once, and not by every process of the tests at its start. Three files
# at a time on two processors, since who looks at pages often waits for them; in the order given: by the number of their
# tests, the longest would come last.
BUILT := book/_build/built

# Other processors round the last digit differently, and no stored output may show it. So the notebooks run in a kernel
# that imitates another processor: OpenBLAS takes its oldest code, and seeded noise changes the results of NumPy and
# Python that OpenBLAS does not compute. JUPYTER_PATH is where Jupyter finds this kernel, and where the kernel finds its
# noise. A stale output fails as it does in a usual kernel, which `make notebooks` takes.
ELSEWHERE := JUPYTER_PATH=$(CURDIR)/tools/elsewhere
NBVAL := --dist loadfile --nbval --nbval-cell-timeout=120

test: $(BIN)/.installed ## run the notebooks, the helpers' tests and the built book's
	@mkdir -p $(dir $(BUILT)) && rm -f $(BUILT)
	{ $(MAKE) --no-print-directory book; echo $$? > $(BUILT); } & \
	$(BIN)/python -c "import sympy, matplotlib.pyplot, ipykernel.kernelapp" & \
	$(MAKE) --no-print-directory $(BIN)/.installed-dev && \
	BUILT=$(BUILT) $(ELSEWHERE) $(BIN)/python -m pytest -n 3 --no-loadscope-reorder $(NBVAL) --nbval-kernel-name=elsewhere $(NOTEBOOKS) tests; \
	tests=$$?; wait; exit $$((tests + $$(cat $(BUILT))))

# Only the tests of the built book are left out. QuickJS judges here, and Node.js in `make test`.
coverage: $(BIN)/.installed-dev ## how much of the helpers the unit tests reach; less than 95 % fails
	JUDGE=quickjs $(BIN)/python -m pytest -n 2 --dist loadfile --cov -q $(filter-out %_book.py,$(wildcard tests/test_*.py))

notebooks: $(BIN)/.installed-dev ## run the notebooks and compare every output with the stored one
	$(BIN)/python -m pytest -n 2 $(NBVAL) --nbval-current-env $(NOTEBOOKS)

elsewhere: $(BIN)/.installed-dev ## the same with the round-off of another processor, as `make test` runs them
	$(ELSEWHERE) $(BIN)/python -m pytest -n 2 $(NBVAL) --nbval-kernel-name=elsewhere $(NOTEBOOKS)

# An hour of processor time; `make test` tries one change in two chapters.
changed: $(BIN)/.installed-dev ## run each notebook with every tenth change of a length, mass or limit of its arms (CHANGES=all: every one, for hours)
	CHANGES=$(or $(CHANGES),tenth) $(BIN)/python -m pytest -n 2 -q tests/test_changed_arms.py

# Pages that notebooks link to; the answer sheets are there once the book was built.
LINKED_PAGES = $(wildcard book/*.md book/answers/*.md)

# A copy that exists may hold the reader's own work and stays.
lab: $(BIN)/.installed ## open your own copies of the notebooks, in the folder my, in JupyterLab
	@mkdir -p my/answers my/further my/exercises && for page in $(NOTEBOOKS) $(LINKED_PAGES); do copy=my/$${page#book/}; test -e $$copy || cp $$page $$copy; done
	@echo "Your copies: $(CURDIR)/my. Delete one, and the next make lab copies it anew."
	$(BIN)/jupyter lab my

refresh: $(BIN)/.installed-dev ## run the notebooks and store their new outputs
	$(BIN)/python -m tools.refresh $(NOTEBOOKS)

lint: $(BIN)/.installed-dev ## check code, notebooks, types and bundles (needs Node.js)
	$(BIN)/pre-commit run --all-files
	$(BIN)/mypy
	npm ci --silent
	npm run lint --silent
	$(BIN)/python -m pytest -q -m npm tests/test_explorer.py

pdf: $(BIN)/.installed-dev $(BOOK) ## print the whole book into one PDF, by Chromium
	$(BIN)/python -m tools.pdf

screenshots: $(BIN)/.installed-dev $(BOOK) ## take the README's pictures anew, by Chromium
	$(BIN)/python -m tools.screenshots

release: pdf ## the book as a zip to read offline, the PDF and the wheel, in dist
	rm -rf dist && mkdir dist
	$(BIN)/python -m pip wheel --quiet --disable-pip-version-check --no-deps --wheel-dir dist .
	cp $(HTML)/book.pdf dist
	cd $(HTML) && ../../../$(BIN)/python -m zipfile -c ../../../dist/book.zip *

lite: ## JupyterLite with the notebooks, in book/_build/lite/site; it runs once it is published
	test -d .venv-lite || $(PYTHON) -m venv .venv-lite
	.venv-lite/bin/python -m pip install --quiet --disable-pip-version-check jupyterlite-core==0.8.6 jupyterlite-pyodide-kernel==0.8.6 jupyter-server
	rm -rf book/_build/lite && mkdir -p book/_build/lite/content
	cp -r book/*.ipynb book/exercises book/further helpers book/_build/lite/content
	find book/_build/lite/content -name __pycache__ -type d -prune -exec rm -r {} +
	cd book/_build/lite && ../../../.venv-lite/bin/jupyter lite build --contents content --output-dir site

bench: ## time the helpers against their peers and write the page of it (3 minutes, an environment of its own)
	test -d .venv-bench || $(PYTHON) -m venv .venv-bench
	.venv-bench/bin/python -m pip install --quiet --disable-pip-version-check -r benchmarks/requirements.txt -e .
	.venv-bench/bin/python benchmarks/bench.py

sheet: $(BIN)/.installed ## the answer sheet of any arm in one HTML file: make sheet ARM="Stanford arm", ARM=my_arm.py:MINE or ARM=arm.urdf ARGS="--tip tool0"
	$(BIN)/python -m answers "$(ARM)" $(ARGS)

bundles: ## bundle the page's scripts and the judge anew from page/ and judge/ (needs Node.js)
	npm ci --silent
	npm run build --silent

lock: ## pin every dependency anew
	$(PYTHON) -m venv .venv-lock
	.venv-lock/bin/pip install --quiet uv
	printf '# Exact versions for every Python from 3.11 on, used as constraints: pip install -r requirements-dev.txt -c requirements.lock\n# Made by `make lock`.\n' > requirements.lock
	.venv-lock/bin/uv pip compile --universal --python-version 3.11 --no-header --no-annotate --no-emit-index-url --quiet requirements-dev.txt | grep -vE '^-e|python.check' >> requirements.lock
	rm -r .venv-lock

clean: ## remove what was built, the environment too; your own copies in my stay
	rm -rf $(VENV) .venv-lock .venv-bench .venv-lite dist build book/_build .pytest_cache .ruff_cache .hypothesis *.egg-info
	find . -name __pycache__ -type d -prune -exec rm -r {} +
