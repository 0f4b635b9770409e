#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Builds the documentation site in build/site, with search, rendered equations and the reference of the public headers. Fails on any
# warning, dead link, equation that cannot be rendered, or file that a page loads from elsewhere. Installs what is missing. Needs
# build/gasjet, or the program that GASJET names: the site shows the paper's scene in motion.
# usage: scripts/docs_site.sh [--serve]      --serve: then show it on http://localhost:8000
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
if (($# > 1)) || [[ ${1:---serve} != --serve ]]; then
  echo "docs_site.sh: unknown argument '$*'; allowed: --serve" >&2
  exit 2
fi

gasjet=${GASJET:-build/gasjet}
[[ ! -d $gasjet ]] || gasjet+=/build/gasjet # a clone, as the tutorials set it
if [ ! -x "$gasjet" ]; then
  echo "docs_site.sh: $gasjet is missing: scripts/run_main_case.sh builds it" >&2
  exit 2
fi

scripts/setup_debian12.sh mkdocs mkdocs-material python3-pymdownx katex doxygen >/dev/null
source=build/site_source site=build/site
runs=build/site_runs
rm -rf "$source" "$site" "$runs"
mkdir -p "$source/assets" "$source/api" "$source/reports"

# The site has the repository's layout: links between its files hold in both.
for path in ./*.md CITATION.cff Dockerfile LICENSE docs bindings cases cmake driver elementary lib* verification benchmarks scripts; do
  ln -s "$PWD/$path" "$source"
done
cp -rL /usr/share/javascript/katex/katex.min.css /usr/share/javascript/katex/fonts docs/make/site/site.css "$source/assets"
docs/make/site/api_docs.sh "$source/api" >/dev/null
/usr/bin/python3 -B docs/make/site/api_pages.py "$source/api"
for name in passenger_pendulum passenger_pendulum_no_jet; do
  "$gasjet" run "cases/$name.toml" --out "$runs/$name" --quiet
done
"$gasjet" report "$runs"/passenger_pendulum{,_no_jet} --out "$source/reports/passenger_pendulum.html" >/dev/null
# The page that runs cases, and the figures that readers move: of preset browser, which takes a quarter of an hour to build.
if [[ -f build-browser/try.html ]]; then
  cp build-browser/try.html "$source/try.html"
  cp build-browser/{live,exact_program,gasjet_program}.js "$source/assets"
else
  echo '<!doctype html><meta charset="utf-8"><title>Gasjet</title><p>This site was made without the page that runs cases: scripts/setup_browser.py, then cmake --preset browser and cmake --build --preset browser.' >"$source/try.html"
fi

mkdocs build --strict
NODE_PATH=/usr/share/nodejs node docs/make/site/render_equations.js "$site"
/usr/bin/python3 -B docs/make/site/check_links.py "$site"
echo "$site/index.html"

if (($#)); then
  /usr/bin/python3 -m http.server --bind localhost --directory "$site" 8000
fi
