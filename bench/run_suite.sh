#!/bin/sh
# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
#
# run_suite.sh [arguments of snakemake]
#
# Runs the suite (bench/suite/README.md) and writes docs/results/suite.md, .csv and .json. What was done
# for this revision is not done again.
#
#   NAME    of the page (default suite); NAME=low-rates goes with --config set=low_rates
#   TITLE   of the page (default "Accuracy and its spread")
set -eu

cd "$(dirname "$0")/.."
. bench/results_page.sh
command -v snakemake > /dev/null || {
  echo "run_suite.sh: snakemake is missing; install the packages of bench/suite/packages.txt" >&2
  exit 1
}
log=$(mktemp)
trap 'rm -f "$log"' EXIT
snakemake -s bench/suite/Snakefile --cores all --quiet "$@" > "$log"
made=$(sed -n 's/^suite: wrote \(.*\)\.md$/\1/p' "$log")
name=${NAME:-suite}
for kind in csv json; do cp "$made.$kind" "docs/results/$name.$kind"; done
{
  begin_page "${TITLE:-Accuracy and its spread}" "make $name" \
    "The figures are also in $name.csv and $name.json."
  echo
  cat "$made.md"
} > "docs/results/$name.md"
