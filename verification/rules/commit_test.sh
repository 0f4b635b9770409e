#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A commit compiles one source anew: only build_info.cpp, which CMake writes, knows it.
# usage: commit_test.sh SOURCE BUILD
set -euo pipefail
source=$1 build=$2

templates=$(grep -rl --include='*.in' --include='*.hpp' --include='*.cpp' GASJET_COMMIT "$source"/{driver,bindings,lib*}/ | sed "s|^$source/||")
[[ $templates == driver/base/src/build_info.cpp.in ]] || { echo "commit_test: the commit is in: $templates"; exit 1; }
[[ -f $build/build.ninja ]] || { echo "commit_test: not built by ninja"; exit 77; }
objects=$(ninja -C "$build" -t query "$(realpath "$build")/driver/base/build_info.cpp" | sed '1,/outputs:/d' | grep -c '\.o$' || true)
[[ $objects == 1 ]] || { echo "commit_test: $objects objects are compiled from build_info.cpp"; exit 1; }
echo "commit_test: one object knows the commit"
