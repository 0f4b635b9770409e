#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Makes all that a release consists of, from the commit that is checked out, in build/release: source archive, Debian packages,
# reference data, documentation site, SHA256SUMS. Then installs the packages in an empty Debian 12 and uses them there: the main case,
# a judgement by the reference set, programs in C++, C, Fortran and Python. Needs root and network for that.
# usage: scripts/release.sh [--check]     --check: only says whether this commit is fit for a release
# Refuses (exit code 2) a tree with changes that are not committed, versions that differ, and a commit whose tests are red: unless
# scripts/test_all.sh --long has just passed at it, it is run first.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# shellcheck source=tests/debian_root.sh
source scripts/tests/debian_root.sh

refuse() {
  echo "release.sh: $*" >&2
  exit 2
}

if (($# > 1)) || [[ ${1:---check} != --check ]]; then refuse "unknown argument '$*'; allowed: --check"; fi
version=$(sed -nE 's/^set\(GASJET_VERSION ([0-9.]+)\)$/\1/p' cmake/GasjetVersion.cmake)
commit=$(git rev-parse HEAD)

check_tree() {
  local changes tagged
  changes=$(git status --porcelain)
  [[ -z $changes ]] || refuse "what is not committed would be in no release:"$'\n'"$changes"
  ! grep -q '^## Unreleased' CHANGELOG.md || refuse "CHANGELOG.md: 'Unreleased' is to become '$version (date)' first"
  verification/rules/rules.py versions >&2 || refuse "the versions differ"
  tagged=$(git rev-parse -q --verify "v$version^{commit}" || true)
  [[ -z $tagged || $tagged == "$commit" ]] || refuse "v$version is another commit, $tagged: a new release needs a new number"
}

is_green() { [[ -f build/green && $(<build/green) == "$commit fast long sanitize" ]]; }

check_tests() {
  is_green || scripts/test_all.sh --long || refuse "the tests are red"
  is_green || refuse "the tests ran at another commit or left changes behind"
}

release=$PWD/build/release
out=$release.untried # until the packages have worked
scratch=
cleanup() { rm -rf "$scratch"; }

# pack ARCHIVE FOLDER PATH...: the same bytes for the same files
pack() {
  tar --sort=name --mtime="@$(git log -1 --format=%ct)" --owner=0 --group=0 --numeric-owner -C "$2" -c "${@:3}" | gzip -n >"$out/$1"
}

# All from the archive, as it is what a stranger builds.
make_files() {
  local source=$scratch/gasjet-$version
  scripts/setup_debian12.sh dpkg-dev file
  git archive --format=tar --prefix="gasjet-$version/" HEAD | gzip -n >"$out/gasjet-$version.tar.gz"
  tar -xzf "$out/gasjet-$version.tar.gz" -C "$scratch"
  (cd "$source" && cmake --preset release -DGASJET_TESTS=OFF -DGASJET_BENCHMARKS=OFF && cmake --build --preset release && scripts/docs_site.sh && cd build && cpack -G DEB)
  mv "$source"/build/packages/*.deb "$out"
  cmake --install "$source/build" --component command --prefix "$scratch/prefix" >/dev/null
  cp LICENSE "$scratch/prefix/share/gasjet"
  pack "gasjet-reference-data-$(<cases/reference/VERSION).tar.gz" "$scratch/prefix/share" gasjet
  pack "gasjet-$version-site.tar.gz" "$source/build" site
  (cd "$out" && sha256sum ./* >"$scratch/sums" && mv "$scratch/sums" SHA256SUMS)
}

# In an empty Debian 12: what the packages do not name is not there.
try_packages() {
  local root=$scratch/root
  mkdir "$root"
  make_root "$root"
  mkdir "$root/try"
  cp "$out"/*.deb "$root/try"
  cp -r "$scratch/gasjet-$version/verification/rules/outside" "$root/try"
  # shellcheck disable=SC2016
  printf '#!/bin/bash\ncp "/usr/share/gasjet/cases/reference/$(basename "$1" .json).csv" "$2"\n' >"$root/try/program"
  chmod +x "$root/try/program"
  in_root "$root" 'cd /try
    export DEBIAN_FRONTEND=noninteractive
    apt-get update -q >/dev/null
    apt-get install -q -y --no-install-recommends ./gasjet_*.deb >/dev/null
    gasjet --version
    gasjet run /usr/share/gasjet/cases/passenger_pendulum.toml
    /usr/share/gasjet/run_external.sh ./program
    apt-get install -q -y --no-install-recommends ./libgasjet_*.deb ./python3-gasjet_*.deb >/dev/null
    /usr/bin/python3 outside/consumer.py --without-exact
    apt-get install -q -y --no-install-recommends ./*.deb g++ gfortran cmake make pkg-config >/dev/null
    outside/use.sh /usr'
}

(($#)) || ((EUID == 0)) || refuse "the empty Debian needs root; run it as root or with sudo"
check_tree
check_tests
if (($#)); then
  echo "$version at $commit is fit for a release"
  exit 0
fi
scratch=$(mktemp -d)
trap cleanup EXIT
rm -rf "$out" "$release"
mkdir -p "$out"
make_files
try_packages
mv "$out" "$release"
echo "=== release $version of $commit, in $release:"
(cd "$release" && ls -l)
echo "next: git tag --annotate v$version --message 'Gasjet $version'"
