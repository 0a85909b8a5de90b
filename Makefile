# On a fresh Debian 12 with git and make, as root or with sudo:
#   make build   compile with CMake (build/release/bin/brinell)
#   make test    compile and run all tests: CTest, then pytest
#   make run     install the package into .venv and compute the paper's tugging asperities: results/tugging-paper
# Further: test-mpi, test-cuda, test-all, setup, format, check, tidy, tidy-changed, sanitize, sanitize-fast, sanitize-changed, docs, package, count,
# digits, arm64, bench, bench-cuda, clean. All of them may be repeated; what is done is not redone.

SHELL := /bin/bash
.DEFAULT_GOAL := build
MAKEFLAGS += --no-print-directory

JOBS ?= $(shell nproc)
ALPHAS ?= 1 2 4 6 9#   maximum interferences of `make run`, in critical interferences
CMAKE_ARGS ?=#         more options for CMake, e.g. CMAKE_ARGS=-DBRINELL_WERROR=ON
PYTHONS ?=#            of the wheels of `make package`, e.g. PYTHONS="python3.10 python3.12"; that of .venv by default
BENCH_ARGS ?=#         more options for the benchmarks, e.g. BENCH_ARGS=--benchmark_repetitions=3
BASE ?= HEAD#          the commit with which `make digits` compares, e.g. BASE=origin/main
DIGITS_ARGS ?=#        e.g. DIGITS_ARGS="--within 1e-12 --energies-within 1e-9", where the order of sums has changed
COUNT_ARGS ?=#         --record makes the instructions that `make count` counts the new measure

python := .venv/bin/python
brinell := .venv/bin/brinell
results := results/tugging-paper

.PHONY: build test test-mpi test-cuda test-all run setup format check tidy tidy-ready tidy-changed sanitize sanitize-fast sanitize-changed package arm64 count digits bench bench-cuda docs clean force

# --- Set-up -----------------------------------------------------------------------------------------------------------
setup: build/.setup-packages .venv/.setup-done .venv/.extras-done

build/.setup-packages: tools/setup.sh
	@tools/setup.sh packages
	@mkdir -p build && touch $@

python_sources = pyproject.toml VERSION CMakeLists.txt $(shell find include src apps python/bindings -type f)

.venv/.setup-done: tools/setup.sh $(python_sources) | build/.setup-packages
	@mkdir -p build/release && flock build/release tools/setup.sh python
	@touch $@

.venv/.extras-done: pyproject.toml | .venv/.setup-done
	@flock build/release tools/setup.sh extras
	@touch $@

# --- Build: configured once per preset, later by Ninja itself. The lock keeps two makes out of one build tree. --------
build/%/build.ninja: CMakePresets.json $(if $(CMAKE_ARGS),force) | build/.setup-packages
	cmake --preset $* $(CMAKE_ARGS)
	@touch $@

build: build/release/build.ninja
	flock build/release cmake --build --preset release --parallel $(JOBS)

# --- Test: both runners always run; the status is that of the worse one. Their reports are for tools/ci_times.py. -------
test: .venv/.setup-done .venv/.extras-done build
	@tools/setup.sh test
	@status=0; rm -f build/ctest.xml build/pytest.xml; \
	ctest --preset release --parallel $(JOBS) --label-exclude mpi --output-junit $(CURDIR)/build/ctest.xml || status=1; \
	$(python) -m pytest --numprocesses $(JOBS) --dist worksteal --junitxml build/pytest.xml || status=1; \
	exit $$status

# What several processes compute together. Their program is one more in the same build tree, of the same objects as the other.
test-mpi: .venv/.setup-done .venv/.extras-done build/release/build.ninja
	@tools/setup.sh mpi
	@rm -f build/ctest-mpi.xml
	flock build/release cmake --preset release -D BRINELL_MPI=ON >/dev/null
	flock build/release cmake --build --preset release --parallel $(JOBS) --target brinell_mpi_tests
	@status=0; \
	ctest --preset release --parallel $(JOBS) --label-regex mpi --no-tests=error --output-junit $(CURDIR)/build/ctest-mpi.xml || status=1; \
	$(python) -m pytest --quiet python/tests/test_ranks.py || status=1; \
	exit $$status

# The library for GPUs: compiled without one; tests that need one say so and are skipped. A build tree of its own, so that nothing else
# is configured anew. The program of this tree computes cases on a GPU.
test-cuda: build/.setup-packages
	@tools/setup.sh cuda
	cmake --preset release -B build/cuda-release -D BRINELL_CUDA=ON -D BRINELL_BENCHMARKS=OFF -D BRINELL_WERROR=ON >/dev/null
	flock build/cuda-release cmake --build build/cuda-release --parallel $(JOBS) --target brinell_cuda_tests brinell_cuda_bench brinell_program
	ctest --test-dir build/cuda-release --label-regex '^cuda$$' --no-tests=error --output-on-failure

# Whole what .ci/run does in parts: all cases of random sweeps, the sanitizers on all tests, clang-tidy on all sources.
test-all: export BRINELL_SWEEP = all
test-all: test test-mpi tidy sanitize

# --- The paper's case -------------------------------------------------------------------------------------------------
run: .venv/.setup-done
	@set -e; for alpha in $(ALPHAS); do \
	  echo "alpha* = $$alpha"; \
	  $(brinell) run cases/tugging-paper/case.toml --set tugging.interference=$$alpha \
	    -o $(results)/alpha-$$alpha; \
	done
	@rm -rf $(results)/figures
	@$(brinell) plot paper $(foreach alpha,$(ALPHAS),$(results)/alpha-$(alpha)) -o $(results)/figures
	@$(brinell) plot fields $(results)/alpha-$(lastword $(ALPHAS)) -o $(results)/figures
	@echo "Results: $(results)/alpha-*/{history.csv,summary.json,result.vtkhdf}"
	@echo "Figures: $(results)/figures/*.png"

