# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
#
# A minimal Debian 12 in a folder, for scripts that read this file with `.`.

# make_root [folder]: makes it (in a temporary folder that is removed at the end, if none is named;
# one that is named is kept, and used again next time with what is installed there), and sets $root.
make_root() {
  me=$(basename "$0")
  [ "$(id -u)" -eq 0 ] || { echo "$me: needs root" >&2; exit 1; }
  command -v debootstrap > /dev/null || {
    echo "$me: needs debootstrap: apt-get install debootstrap" >&2
    exit 1
  }
  case ${1:-} in
    -*) echo "usage: $me [folder]" >&2; exit 2 ;;
  esac
  keep=${1:-}
  root=${1:-$(mktemp -d)}
  trap clean_up_root EXIT
  trap 'exit 130' INT TERM
  if [ ! -e "$root/etc/debian_version" ]; then
    debootstrap --variant=minbase bookworm "$root" http://deb.debian.org/debian
  fi
  mountpoint --quiet "$root/proc" || mount -t proc proc "$root/proc"
  mountpoint --quiet "$root/dev" || {
    mount --rbind /dev "$root/dev" && mount --make-rslave "$root/dev"
  }
  cp /etc/resolv.conf "$root/etc/resolv.conf"
  inside apt-get update --quiet=2
}

clean_up_root() {
  for folder in proc dev; do
    ! mountpoint --quiet "$root/$folder" || umount --recursive "$root/$folder"
  done
  # One file system only: should something still be mounted here, it is not deleted.
  [ -n "$keep" ] || rm -rf --one-file-system "$root"
}

# Runs a command in it.
inside() { chroot "$root" /usr/bin/env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin "$@"; }
