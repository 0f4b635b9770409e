#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Sets emscripten up and builds preset `browser`; its page and its code must stay small.
# usage: build.sh
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
scripts/setup_browser.py
cmake --preset browser >/dev/null
cmake --build --preset browser
page=$(stat -c %s build-browser/try.html) code=$(cat build-browser/gasjet.{js,wasm} | brotli -9 --stdout | wc -c)
echo "page $page bytes, code $code bytes by brotli"
((page <= 1500000 && code <= 910000)) || { echo "build.sh: allowed: a page of 1500000 bytes, code of 910000 bytes by brotli" >&2; exit 1; }
