# Occupancy grid mapping in six languages.
#
#   make all     sets up what is missing, builds every port, maps every scenario with all of them and compares
#   make test    every test there is
#   make bench   how fast the ports are, beside the lesson's programs and mapping libraries
#
# `make help` lists the rest. PYTHON=python3.12 makes .venv with that Python; JOBS=1 does one thing at a time.

SHELL := /bin/bash
.DEFAULT_GOAL := help

JOBS ?= 2
PORTS := python cpp java matlab mathematica web
PARTS := lint python cpp cpp-format java matlab matlab-lint mathematica mathics web bench
# These need the ports as they are built by then.
LAST_PARTS := web-pages compare handouts
LONG_PARTS := mathics-all web-pages-long
ALL_PARTS := $(PARTS) $(LAST_PARTS) $(LONG_PARTS)
BIN := .venv/bin
export PATH := $(CURDIR)/.venv/bin:$(PATH)

# Maven keeps what it downloads in ~/.m2, or here where the home folder (as Java sees it) cannot be written.
ifeq (,$(findstring maven.repo.local,$(MAVEN_OPTS)))
ifneq (yes,$(shell [ -w "$$(getent passwd "$$(id -u)" | cut -d: -f6)" ] && echo yes))
export MAVEN_OPTS += -Dmaven.repo.local=$(CURDIR)/build/m2
endif
endif

clang-format = find cpp/include cpp/src cpp/tests bench -name "*.[ch]pp" -exec clang-format --style=file:cpp/.clang-format $1 {} +
# The wheel's packages as a student's machine sees them; with a cache for each system, as mypy drops that of another one.
mypy-for = mypy --platform $1 --cache-dir .mypy_cache/$1 -p occgrid -p occgrid_parity
SYNC := $(if $(filter output-sync,$(.FEATURES)),--output-sync=target)
# A test's file goes to one worker as a whole: its tests share maps.
WORKERS := -n $(JOBS) --dist loadfile
CPP_TESTS := cmake -S cpp -B cpp/build-tests -DOCCGRID_BUILD_TESTS=ON; cmake --build cpp/build-tests --parallel 2
WEB_PAGES := (cd web && npm ci --silent && node build.mjs ../build/handouts)
BROWSER_TESTS := $(addprefix web/tests/,test_play.py::test_every_scan_has_the_golden_hash \
    test_check.py::test_right_maps_are_identical test_check.py::test_wrong_size_and_missing_scans)
SPEECH := (cd handouts/speech && npm ci --silent)
VERAPDF := mvn -B -ntp -q org.apache.maven.plugins:maven-dependency-plugin:3.8.1:copy \
    -Dartifact=org.verapdf.apps:greenfield-apps:1.28.2 -DoutputDirectory=build/verapdf
CTEST := --output-on-failure --no-tests=error
MVN := mvn -B -ntp -Dstyle.color=never
JDK := openjdk-17-jdk-headless
# The MATLAB sources are held to a style where there is one.
MH_STYLE := $(if $(wildcard matlab/miss_hit.cfg),; mh_style --single matlab)
# The Wolfram tests run on a Wolfram kernel where there is one, else on woxi.
WOLFRAM := $(if $(shell command -v wolframscript),wolframscript,woxi)

##@ Everything

.PHONY: all
all: setup-run  ## Set up, build every port, map every scenario, print the table
	$(BIN)/occgrid-parity run --jobs $(JOBS) --report build/report $(if $(CI),,--allow-skipped)

.PHONY: test
test: setup  ## The tests of everything; ends with a table of what passed
	@scripts/part --start $(PARTS) $(LAST_PARTS)
	@$(MAKE) --no-print-directory -k -j$(JOBS) $(SYNC) $(PARTS:%=run-test-%) || true
	@$(MAKE) --no-print-directory -k -j1 $(LAST_PARTS:%=run-test-%) || true
	@scripts/part --report

.PHONY: test-long
test-long: setup  ## What rarely fails and takes long: other compilers, flags and systems, pages in a browser, starters
	$(BIN)/$(call mypy-for,darwin)
	$(BIN)/occgrid-parity build --jobs $(JOBS)
	PARITY_ALL_CASES=1 $(BIN)/pytest $(WORKERS) -m "long or not long" compare/
	(cd web && npm ci --silent); $(SPEECH); $(VERAPDF)
	$(BIN)/pytest $(WORKERS) -c handouts/pytest.ini -m long handouts/tests
	@$(MAKE) --no-print-directory $(LONG_PARTS:%=run-test-%)
	$(CPP_TESTS)
	ctest --test-dir cpp/build-tests -R "build_(flags|consumer)" $(CTEST)

.PHONY: same-bits
same-bits:  ## The C++ port on six other kinds of processor, emulated by qemu
	python3 cpp/tests/same_bits.py --install

.PHONY: setup setup-run
setup:  ## Install what is missing: Debian's packages, Python's in .venv
	@PYTHON="$(PYTHON)" scripts/setup
setup-run:
	@PYTHON="$(PYTHON)" scripts/setup run

.PHONY: mutants mutants-sample
mutants: setup-run  ## Change the Python port one small thing at a time: which scenario sees it? Report: build/mutants
	$(BIN)/python -m occgrid_mutants --jobs $(JOBS) $(MUTANTS)
mutants-sample: setup-run  ## The same for changes at random, for five minutes
	$(BIN)/python -m occgrid_mutants --jobs $(JOBS) --minutes 5 $(MUTANTS)

##@ One port

.PHONY: $(PORTS)
$(PORTS): setup-run  ## Build the port
	$(BIN)/occgrid-parity build $@

