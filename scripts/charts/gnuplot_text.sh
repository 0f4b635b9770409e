# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash
# Names reach gnuplot as data (sourced). Within single quotes nothing is a command, an escape or a variable.

# gnuplot_text TEXT: a string of gnuplot's that stands for the text; bytes that are no text are left out.
gnuplot_text() {
  local text
  text=$(printf '%s' "$1" | tr '\001-\037\177' ' ' | iconv -f UTF-8 -t UTF-8 -c || true)
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
