# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash
# Sourced by what makes and draws tables: what a table was made on and by, and names as data for gnuplot.

# The first lines of each CSV of docs/charts and docs/figures, which a rule asks for (from the repository's top).
# machine NOTE: the note says how much of it was used; may be empty
machine() { echo "# machine: $(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1), $(nproc) cores${1:+, $1}"; }

# build_version: version, commit, compiler and flags of the program, build/gasjet or $gasjet
build_version() { "${gasjet:-build/gasjet}" --version | sed 's/^/# /'; }

provenance() {
  machine ""
  build_version
}

# Names reach gnuplot as data. Within single quotes nothing is a command, an escape or a variable.
# gnuplot_text TEXT: a string of gnuplot's that stands for the text; bytes that are no text are left out.
gnuplot_text() {
  local text
  text=$(printf '%s' "$1" | tr '\001-\037\177' ' ' | iconv -f UTF-8 -t UTF-8 -c || true)
  text=${text//]]>/]] >} # which ends a part of an SVG file
  printf "'%s'" "${text//\'/\'\'}"
}

# gnuplot_file NAME: the same of a file; a name that begins with < or | would be a command.
gnuplot_file() {
  local name=$1
  if [[ $name == *[[:cntrl:]]* ]]; then
    printf '%s: the name %q has a line break or another control character, which gnuplot cannot read\n' "$(basename -- "$0")" "$name" >&2
    return 2
  fi
  [[ $name == /* ]] || name=./$name
  printf "'%s'" "${name//\'/\'\'}"
}
