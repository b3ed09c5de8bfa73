# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Completion of cvo_slam's command line for bash. It reads the help page of the command that is being
# typed, so that it knows what the program knows.

_cvo_slam() {
  local word=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]}
  local -a command=()
  local i help values=
  for ((i = 1; i < COMP_CWORD; ++i)); do
    [[ ${COMP_WORDS[i]} =~ ^[a-z]+$ ]] || break
    command+=("${COMP_WORDS[i]}")
  done
  help=$("${COMP_WORDS[0]}" "${command[@]}" --help 2> /dev/null) || return 0
  # The words that an option takes: "--mode TEXT:{odometry,graph,slam}".
  [[ $previous != -* ]] || values=$(sed -n "s/^ *\(-., *\)\{0,1\}$previous TEXT:{\([^}]*\)}.*/\2/p" <<< "$help")
  if [[ -n $values ]]; then
    mapfile -t COMPREPLY < <(compgen -W "${values//,/ }" -- "$word")
  elif [[ $word == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$(grep -oE '^  .{0,3}--[a-z-]+' <<< "$help" |
      grep -oE -- '--[a-z-]+')" -- "$word")
  elif [[ $help == *Subcommands:* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$(sed '1,/^Subcommands:/d' <<< "$help" |
      sed -n 's/^  \([a-z]\{1,\}\) .*/\1/p')" -- "$word")
  fi
}
complete -o default -F _cvo_slam cvo_slam
