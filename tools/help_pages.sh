# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
#
# The help pages of the program, for scripts that read this file with `.` and set $program.

# The help page of a command: its words. The default number of threads is that of the machine, and
# blank lines around the page go.
help_of() {
  # shellcheck disable=SC2086,SC2154  # several words; set by the script
  "$program" $1 --help |
    sed -e 's/\(--threads INT:.*\]\)=[0-9]*$/\1=<processors>/' -e 's/[[:space:]]*$//' |
    sed -e '${/^$/d}'
}

# Calls a function with the words of each command, the program itself ('') first and each followed by
# those below it.
each_command() {
  "$1" "${2:-}"
  for name in $(help_of "${2:-}" |
    awk '/^Subcommands:/ { listed = 1; next } listed && /^  [a-z]/ { print $1 }'); do
    each_command "$1" "${2:+$2 }$name"
  done
}
