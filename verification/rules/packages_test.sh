#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Makes the Debian packages of a build, but for the documentation's, extracts them and uses them from outside: the main case and every
# other, the reference set, man pages, completion, and from outside all C++ packages in one project, with the default compiler and with
# clang++ where there is one, and programs in C, Fortran and Python. usage: packages_test.sh BUILD_DIR
set -euo pipefail
build=$1
project=$(cd "$(dirname "${BASH_SOURCE[0]}")/outside" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
prefix=$scratch/root/usr
data=$prefix/share/gasjet

fail() {
  echo "FAILED: $*"
  exit 1
}

extract_packages() {
  local components package
  components=$(sed -nE 's/^set\(CPACK_COMPONENTS_ALL "(.*)"\)$/\1/p' "$build/CPackConfig.cmake" | sed 's/;docs//')
  (cd "$build" && cpack -G DEB -B "$scratch/packages" -D CPACK_COMPONENTS_ALL="$components" -D CPACK_DEBIAN_COMPRESSION_TYPE=gzip >"$scratch/log" 2>&1) || { cat "$scratch/log"; exit 1; }
  for package in "$scratch"/packages/*.deb; do
    dpkg-deb -x "$package" "$scratch/root"
    package=$(dpkg-deb -f "$package" Package)
    [[ -s $prefix/share/doc/$package/copyright ]] || fail "$package: no copyright"
  done
  [[ $(ls "$scratch/root") == usr ]] || fail "files outside of usr: $(ls "$scratch/root")"
  ! command -v dpkg-shlibdeps >/dev/null || dpkg-deb -f "$scratch"/packages/gasjet_*.deb Depends | grep -q libtbb || fail "the command's libraries are not named"
}

run_cases() {
  local case
  gasjet run "$data/cases/passenger_pendulum.toml" --set scene.end_time=1e-3 --out "$scratch/run" --quiet
  grep -q '"status": "done"' "$scratch/run/summary.json" || fail "the main case does not run"
  for case in "$data"/cases/*.toml "$data"/cases/reference/*.toml; do gasjet check "$case" >/dev/null || fail "$case"; done
  (cd "$data/cases/reference" && sha256sum --quiet --strict -c SHA256SUMS) || fail "the reference set is not whole"
}

# As a stranger has it: no tree, no GASJET, another folder, `gasjet` found beside the script.
judge_a_program() {
  # shellcheck disable=SC2016
  printf '#!/bin/bash\ncp "%s/cases/reference/$(basename "$1" .json).csv" "$2"\n' "$data" >"$scratch/program"
  chmod +x "$scratch/program"
  (cd "$scratch" && env -u GASJET PATH=/usr/bin:/bin "$data/run_external.sh" --scenes tank_fill,plate_jet --out judged ./program)
  grep -q '"verdict": "inside",' "$scratch/judged/report.json" || fail "report of a judgement"
  for schema in scene report; do [[ -s $data/schemas/$schema.schema.json ]] || fail "no schema $schema"; done
}

# options_of COMMAND...: as its --help lists them
options_of() { gasjet "$@" --help | grep -oE '^ +(-[a-z],)?--[a-z-]+' | grep -oE -- '--[a-z-]+'; }
# completed WORD...: what bash offers after these words
completed() {
  bash -c 'source "$1" && COMP_WORDS=("${@:2}") COMP_CWORD=$(($# - 2)) && _gasjet && echo "${COMPREPLY[*]}"' bash \
    "$prefix/share/bash-completion/completions/gasjet" "$@"
}

check_manual() {
  local command option page
  local -a commands
  mapfile -t commands < <(gasjet --help | sed -nE '/^Subcommands:/,/^Exit/s/^  ([a-z]+) .*/\1/p')
  ((${#commands[@]} > 8)) || fail "commands: ${commands[*]}"
  for command in '' "${commands[@]}"; do
    page=$prefix/share/man/man1/gasjet${command:+-$command}.1
    [[ -s $page ]] || fail "no man page of gasjet $command"
    ! command -v man >/dev/null || [[ -z $(man --warnings -l "$page" 2>&1 >/dev/null) ]] || fail "$page is no clean man page"
    for option in $(options_of $command); do
      sed 's/\\-/-/g' "$page" | grep -qE "^.fB${option}.fR" || fail "$page: no $option"
      [[ $(completed gasjet $command "$option") == *$option* ]] || fail "completion: no $option after gasjet $command"
    done
  done
  [[ $(completed gasjet ch) == check ]] || fail "completion of a command: $(completed gasjet ch)"
  [[ $(completed gasjet mesh dri) == driver ]] || fail "completion of a command's command"
  [[ $(completed gasjet check --format "") == "text json keys" ]] || fail "completion of what an option allows"
  [[ -z $(completed gasjet run --out "")$(completed gasjet run "") ]] || fail "files are left to bash"
  grep -q 'Exit.codes: 0 done' "$prefix/share/man/man1/gasjet-run.1" || fail "no exit codes in a man page"
}

# What is not under the GPL works without what is.
without_closed_forms() {
  local module linked
  module=$(find "$prefix/lib" -name '_exact.*.so')
  [[ -n $module ]] || return 0
  [[ $(ldd "$module") == *libgasjet_exact* ]] || fail "_exact does not link libgasjet_exact"
  rm "$module"
  linked=$(ldd "$(find "$prefix/lib" -name '_gasjet.*.so')")
  [[ ! $linked =~ gsl|gasjet_exact|not\ found ]] || fail "python3-gasjet links closed forms, or lacks a library"
  PYTHONPATH=$(dirname "$(dirname "$module")") /usr/bin/python3 -B "$project/consumer.py" --without-exact || fail "python3-gasjet alone"
}

# README's first command is all that the container's image runs; what it builds is there by its name.
check_container() {
  local tree=$project/../../.. command folder
  command=$(awk '/^```sh$/ { getline; print $1; exit }' "$tree/README.md")
  [[ $(sed -n 's/^RUN //p' "$tree/Dockerfile") == "$command" ]] || fail "Dockerfile does not run $command"
  folder=$(sed -n 's/^WORKDIR //p' "$tree/Dockerfile")/$(sed -nE 's|^([a-z/]+)/gasjet run .*|\1|p' "$tree/$command")
  grep -qF "ENV PATH=$folder:" "$tree/Dockerfile" || fail "gasjet is not in the PATH of the Dockerfile: $folder"
}

check_container
extract_packages
PATH=$prefix/bin:$PATH
[[ $(command -v gasjet) == "$prefix/bin/gasjet" ]] || fail "no command"
run_cases
judge_a_program
check_manual
"$project/use.sh" "$prefix" | tee "$scratch/used"
declare -A used_by=([libgasjet-exact]=C [libgasjet-fortran]=Fortran [python3-gasjet-exact]=Python)
for package in "${!used_by[@]}"; do
  [[ ! -d $prefix/share/doc/$package ]] || grep -q "^${used_by[$package]}: .*holds" "$scratch/used" || fail "$package is not used"
done
without_closed_forms
for clang in clang++ clang++-14; do
  if command -v "$clang" >/dev/null; then
    "$project/use.sh" "$prefix" "$clang"
    break
  fi
done
