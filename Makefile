# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
#
# `make help` lists the targets. CMake builds; the recipes here only chain its steps, and none of
# them does work twice.

MAKEFLAGS += --no-print-directory
.DEFAULT_GOAL := help

# DATASET is the recorded sequence that `make demo` and `make reproduce-paper` use; if it is empty,
# they use a synthetic room and fr1/rpy.
DATASET ?=
# OUT is the folder for the files of `make demo` and `make reproduce-paper`.
OUT ?= results/demo
# PREFIX is the folder that `make install` installs the program and the libraries into.
PREFIX ?= /usr/local
# JOBS is the number of compilers at a time: one for each core, and no more than fit in memory (one
# needs up to 1.5 GB).
ifndef JOBS
JOBS := $(shell awk -v cpus="$$(nproc)" '/^MemAvailable/ { fit = int($$2 / 1.5e6) } \
          END { print fit < 1 ? 1 : fit < cpus ? fit : cpus }' /proc/meminfo)
endif
ifneq ($(shell command -v ccache),)
export CMAKE_CXX_COMPILER_LAUNCHER ?= ccache
# Without these settings ccache stores no object that uses a precompiled header.
export CCACHE_SLOPPINESS ?= pch_defines,time_macros
endif

PROGRAM := build/release/cvo_slam
ROOM := build/demo/room
PACKAGES := build/.packages-installed
CLANG_FORMATTED = $(shell git ls-files --cached --others --exclude-standard '*.h' '*.cc')

.PHONY: help
help: ## Show this list
	@awk -F ':.*## ' '/^[a-z-]+:.*## / { printf "  make %-15s %s\n", $$1, $$2 }' $(MAKEFILE_LIST)
	@echo "Variables: DATASET=$(DATASET) OUT=$(OUT) PREFIX=$(PREFIX) JOBS=$(JOBS)"

.PHONY: demo
demo: program $(if $(DATASET),,$(ROOM)/groundtruth.txt) ## Run on a synthetic room, or on DATASET=path
	$(PROGRAM) run "$(or $(DATASET),$(ROOM))" --out "$(OUT)"
	@echo
	@echo "Pictures:"
	@find "$$(realpath "$(OUT)")" \( -name '*.png' -o -name '*.svg' -o -name map.ply \) | sort | sed 's/^/  /'
	@echo
	@echo "Report with everything on one page:"
	@echo "  $$(realpath "$(OUT)")/report.html"

