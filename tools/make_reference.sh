#!/bin/sh
# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
#
# make_reference.sh [--check] [program]
#
# Writes docs/reference/command-line.md and docs/reference/options.md from what the built program
# (default: build/release/cvo_slam) says of itself. With --check it writes nothing and fails, one
# line for each fault, if
#   - one of the two pages is not what the program says now,
#   - docs/reference/files.md does not list exactly the files, columns and keys that a run writes,
#   - a page for users names an option of `--set` that does not exist, or
#   - the world file in docs/reference/synthetic-worlds.md cannot be read.
set -eu

check=
[ "${1:-}" != --check ] || { check=yes; shift; }
[ $# -eq 0 ] || set -- "$(realpath "$1")"
cd "$(dirname "$0")/.."
program=${1:-build/release/cvo_slam}
reference=docs/reference
[ -x "$program" ] || {
  echo "make_reference.sh: $program is not built; run 'make program' first" >&2
  exit 1
}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
faults=$work/faults
: > "$faults"

# --- command-line.md -----------------------------------------------------------------------------

. tools/help_pages.sh

# Section and help text of a command: its words.
document_command() {
  printf '\n## cvo_slam%s\n\n```\n' "${1:+ $1}"
  help_of "$1"
  printf '```\n'
}

write_command_line() {
  cat << 'END'
# The command line

Written by `tools/make_reference.sh` from the program's own help pages; do not edit. What the
commands are for is in the [guide](../guide/first-run.md), their options of the form `key=value` are
in [options.md](options.md), and the files of a run in [files.md](files.md).

| exit code | meaning |
|---|---|
| 0 | done |
| 1 | failed |
| 2 | wrong usage or wrong input |
| 3 | `run`: tracking was lost for more than the share of frames that `--max-lost` allows; `align`: the result is not good enough for tracking |
| 130, 143 | interrupted or terminated; what was there has been written |

An error is one line on stderr that says what is wrong, where, and what to do.
END
  each_command document_command
}

# --- options.md ----------------------------------------------------------------------------------

# Reads a configuration that --dump-config printed and prints a line an option: key, default,
# permitted values, text, with tabs between. Keys are dotted, lines of comments are joined, and the
# last comment line, in square brackets, holds the permitted values.
list_options() {
  awk '
    /^ *#/ {
      sub(/^ *# ?/, "")
      if (allowed != "") text = text (text == "" ? "" : " ") allowed
      allowed = ""
      if (/^\[.*\]$/) allowed = substr($0, 2, length($0) - 2)
      else text = text (text == "" ? "" : " ") $0
      next
    }
    /^ *[a-z_0-9]+:/ {
      match($0, /^ */)
      depth = RLENGTH / 2
      name = $0
      sub(/^ */, "", name)
      value = name
      sub(/:.*/, "", name)
      sub(/^[^:]*: */, "", value)
      path[depth] = name
      if (value != "") {
        key = path[0]
        for (i = 1; i <= depth; ++i) key = key "." path[i]
        gsub(/\|/, "\\|", text)
        printf "%s\t%s\t%s\t%s\n", key, value, allowed, text
      }
      text = allowed = ""
    }'
}

# Tables of options, one for each group of keys: a list of options on stdin, and how many words of a
# key make its group.
option_tables() {
  awk -F '\t' -v words="$1" '
    {
      n = split($1, word, ".")
      group = word[1]
      for (i = 2; i <= words && i < n; ++i) group = group "." word[i]
      if (group != last) {
        printf "\n### %s\n\n| option | default | unit; permitted | what it is |\n|---|---|---|---|\n", group
      }
      last = group
      printf "| `%s` | `%s` | %s | %s |\n", $1, $2, $3, $4
    }'
}

# The sensor presets side by side: the options of `synth` in which they differ.
preset_table() {
  # shellcheck disable=SC2016  # Markdown's quotes
  printf '| option | `none` | `kinect` | `harsh` |\n|---|---|---|---|\n'
  for preset in none kinect harsh; do
    "$program" synth --noise "$preset" --dump-config | list_options | cut -f 1,2 > "$work/$preset"
  done
  paste "$work/none" "$work/kinect" "$work/harsh" |
    awk -F '\t' '$2 != $4 || $2 != $6 { printf "| `%s` | %s | %s | %s |\n", $1, $2, $4, $6 }'
}

write_options() {
  "$program" run --dump-config | list_options > "$work/run_options"
  "$program" synth --dump-config | list_options > "$work/synth_options"
  cat << 'END'
# Options

Written by `tools/make_reference.sh` from the program's own options; do not edit. Set an option with
`--set key=value`, or all of them with `--config file.yaml`; `cvo_slam run --dump-config` prints such
a file with the same texts. `cvo_slam run` writes the options that were in effect to `config.yaml`.

## Options of run, align and bench odometry
END
  grep -v '^expert\.' "$work/run_options" | option_tables 2
  if grep -q '^expert\.' "$work/run_options"; then
    cat << 'END'

## Options for experts

The results do not get better by changing these without a measurement; they are here for experiments.
END
    grep '^expert\.' "$work/run_options" | option_tables 3
  fi
  cat << 'END'

## Options of synth

The simulated sensor; [synthetic-sensor.md](synthetic-sensor.md) has the formulas. `--noise` chooses
the preset to start from:

END
  preset_table
  option_tables 2 < "$work/synth_options"
}

# --- Checks --------------------------------------------------------------------------------------

# The entries in backquotes of the first column of the table below a heading of files.md.
documented() {
  awk -v heading="## $1" '
    /^## / { inside = ($0 == heading) }
    inside && /^\| `/ { split($0, part, "`"); print part[2] }' "$reference/files.md"
}

# Reports what only one of two lists has: title, list of the page, list of the program.
compare_lists() {
  sort -u "$2" > "$work/page_list"
  sort -u "$3" > "$work/program_list"
  comm -23 "$work/page_list" "$work/program_list" |
    sed "s|^|$reference/files.md: $1: no run writes this any more: |" >> "$faults"
  comm -13 "$work/page_list" "$work/program_list" |
    sed "s|^|$reference/files.md: $1: not documented: |" >> "$faults"
}

# The keys of a report as dotted paths, without those that only hold others. Left out is what is below
# "options", the keys of options.md, and below the statistics of errors, which files.md explains once.
json_keys() {
  awk -f tools/json_lines.awk "$1" | cut -f 1 |
    grep -v -e '^options\.' -e 'translation_m\.' -e 'rotation_deg\.' | sort -u |
    awk '
      last != "" && index($0, last ".") != 1 { print last }
      { last = $0 }
      END { print last }'
}

check_run_files() {
  if ! { "$program" synth room "$work/room" --frames 40 --size 160x120 &&
    "$program" run "$work/room" --mode slam --quiet --out "$work/out"; } > "$work/log" 2>&1; then
    sed 's/^/make_reference.sh: the run for the check failed: /' "$work/log" >> "$faults"
    return 0
  fi
  # The pictures of loops are in a folder that only runs with a recognised place have.
  documented 'The folder of a run' | grep -v '/$' > "$work/documented"
  ls "$work/out" > "$work/written"
  compare_lists 'The folder of a run' "$work/documented" "$work/written"
  for table in frames.csv loops.csv; do
    documented "$table" > "$work/documented"
    head -n 1 "$work/out/$table" | tr ',' '\n' > "$work/written"
    compare_lists "$table" "$work/documented" "$work/written"
  done
  documented report.json > "$work/documented"
  json_keys "$work/out/report.json" > "$work/written"
  compare_lists report.json "$work/documented" "$work/written"
}

# Every `--set key=value` of the pages for users.
check_option_names() {
  cut -f 1 "$work/run_options" "$work/synth_options" | sort -u > "$work/keys"
  grep -rno -e '--set [a-z_0-9.]*=' README.md docs/guide docs/theory docs/reference |
    while IFS=: read -r page line setting; do
      key=${setting#--set }
      case ${key%=} in key | *.key) continue ;; esac
      grep -qxF "${key%=}" "$work/keys" ||
        echo "$page:$line: there is no option ${key%=}" >> "$faults"
    done
}

check_world_file() {
  awk '/^```yaml/ { inside = 1; next } /^```/ { inside = 0 } inside' \
    "$reference/synthetic-worlds.md" > "$work/world.yaml"
  "$program" synth "$work/world.yaml" --dump-world "$work/again.yaml" > "$work/log" 2>&1 ||
    sed "s|^|$reference/synthetic-worlds.md: |" "$work/log" >> "$faults"
}

# --- Write or check ------------------------------------------------------------------------------

write_command_line > "$work/command-line.md"
write_options > "$work/options.md"
for page in command-line.md options.md; do
  if [ -z "$check" ]; then
    cp "$work/$page" "$reference/$page"
  elif ! cmp -s "$work/$page" "$reference/$page"; then
    echo "$reference/$page is not what the program says; run tools/make_reference.sh" >> "$faults"
  fi
done
[ -n "$check" ] || exit 0
check_run_files
check_option_names
check_world_file
[ -s "$faults" ] || exit 0
cat "$faults" >&2
exit 1
