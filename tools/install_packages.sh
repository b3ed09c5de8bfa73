#!/bin/sh
# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
#
# install_packages.sh <list>: installs the Debian packages of a list (a name a line, '#' starts a
# comment) that are not installed yet. Says what it does first; sudo only where not root.
set -eu

missing() {
  sed 's/#.*//' "$1" | while read -r package; do
    [ -n "$package" ] || continue
    status=$(dpkg-query --show --showformat '${db:Status-Status}' "$package" 2> /dev/null || true)
    [ "$status" = installed ] || printf '%s ' "$package"
  done
}

if ! command -v apt-get > /dev/null; then
  echo "No apt-get here: install the counterparts of the packages in $1 yourself." >&2
  exit 0
fi
packages=$(missing "$1")
[ -n "$packages" ] || exit 0

as_root=
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo > /dev/null || {
    echo "make: neither root nor sudo; ask your administrator for: apt-get install $packages" >&2
    exit 1
  }
  as_root=sudo
fi
echo "Installing Debian packages${as_root:+ with sudo}: $packages"
# The list is words on purpose.
# shellcheck disable=SC2086
{
  $as_root apt-get update --quiet=2
  $as_root env DEBIAN_FRONTEND=noninteractive \
    apt-get install --yes --quiet --no-install-recommends $packages
}
