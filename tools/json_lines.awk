# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Prints a line for each key of a JSON text that was printed with two spaces a level: its dotted path,
# a tab, and its value, which is "{" or "[" if the key holds others. The entries of a list have the
# path of the list.
/^ *"[^"]*": / {
  match($0, /^ */)
  depth = RLENGTH / 2
  name = $0
  sub(/^ *"/, "", name)
  value = name
  sub(/": .*/, "", name)
  sub(/^[^"]*": /, "", value)
  sub(/,$/, "", value)
  path[depth] = name
  key = ""
  for (i = 1; i <= depth; ++i) if (path[i] != "") key = key (key == "" ? "" : ".") path[i]
  printf "%s\t%s\n", key, value
}
/^ *[\]}{]/ { match($0, /^ */); path[RLENGTH / 2] = "" }
