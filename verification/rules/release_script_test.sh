#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# scripts/release.sh refuses a tree that is not fit for a release, in a clone whose tests are put in place; a source archive names
# its commit, and so does a clone, but no folder of another repository.
set -euo pipefail
source=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
export GIT_AUTHOR_NAME=test GIT_AUTHOR_EMAIL=test@example.org GIT_COMMITTER_NAME=test GIT_COMMITTER_EMAIL=test@example.org
if ! git -c safe.directory='*' -C "$source" rev-parse --git-dir >/dev/null 2>&1; then
  echo "SKIPPED, the sources are no clone"
  exit 0
fi

fail() {
  echo "FAILED: $*"
  exit 1
}

# expect CODE PATTERN: of release.sh --check
expect() {
  local output status=0
  output=$(scripts/release.sh --check 2>&1 </dev/null) || status=$?
  [[ $status == "$1" ]] && grep -qE -- "$2" <<<"$output" || fail "exit $status, $1 with '$2' expected: $output"
}

# tests COMMAND: what takes the place of scripts/test_all.sh, committed
tests() {
  printf '#!/bin/bash\n%s\n' "$1" >scripts/test_all.sh
  git commit -qam "Tests: $1" --allow-empty
}

# The working tree as it is, as one commit.
git init -q "$scratch/clone"
cd "$scratch/clone"
git -c safe.directory='*' -C "$source" ls-files -z --cached --others --exclude-standard | tar -C "$source" --null --ignore-failed-read -T - -c | tar -x
git add -A
git commit -qm "All"
sed -i '/^## Unreleased/,/^## [0-9]/{/^## [0-9]/!d}' CHANGELOG.md
git commit -qam "Close the changelog" --allow-empty

touch forgotten
expect 2 'what is not committed .*|\?\? forgotten'
rm forgotten
echo >>README.md
expect 2 ' M README.md'
git checkout -q README.md
tests 'exit 1'
expect 2 'the tests are red'
tests 'exit 0'
expect 2 'the tests ran at another commit'
green='mkdir -p build; echo "$(git rev-parse HEAD) fast'
tests "$green sanitize\" >build/green"
expect 2 'the tests ran at another commit'
tests "$green long sanitize\" >build/green"
expect 0 'is fit for a release'
tests 'exit 1' # green before, not any more
expect 2 'the tests are red'
tests "$green long sanitize\" >build/green"
git tag v"$(sed -nE 's/^set\(GASJET_VERSION ([0-9.]+)\)$/\1/p' cmake/GasjetVersion.cmake)" HEAD~1
expect 2 'is another commit'
git tag -d "$(git tag)" >/dev/null
sed -i 's/^version: .*/version: 9.9.9/' CITATION.cff
git commit -qam "Another version"
expect 2 'CITATION.cff: the version is not'
git reset -q --hard HEAD~1
printf '## Unreleased\n' >>CHANGELOG.md
git commit -qam "Open the changelog"
expect 2 "CHANGELOG.md: 'Unreleased'"
! scripts/release.sh --chek 2>/dev/null || fail "an unknown argument is allowed"

# commit_of FOLDER: what a build of that tree says
commit_of() {
  echo '@GASJET_COMMIT@' >"$scratch/template"
  cmake -D SOURCE_DIR="$1" -D TEMPLATE="$scratch/template" -D OUTPUT="$scratch/output" -P "$1/cmake/BuildInfo.cmake"
  cat "$scratch/output"
}
head=$(git rev-parse --short=12 HEAD)
git tag --annotate v9.9.9 --message release
[[ $(commit_of "$PWD") == "$head" ]] || fail "a clone at a tag says $(commit_of "$PWD")"
mkdir "$scratch/archive" inner
git archive HEAD | tar -x -C "$scratch/archive"
[[ $(commit_of "$scratch/archive") == "$head" ]] || fail "an archive says $(commit_of "$scratch/archive")"
cp -r cmake inner
[[ $(commit_of "$PWD/inner") == unknown ]] || fail "a copy in another repository says $(commit_of "$PWD/inner")"
echo >>README.md
[[ $(commit_of "$PWD") == "$head-dirty" ]] || fail "a changed clone says $(commit_of "$PWD")"
echo "release.sh refuses what is not fit; each tree says its own commit"