# --- Quality ----------------------------------------------------------------------------------------------------------
cxx_files = $(shell find include src apps tests bench cuda python/bindings -name '*.[ch]pp' -o -name '*.cu' -o -name '*.cuh')

format: build/.setup-packages .venv/.extras-done
	@clang-format -i $(cxx_files)
	.venv/bin/ruff check --quiet --fix-only python
	.venv/bin/ruff format --quiet python

check: build/.setup-packages .venv/.extras-done
	@clang-format --dry-run -Werror --ferror-limit=1 $(cxx_files) || { echo "'make format' mends it"; exit 1; }
	@echo "format: $(words $(cxx_files)) files"
	@python3 tools/check_layers.py
	@python3 tools/check_comments.py
	@.venv/bin/ruff check --quiet python && .venv/bin/ruff format --quiet --check python || { echo "'make format' mends some of it"; exit 1; }
	@.venv/bin/mypy
	@$(python) tools/render_python.py --check

# Many sources at a time, since most of the time is that of reading headers; then what concerns a file alone, and that it
# compiles alone. tidy-changed compiles what a change touches (tools/changes.py), and reads all files as text.
tidy-ready: build/tidy/build.ninja build/files/build.ninja
	@tools/setup.sh tidy
	@set -e; for preset in tidy files; do flock build/$$preset cmake --build --preset $$preset --target brinell_version; done

run_clang_tidy := run-clang-tidy -quiet -p build/tidy -j $(JOBS) -checks=-bugprone-suspicious-include

tidy: tidy-ready
	$(run_clang_tidy) "/brinell_(numerics|processor|simulation|io|app|program)\.dir/Unity/"
	python3 tools/check_files.py build/files $(JOBS)

tidy-changed: tidy-ready
	@set -e; touched=$$(tools/changes.py unity build/tidy); \
	if [ -n "$$touched" ]; then $(run_clang_tidy) $$touched; fi
	@set -e; touched=$$(tools/changes.py sources 2>/dev/null); \
	python3 tools/check_files.py build/files $(JOBS) --only $$touched

sanitize: build/sanitize/build.ninja
	flock build/sanitize cmake --build --preset sanitize --parallel $(JOBS)
	ctest --preset sanitize --parallel $(JOBS)

# The unit tests that do not compute for long: of all floors, or of those that a change touches and those above.
sanitize-fast: floors = $(notdir $(wildcard tests/unit/*))
sanitize-changed: floors = $(shell tools/changes.py floors)
sanitize-fast sanitize-changed: build/sanitize/build.ninja
	@set -e; floors="$(strip $(floors))"; \
	if [ -z "$$floors" ]; then echo "sanitize: no floor is touched"; exit 0; fi; \
	flock build/sanitize cmake --build --preset sanitize --parallel $(JOBS) \
	  --target $$(printf 'brinell_unit_%s_tests ' $$floors); \
	ctest --preset sanitize --parallel $(JOBS) --timeout 300 --label-exclude long --no-tests=error \
	  -R "^unit\.($${floors// /|})\."

package: build/.setup-packages .venv/.setup-done
	PYTHONS="$(PYTHONS)" tools/package.sh

# The program for 64-bit Arm, by Debian's cross compiler, and a case with it under qemu.
arm64: build
	tools/build_arm64.sh

# Whether the engine works more than it did: instructions of small runs, in the wheel that `make package` has made for every
# processor. COUNT_ARGS=--record makes the counts the new measure.
count: wheels = dist/*$(shell python3 -c 'import sys; v = sys.version_info; print("abi3" if v >= (3, 12) else "cp%d%d-manylinux" % v[:2])')*.whl
count: build/.setup-packages
	tools/setup.sh count
	@ls $(wheels) >/dev/null 2>&1 || { echo "make count: no wheel in dist for this Python; say 'make package' first" >&2; exit 1; }
	python3 -m venv --clear build/count
	build/count/bin/pip install --quiet --disable-pip-version-check $(wheels)
	python3 bench/instructions.py build/count/bin/python $(COUNT_ARGS)

# Whether all cases give the same digits as a commit, with one thread and with two: for changes that are to keep them.
digits: .venv/.setup-done
	$(python) tools/digits.py against $(BASE) $(DIGITS_ARGS)

# One thread, unless OMP_NUM_THREADS says otherwise. bench/record.py appends what is measured to bench/results.csv.
bench: export OMP_NUM_THREADS ?= 1
bench: build
	@mkdir -p build/bench
	@set -e; for program in build/release/bin/bench_*; do \
	  $$program --benchmark_out=build/bench/$$(basename $$program).json --benchmark_out_format=json \
	    --benchmark_context=commit=$$(git describe --always --dirty --abbrev=7) \
	    --benchmark_context=threads=$$OMP_NUM_THREADS $(BENCH_ARGS); \
	done

# On a machine with a GPU.
bench-cuda: test-cuda
	build/cuda-release/bin/brinell_cuda_bench

# --- Documentation: warnings are errors; the tutorials are run --------------------------------------------------------
.venv/.docs-done: docs/requirements.txt .venv/.extras-done
	@.venv/bin/pip install --quiet --disable-pip-version-check -r docs/requirements.txt
	@touch $@

docs: .venv/.docs-done
	@tools/render_command_line.py .venv/bin/brinell docs/reference/command-line.md
	@$(python) -m sphinx -W --keep-going -q -c docs -b html -d build/docs/doctrees . build/docs/html
	@echo "Pages: build/docs/html/index.html"

clean:
	rm -rf build