.PHONY: $(ALL_PARTS:%=test-%)
$(ALL_PARTS:%=test-%): test-%: setup  ## Its tests; also test-lint, test-compare and test-handouts
	@$(MAKE) --no-print-directory run-$@

##@ Course

.PHONY: handouts
handouts: setup  ## Students' and instructors' handouts in build/handouts; PARTIAL=1 goes on where a part cannot be made
	$(BIN)/occgrid-parity build --jobs $(JOBS) --allow-skipped
	$(WEB_PAGES)
	$(SPEECH)
	$(BIN)/python handouts/build.py --out build/handouts $(if $(PARTIAL),--partial)

##@ Speed

.PHONY: bench
bench:  ## Measure; BENCH="--quick" in two minutes, BENCH="--help" for the rest. Figures, pictures: build/bench
	@PYTHON="$(PYTHON)" scripts/setup bench
	$(BIN)/python bench/run.py $(BENCH)

##@ Housekeeping

.PHONY: format
format: setup  ## Format the Python, C++ and Java sources
	$(BIN)/ruff check --fix-only .
	$(BIN)/ruff format .
	$(call clang-format,-i)
	cd java && $(MVN) -q formatter:format

.PHONY: wheel
wheel: setup  ## Build the wheel and the source archive in dist/
	rm -rf dist
	PIP_CONSTRAINT=constraints.txt $(BIN)/python -m build

.PHONY: lock
lock:  ## Write constraints.txt anew, with the newest versions that fit
	scripts/lock

.PHONY: clean
clean:  ## Remove what was built; .venv stays
	rm -rf build dist cpp/build* java/target web/node_modules handouts/speech/node_modules .mypy_cache .pytest_cache .ruff_cache
	find python compare handouts bench scripts -name __pycache__ -prune -exec rm -rf {} +

.PHONY: help
help:  ## This list
	@awk -F ':.*## ' '/^##@/ { print "\n" substr($$0, 5) } \
	    /^[^\t#.][^=]*:.*## / { name = $$1; sub(/^\$$\(PORTS\)$$/, "$(PORTS)", name); \
	    sub(/^\$$\(ALL_PARTS.*$$/, "test-PORT", name); printf "  %-36s %s\n", name, $$2 }' Makefile

# The parts of the tests: name, what it needs, commands. `make test` runs LAST_PARTS one after the other, after all
# others side by side. A part whose tools are missing is skipped, or fails where CI is set.

.PHONY: $(ALL_PARTS:%=run-test-%)

run-test-lint:
	@scripts/part lint 'ruff mypy' 'ruff check .; ruff format --check .; \
	    mypy$(foreach tests,$(wildcard python/tests compare/tests handouts/tests bench/tests web/tests),; mypy $(tests)); \
	    $(call mypy-for,win32)'

run-test-python:
	@scripts/part python 'pytest' 'pytest python/tests'

run-test-cpp:
	@scripts/part cpp 'g++ cmake' '$(CPP_TESTS); ctest --test-dir cpp/build-tests -E "build_(flags|consumer)" $(CTEST)'

run-test-cpp-format:
	@scripts/part cpp-format 'clang-format' '$(call clang-format,--dry-run -Werror)'

run-test-java:
	@scripts/part java 'javac=$(JDK) mvn=maven' 'cd java; $(MVN) verify'

run-test-matlab:
	@scripts/part matlab 'octave-cli=octave' 'occgrid-parity build matlab; \
	    octave-cli --no-history --norc --quiet matlab/tests/run_tests.m'

run-test-matlab-lint:
	@scripts/part matlab-lint 'mh_lint=miss_hit' 'mh_lint --single matlab$(MH_STYLE)'

run-test-mathematica:
	@scripts/part mathematica '$(WOLFRAM)' 'occgrid-parity build mathematica; sh mathematica/wolfram.sh mathematica/tests/run_tests.wls; \
	    sh mathematica/tests/command.sh; sh mathematica/tests/readme.sh'

# Contexts, noise and one beam; all that Mathics can run takes minutes.
run-test-mathics:
	@scripts/part mathics 'python3' 'sh mathematica/tests/run_mathics.sh Noise Mapper'

run-test-mathics-all:
	@scripts/part mathics-all 'python3' 'sh mathematica/tests/run_mathics.sh'

run-test-web:
	@scripts/part web 'node=nodejs npm' 'cd web; npm ci --silent; npm run --silent types; npm run --silent lint; npm test'

run-test-web-pages:
	@scripts/part web-pages 'node=nodejs npm pytest' '$(WEB_PAGES); \
	    $(if $(CI),PARITY_REQUIRE_ALL=1 )pytest -c web/tests/pytest.ini $(BROWSER_TESTS)'

run-test-web-pages-long:
	@scripts/part web-pages-long 'node=nodejs npm pytest' '$(WEB_PAGES); pytest -c web/tests/pytest.ini $(WORKERS) web/tests'

run-test-bench:
	@scripts/part bench 'pytest' 'pytest bench/tests'

run-test-compare:
	@scripts/part compare 'pytest' '$(if $(CI),PARITY_REQUIRE_ALL=1 )pytest $(WORKERS) -m "not long" compare/'

run-test-handouts:
	@scripts/part handouts 'pytest node=nodejs npm' 'occgrid-parity build --jobs 1 --allow-skipped; \
	    (cd web && npm ci --silent); $(SPEECH); \
	    $(if $(CI),PARITY_REQUIRE_ALL=1 )pytest $(WORKERS) -c handouts/pytest.ini -m "not long" handouts/tests'
