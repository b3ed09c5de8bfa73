#!/bin/sh
# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
#
# make_man_page.sh [program]
#
# Prints the manual page cvo_slam(1), made of the help pages of the built program (default:
# build/release/cvo_slam).
set -eu

program=${1:-build/release/cvo_slam}
. "$(dirname "$0")/help_pages.sh"

# Text as it is, for a block without filling.
verbatim() { sed -e 's/\\/\\e/g' -e "s/^\([.']\)/\\\\\&\1/" -e 's/-/\\-/g'; }

section_of() {
  printf '.SH CVO_SLAM%s\n.nf\n' "${1:+ $(echo "$1" | tr '[:lower:]' '[:upper:]')}"
  help_of "$1" | verbatim
  printf '.fi\n'
}

version=$("$program" --version)
printf '.TH CVO_SLAM 1 "" "cvo_slam %s" "User Commands"\n' "${version##* }"
cat << 'END'
.SH NAME
cvo_slam \- RGB-D SLAM with Continuous Visual Odometry
.SH SYNOPSIS
.B cvo_slam
.I command
[\fIoption\fR]... [\fIfile\fR]...
.SH EXIT STATUS
.TP
0
done
.TP
1
failed
.TP
2
wrong usage or wrong input
.TP
3
.BR run :
tracking was lost for more frames than
.B \-\-max\-lost
allows;
.BR align :
the result is not good enough for tracking
.TP
130, 143
interrupted or terminated; what was there has been written
.PP
An error is one line on stderr that says what is wrong, where, and what to do.
END
each_command section_of
