#!/bin/bash
# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
#
# completion_test.sh <program>: what bash proposes while a command line is typed.
set -eu

program=$1
. "$(dirname "$0")/../../apps/cvo_slam.bash"
faults=0

# expect <line as far as it is typed> <proposals>...
expect() {
  local line=$1
  shift
  read -ra COMP_WORDS <<< "$program $line"
  [[ $line != *" " && -n $line ]] || COMP_WORDS+=("")
  COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
  COMPREPLY=()
  _cvo_slam
  [[ "${COMPREPLY[*]}" == "$*" ]] && return
  echo "completion_test.sh: '$line': expected '$*', got '${COMPREPLY[*]}'" >&2
  faults=1
}

expect '' run eval align info synth optimize vocab render bench
expect 'r' run render
expect 'bench ' odometry variants
expect 'run --mo' --mode
expect 'run --mode ' odometry graph slam
expect 'run --mode g' graph
expect 'run folder --fo' --follow
expect 'run --vocabulary /a/b' # a file: bash's own
exit $faults
