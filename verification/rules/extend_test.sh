#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# What CONTRIBUTING.md says of a new species, impactor and fabric law, done to a copy: one row of the table of species, a brick as the
# impactor's shape, and four files of a law. All are built, and a program uses what is new.
# usage: extend_test.sh SCRATCH
set -euo pipefail
root=$(cd "${BASH_SOURCE[0]%/*}/../.." && pwd)
here=$root/verification/rules/extend
scratch=${1:?usage: extend_test.sh SCRATCH}
rm -rf "$scratch/source"
mkdir -p "$scratch/source"
cp -a "$root"/{cmake,elementary,libgas,libcoupling} "$scratch/source"

echo 'Kr,83.798,200.0,6000.0,2.5,0.0,0.0,0.0,0.0,-745.375,5.49095651,test' >>"$scratch/source/libgas/data/nasa7.csv"

coupling=$scratch/source/libcoupling
sed -i 's|^/// A shape of an impactor.|/// A brick with round edges.\nstruct Brick {\n  Eigen::Vector3d half_sides;  // [m] of the box\n  double radius;               // [m] of the edges\n};\n\n&|; s/^\(using Impactor = .*\)>;/\1, Brick>;/' \
  "$coupling/include/coupling/impactor.hpp"
sed -i '$d' "$coupling/src/bodies.hpp"  # the end of the namespace
{ cat "$here/brick.hpp"; echo '}  // namespace coupling::detail'; } >>"$coupling/src/bodies.hpp"
sed -i 's/^void require_valid_shape(const Disc& disc) {/void require_valid_shape(const Brick\& brick) { detail::require_positive("impactor.radius", brick.radius); }\n\n&/' \
  "$coupling/src/impactor.cpp"

# build LIBRARY PROGRAM: the library of the copy, and a program that links it
build() {
  cmake -S "$scratch/source/lib$1" -B "$scratch/$1" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX="$scratch/prefix" \
    -DCMAKE_UNITY_BUILD=ON >/dev/null
  cmake --build "$scratch/$1" -j 2 >/dev/null
  cmake --install "$scratch/$1" >/dev/null
  mkdir -p "$scratch/$2"
  cp "$here/$2.cpp" "$scratch/$2"
  printf '%s\n' 'cmake_minimum_required(VERSION 3.25)' "project($2 CXX)" "find_package(gasjet_$1 REQUIRED)" \
    "add_executable($2 $2.cpp)" "target_link_libraries($2 gasjet::$1)" >"$scratch/$2/CMakeLists.txt"
  cmake -S "$scratch/$2" -B "$scratch/$2/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$scratch/prefix" >/dev/null
  cmake --build "$scratch/$2/build" >/dev/null
  "$scratch/$2/build/$2"
}
build gas species_test
build coupling brick_test
echo "a species took one row, an impactor three files"

# A law, in a copy of the whole tree.
tree=$scratch/tree
rm -rf "$tree" "$scratch/before"
mkdir -p "$tree"
(cd "$root" && tar -c --exclude='./build*' --exclude=./results --exclude=./.git .) | tar -x -C "$tree"
cp -a "$tree" "$scratch/before"
cp "$here/partial.hpp" "$tree/libmembrane/include/membrane"
sed -i 's/^#include "membrane.orthotropic.hpp"/&\n#include "membrane\/partial.hpp"/; s/^\(using FabricLaws = .*\)>;/\1, Partial>;/' \
  "$tree/libmembrane/include/membrane/fabric_laws.hpp"
cp "$here/partial_test.cpp" "$tree/verification/membrane"
sed -i 's/^| `curve` .*/&\n| `partial` | by a share $c$ of each of the two (M.101) | isotropic | none | `kept_compression` |/; s/^Fabric with a `weave`/$$ W = c W + (1 - c) W_r \\tag{M.101} $$\n\n&/' "$tree/docs/theory/membrane.md"
touched=$(diff -rq "$scratch/before" "$tree" || true)
(($(wc -l <<<"$touched") == 4)) || { printf 'a law touches other than four files:\n%s\n' "$touched" && exit 1; }
"$root/verification/rules/rules.py" --root "$tree" include_rule geometry_include file_size equation_tags links case_keys

cmake -S "$tree" -B "$scratch/law" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE=-O1 -DCMAKE_UNITY_BUILD=ON \
  -DCMAKE_UNITY_BUILD_BATCH_SIZE=30 -DGASJET_BINDINGS=OFF >/dev/null
cmake --build "$scratch/law" -j 2 --target gasjet membrane_tests >/dev/null
"$scratch/law/verification/membrane/membrane_tests" --gtest_brief=1 --gtest_filter='FabricLaws.*:Partial.*'
gasjet=$(find "$scratch/law" -name gasjet -type f -perm -u+x | head -n 1)
/usr/bin/python3 "$tree/docs/make/pages/case_keys.py" --check "$gasjet" >/dev/null
"$gasjet" run "$here/partial.toml" --quiet --out "$scratch/run"
# refused OVERRIDE TEXT: the case with the override is refused by that message
refused() {
  local said
  said=$("$gasjet" check "$here/partial.toml" --set "$1" 2>&1) && { echo "$1 is accepted" && exit 1; }
  [[ $said == *"$2"* ]] || { printf '%s: says %s\n' "$1" "$said" && exit 1; }
}
refused fabric.kept_compression=1.5 'fabric.kept_compression: is 1.5, a number from 0 to 1'
refused fabric.compression=linear 'law = "partial" carries no compression'
refused 'fabric.weave={ young_modulus_weft = 6e7, shear_modulus = 1e7, warp = [1, 1, 1] }' 'is for isotropic fabric, without weave'
for format in radioss lsdyna; do
  "$gasjet" export "$here/partial.toml" --format "$format" --units kg-m-s --out "$scratch/$format" >/dev/null
  for key in law kept_compression; do
    grep -q "fabric.$key.*not mapped" "$scratch/$format/export.md" || { echo "$format: export.md does not say that fabric.$key is not mapped" && exit 1; }
  done
done
echo "a fabric law took four files"
