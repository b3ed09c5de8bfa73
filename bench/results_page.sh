#!/bin/sh
# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
#
# What the scripts that write docs/results/ have in common; they read this file with `.` in the root
# of the checkout. Figures belong to a revision, so the scripts refuse a tree with changes (exit code
# 2); only the pages and pictures themselves may differ.

if ! changes=$(git status --porcelain -- . ':!docs/results' ':!docs/images'); then
  echo "$(basename "$0"): not in a git checkout, so there is no revision to name" >&2
  exit 2
elif [ -n "$changes" ]; then
  echo "$(basename "$0"): the working tree has changes; commit them first: a page of results names" \
    "its revision" >&2
  exit 2
fi

# Fails with one line if a program is not there: its path, the command that builds it.
require_program() {
  [ -x "$1" ] || {
    echo "$(basename "$0"): $1 is not built; run '$2' first" >&2
    exit 1
  }
}

# The head of a page: title, command that writes it, what the page shows.
begin_page() {
  model=$(sed -n 's/^model name[^:]*: *//p' /proc/cpuinfo | head -n 1)
  cat << END
# $1

Written by \`$2\`; do not edit. $3

- CPU: ${model:-unknown}, $(nproc) of them
- date: $(date -u +%Y-%m-%d)
- revision: $(git describe --always)
END
}

# The value of a key of a report.json, from the lines of tools/json_lines.awk on stdin: key, factor,
# format, and for relative errors the unit of the distance ("s", "frames"), as there are several.
json_figure() {
  awk -F '\t' -v key="$1" -v factor="$2" -v format="$3" -v wanted="${4:-}" '
    $1 == "evaluation.rpe.unit" { gsub(/"/, "", $2); unit = $2 }
    $1 == key && (wanted == "" || wanted == unit) { printf format, factor * $2; printed = 1; exit }
    END { if (!printed) printf "-" }'
}
