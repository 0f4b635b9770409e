#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Proves that scripts/docs_site.sh fails, and names the place, where a page leads to no page, no anchor or no file or is not in the
# menu, where an equation cannot be rendered or is left as source, and where a page loads something from elsewhere. usage: GASJET=PROGRAM docs_site_can_fail.sh
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$root"
cp --parents -r mkdocs.yml ./*.md CITATION.cff LICENSE docs cases lib* verification benchmarks scripts "$scratch"

# refuses WHAT COMMAND...: the command fails, and its report says WHAT.
refuses() {
  local what=$1
  shift
  if "$@" >"$scratch/log" 2>&1; then
    echo "let pass: $what"
    exit 1
  fi
  grep -qF "$what" "$scratch/log" || { echo "failed, but not by: $what"; cat "$scratch/log"; exit 1; }
}

# page LINE: a site of one page with that line.
page() {
  rm -rf "$scratch/site"
  mkdir "$scratch/site"
  printf '%s\n' '<h1 id="top">Page</h1>' "<a href='#top'>up</a> $1" >"$scratch/site/index.html"
}

render() { NODE_PATH=/usr/share/nodejs node docs/make/site/render_equations.js "$scratch/site"; }
check() { /usr/bin/python3 -B docs/make/site/check_links.py "$scratch/site"; }

page '<span class="arithmatex">\(\rho &lt; \frac{1}{2}\)</span>'
refuses 'index.html:2: equation left as source' check
render >/dev/null
check >/dev/null
page '<span class="arithmatex">\(\fraction{1}{2}\)</span>'
refuses 'index.html: KaTeX parse error' render
page 'text'
refuses 'no equation found' render
page '<a href="gone.csv">table</a>'
refuses 'index.html:2: gone.csv: no such file' check
page '<a href="#gone">part</a>'
refuses 'index.html:2: #gone: no such anchor' check
page '<script src="https://example.org/a.js"></script>'
refuses 'index.html:2: https://example.org/a.js: loaded from elsewhere' check

echo '[gone](gone.md)' >>"$scratch/docs/limits.md"
echo '# New' >"$scratch/docs/new.md"
refuses "docs/limits.md' contains a link to 'docs/gone.md'" "$scratch/scripts/docs_site.sh"
grep -qF 'docs/new.md is not in the nav of mkdocs.yml' "$scratch/log" || { echo 'let pass: a page outside the menu'; exit 1; }
