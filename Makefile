# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
#
# The front door: `make help` lists what there is. CMake does the building; the recipes here only
# chain its steps, and none of them does work twice.

MAKEFLAGS += --no-print-directory
.DEFAULT_GOAL := help

# DATASET is a recorded sequence for `make demo`; empty = a synthetic room. Likewise for `make
# reproduce-paper`; empty = fr1/rpy.
DATASET ?=
# OUT is where `make demo` and `make reproduce-paper` leave their files.
OUT ?= results/demo
# PREFIX is where `make install` puts the program and the libraries.
PREFIX ?= /usr/local
# One compiler process needs up to 1.5 GB (Eigen): no more of them than fit in memory.
ifndef JOBS
JOBS := $(shell awk -v cpus="$$(nproc)" '/^MemAvailable/ { fit = int($$2 / 1.5e6) } \
          END { print fit < 1 ? 1 : fit < cpus ? fit : cpus }' /proc/meminfo)
endif
ifneq ($(shell command -v ccache),)
export CMAKE_CXX_COMPILER_LAUNCHER ?= ccache
# Without these it stores nothing that reads a precompiled header.
export CCACHE_SLOPPINESS ?= pch_defines,time_macros
endif

PROGRAM := build/release/cvo_slam
ROOM := build/demo/room
PACKAGES := build/.packages-installed
CLANG_FORMATTED = $(shell git ls-files --cached --others --exclude-standard '*.h' '*.cc')

.PHONY: help
help: ## This list
	@awk -F ':.*## ' '/^[a-z-]+:.*## / { printf "  make %-15s %s\n", $$1, $$2 }' $(MAKEFILE_LIST)
	@echo "Variables: DATASET=$(DATASET) OUT=$(OUT) PREFIX=$(PREFIX) JOBS=$(JOBS)"

.PHONY: demo
demo: program $(if $(DATASET),,$(ROOM)/groundtruth.txt) ## Run on a synthetic room, or on DATASET=path
	$(PROGRAM) run "$(or $(DATASET),$(ROOM))" --out "$(OUT)"
	@echo
	@echo "Pictures:"
	@find "$$(realpath "$(OUT)")" \( -name '*.png' -o -name '*.svg' -o -name map.ply \) | sort | sed 's/^/  /'
	@echo
	@echo "All of it on one page:"
	@echo "  $$(realpath "$(OUT)")/report.html"

# Made aside and moved when complete, so that an interrupted run leaves no half a sequence.
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

.PHONY: robustness
robustness: build-release ## Run synthetic worlds and thinned sequences, write docs/results/robustness.md
	bench/run_robustness.sh

.PHONY: pictures
pictures: program $(ROOM)/groundtruth.txt ## Draw the pictures of docs/guide/pictures.md and README.md
	bench/draw_pictures.sh $(PROGRAM) $(ROOM)

# Of fr1/rpy below CVO_SLAM_DATA, or of DATASET; into OUT, by default results/paper.
.PHONY: reproduce-paper
reproduce-paper: OUT = results/paper
reproduce-paper: program ## Draw the three figures of the CVO paper (4 minutes)
	bench/reproduce_paper.sh $(PROGRAM) "$(DATASET)" "$(OUT)"

.PHONY: bench
bench: build-bench ## Micro-benchmarks
	@for program in build/bench/bench/*_bench; do "$$program" || exit 1; done

.PHONY: asan
asan: build-asan ## All tests under the address and undefined-behaviour sanitizers
	ctest --preset asan --parallel $(JOBS)

.PHONY: tsan
tsan: build-tsan ## All tests under the thread sanitizer
	ctest --preset tsan --parallel $(JOBS)

.PHONY: tidy
tidy: needs-clang++ needs-clang-tidy build-tidy ## Compile with clang, clang-tidy on every file

.PHONY: format
format: needs-clang-format ## Format the C++ files
	clang-format -i $(CLANG_FORMATTED)

.PHONY: format-check
format-check: needs-clang-format ## Fail where a C++ file is not formatted
	clang-format --dry-run --Werror $(CLANG_FORMATTED)

.PHONY: install
install: build ## Install the program and the libraries below PREFIX
	cmake --install build/release --prefix "$(PREFIX)"

.PHONY: clean
clean: ## Remove everything that was built (results/ stays)
	rm -rf build

# Steps the targets above share.

.PHONY: program
program: build/release/build.ninja
	cmake --build build/release --target cvo_slam --parallel $(JOBS)

.PHONY: build-%
build-%: build/%/build.ninja
	cmake --build build/$* --parallel $(JOBS)

# Ninja runs CMake again where a CMakeLists.txt changes, but does not know of the presets.
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
	  echo "make: $* is not installed; on Debian: apt-get install clang clang-tidy clang-format" >&2; \
	  exit 1; }