# The sequence is made in another folder and moved when it is complete, so that an interrupted run
# leaves no half of one.
$(ROOM)/groundtruth.txt: $(wildcard synthetic/*.h synthetic/*.cc) | program
	@rm -rf $(ROOM) $(ROOM).part
	@mkdir -p $(@D:%/room=%)
	$(PROGRAM) synth room $(ROOM).part
	@mv $(ROOM).part $(ROOM)

.PHONY: test
test: build ## Build the release preset and run all tests
	ctest --preset release --parallel $(JOBS)

.PHONY: build
build: build-release ## Build the release preset

.PHONY: eval
eval: build-release ## Run the full sequences, write docs/results/benchmarks.md
	bench/run_benchmarks.sh

.PHONY: suite
suite: program ## Run sequences, modes and perturbations, write docs/results/suite.md (bench/suite)
	bench/run_suite.sh

.PHONY: low-rates
low-rates: program ## Run the suite on thinned recordings, write docs/results/low-rates.md
	NAME=low-rates TITLE='Low frame rates' bench/run_suite.sh --config set=low_rates

.PHONY: image-sizes
image-sizes: program ## Run the suite on images from 256x192 to 3840x2160, write their page of results
	NAME=image-sizes TITLE='Sizes of images' bench/run_suite.sh --config set=sizes

.PHONY: depth-clock
depth-clock: program ## Measure known depth offsets, write docs/results/depth-clock.md
	bench/run_depth_clock.sh

.PHONY: cost-of-runs
cost-of-runs: program ## Compare whole runs with reading the files, write docs/results/cost-of-runs.md
	cmake --preset release -DCVO_SLAM_BUILD_BENCH=ON > /dev/null && cmake --build build/release --target read_images
	bench/run_cost_of_runs.py build/release

.PHONY: maps
maps: program ## Measure maps on disk and reading them, write docs/results/maps.md
	cmake --preset release -DCVO_SLAM_BUILD_BENCH=ON > /dev/null && cmake --build build/release --target read_map
	bench/run_maps.sh

.PHONY: foreign-input
foreign-input: program ## Give the program inputs of others, write docs/results/foreign-input.md
	bench/foreign_input.py $(PROGRAM)

.PHONY: localization
localization: build-release ## Locate recordings in maps of others, write docs/results/localization.md
	/usr/bin/python3 bench/localization.py build/release

.PHONY: pictures
pictures: program $(ROOM)/groundtruth.txt ## Draw the pictures of docs/guide/pictures.md and README.md
	bench/draw_pictures.sh $(PROGRAM) $(ROOM)

# Uses fr1/rpy below CVO_SLAM_DATA, or DATASET, and writes into OUT, by default results/paper.
.PHONY: reproduce-paper
reproduce-paper: OUT = results/paper
reproduce-paper: program ## Draw the three figures of the CVO paper (4 minutes)
	bench/reproduce_paper.sh $(PROGRAM) "$(DATASET)" "$(OUT)"

.PHONY: bench
bench: build-bench ## Build and run the micro-benchmarks
	@for program in build/bench/bench/*_bench; do "$$program" || exit 1; done

.PHONY: asan
asan: build-asan ## Run all tests under the address and undefined-behaviour sanitizers
	ctest --preset asan --parallel $(JOBS)

.PHONY: tsan
tsan: build-tsan ## Run all tests under the thread sanitizer
	ctest --preset tsan --parallel $(JOBS)

# The seconds that each fuzzer runs.
FUZZ_SECONDS ?= 60
.PHONY: fuzz
fuzz: needs-clang++ ## Fuzz every parser for FUZZ_SECONDS each (default 60)
	cmake --preset fuzz
	cmake --build --preset fuzz --parallel $(JOBS)
	tools/run_fuzzers.sh build/fuzz/tests/fuzz $(FUZZ_SECONDS)

.PHONY: tidy
tidy: needs-clang++ needs-clang-tidy build-tidy ## Compile with clang and run clang-tidy on every file

.PHONY: format
format: needs-clang-format ## Format the C++ files
	clang-format -i $(CLANG_FORMATTED)

.PHONY: format-check
format-check: needs-clang-format ## Fail if a C++ file is not formatted
	clang-format --dry-run --Werror $(CLANG_FORMATTED)

.PHONY: install
install: build/release/build.ninja ## Build and install the program and the libraries below PREFIX
	cmake --build build/release --target cvo_slam_installed --parallel $(JOBS)
	cmake --install build/release --prefix "$(PREFIX)"

.PHONY: packages
packages: needs-dpkg-shlibdeps build/package/build.ninja ## Make Debian packages in build/package/packages
	cmake --build build/package --target cvo_slam_installed cvo_slam_python --parallel $(JOBS)
	cd build/package && cpack --config CPackConfig.cmake

.PHONY: api
api: needs-doxygen ## Make web pages of the public headers in build/api/html
	@mkdir -p build/api
	doxygen docs/Doxyfile

.PHONY: clean
clean: ## Remove everything that was built (results/ stays)
	rm -rf build

# Steps that the targets above share.

.PHONY: program
program: build/release/build.ninja
	cmake --build build/release --target cvo_slam --parallel $(JOBS)

.PHONY: build-%
build-%: build/%/build.ninja
	cmake --build build/$* --parallel $(JOBS)

# Ninja runs CMake again if a CMakeLists.txt changes, but does not know the presets.
.PRECIOUS: build/%/build.ninja
build/%/build.ninja: CMakePresets.json $(PACKAGES)
	cmake --preset $*
	@touch $@

$(PACKAGES): apt-packages.txt tools/install_packages.sh
	@tools/install_packages.sh apt-packages.txt
	@mkdir -p $(@D)
	@touch $@

.PHONY: needs-%
needs-%:
	@command -v $* > /dev/null || { \
	  echo "make: $* is not installed; on Debian: apt-get install clang clang-tidy clang-format dpkg-dev doxygen" >&2; \
	  exit 1; }
