#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Makes all that a release consists of, from the commit that is checked out, in build/release. Then installs the packages in an empty
# Debian 12 and uses them there: the main case, a judgement by the reference set, programs in C++, C, Fortran and Python. Needs root and
# network for that. docs/releasing.md says the rest.
# usage: scripts/release.sh [--check]     --check: only says whether this commit is fit for a release
# Refuses (exit code 2) a tree with changes that are not committed, versions that differ, and a commit whose tests are red: unless
# scripts/test_all.sh --long has just passed at it, it is run first.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# shellcheck source=tests/debian_root.sh
source scripts/tests/debian_root.sh

refuse() { echo "release.sh: $*" >&2 && exit 2; }
is_green() { [[ -f build/green && $(<build/green) == "$commit fast long sanitize" ]]; }
pack() { tar --sort=name --mtime="@$SOURCE_DATE_EPOCH" --owner=0 --group=0 --numeric-owner -C "$2" -c "$3" | gzip -n >"$out/$1"; } # the same bytes

if (($# > 1)) || [[ ${1:---check} != --check ]]; then refuse "unknown argument '$*'; allowed: --check"; fi
(($#)) || ((EUID == 0)) || refuse "the empty Debian needs root; run it as root or with sudo"
version=$(sed -nE 's/^set\(GASJET_VERSION ([0-9.]+)\)$/\1/p' cmake/GasjetVersion.cmake)
commit=$(git rev-parse HEAD)
[[ -z $(git status --porcelain) ]] || refuse "what is not committed would be in no release:"$'\n'"$(git status --porcelain)"
! grep -q '^## Unreleased' CHANGELOG.md || refuse "CHANGELOG.md: 'Unreleased' is to become '$version (date)' first"
verification/rules/rules.py versions >&2 || refuse "the versions differ"
tagged=$(git rev-parse -q --verify "v$version^{commit}" || true)
[[ -z $tagged || $tagged == "$commit" ]] || refuse "v$version is another commit, $tagged: a new release needs a new number"
is_green || scripts/test_all.sh --long || refuse "the tests are red"
is_green || refuse "the tests ran at another commit or left changes behind"
if (($#)); then
  echo "$version at $commit is fit for a release"
  exit 0
fi

umask 022
SOURCE_DATE_EPOCH=$(git log -1 --format=%ct) # the time that packages and site take for now: the same bytes whenever they are made
export SOURCE_DATE_EPOCH
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
release=$PWD/build/release out=$PWD/build/release.untried # until the packages have worked
rm -rf "$out" "$release"
mkdir -p "$out"

# All from the archive, as it is what a stranger builds.
source=$scratch/gasjet-$version
scripts/setup_debian12.sh dpkg-dev file python3-venv
git archive --format=tar --prefix="gasjet-$version/" HEAD | gzip -n >"$out/gasjet-$version.tar.gz"
tar -xzf "$out/gasjet-$version.tar.gz" -C "$scratch"
(cd "$source" && cmake --preset release -DGASJET_TESTS=OFF -DGASJET_BENCHMARKS=OFF && cmake --build --preset release && scripts/setup_browser.py && cmake --preset browser && cmake --build --preset browser && scripts/docs_site.sh && cd build && cpack -G DEB)
mv "$source"/build/packages/*.deb "$out"
/usr/bin/python3 -m venv --system-site-packages "$scratch/venv"
"$scratch/venv/bin/pip" wheel --no-build-isolation --no-index --no-deps --config-settings build-dir=build --wheel-dir "$out" "$source"
cmake --install "$source/build" --component command --prefix "$scratch/prefix" >/dev/null
cp LICENSE "$scratch/prefix/share/gasjet"
pack "gasjet-reference-data-$(<cases/reference/VERSION).tar.gz" "$scratch/prefix/share" gasjet
pack "gasjet-$version-site.tar.gz" "$source/build" site
cp "$source/build-browser/try.html" "$out/gasjet-$version.html"
(cd "$out" && sha256sum ./* >"$scratch/sums" && mv "$scratch/sums" SHA256SUMS)

# In an empty Debian 12: what the packages do not name is not there.
root=$scratch/root
mkdir "$root"
make_root "$root"
mkdir "$root/try"
cp -r "$out"/*.deb "$source/verification/rules/outside" "$root/try"
in_root "$root" 'cd /try
  export DEBIAN_FRONTEND=noninteractive
  apt-get update -q >/dev/null
  apt-get install -q -y --no-install-recommends ./gasjet_*.deb >/dev/null
  gasjet --version
  gasjet run /usr/share/gasjet/cases/passenger_pendulum.toml
  printf "%s\n" "#!/bin/bash" "cp /usr/share/gasjet/cases/reference/\$(basename \$1 .json).csv \$2" >program
  chmod +x program
  /usr/share/gasjet/run_external.py ./program
  apt-get install -q -y --no-install-recommends ./libgasjet_*.deb ./python3-gasjet_*.deb >/dev/null
  /usr/bin/python3 outside/consumer.py --without-exact
  apt-get install -q -y --no-install-recommends ./*.deb g++ gfortran cmake make pkg-config >/dev/null
  outside/use.sh /usr'

mv "$out" "$release"
echo "=== release $version of $commit, in $release:"
(cd "$release" && ls -l)
echo "next: git tag --annotate v$version --message 'Gasjet $version'"
