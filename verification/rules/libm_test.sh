#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The libraries and the driver call no function of libm whose result is rounded otherwise elsewhere: those stand in elementary/. Of the
# libraries what is compiled is searched, so that Boost and Eigen are seen too, of the driver, whose Student's t is Boost's, the sources. There log10
# counts the digits of a text.
# usage: libm_test.sh BUILD COMPILER
set -euo pipefail
build=${1:?usage: libm_test.sh BUILD COMPILER} compiler=${2:?usage: libm_test.sh BUILD COMPILER}
rounded='a?(sin|cos|tan)h?|sincos|atan2|exp(2|10|m1)?|log(2|10|1p)?|pow|cbrt|hypot|erfc?|[lt]gamma(_r)?'

# calls ARCHIVE...: `archive: function`
calls() {
  nm --undefined-only --print-file-name "$@" 2>/dev/null | sed -nE "s/^([^:]*):.* U (($rounded)[fl]?)(@.*)?\$/\1: \2/p" | sort -u
}

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
echo 'double f(double x) { return __builtin_sin(x) + __builtin_expm1(x); }' | "$compiler" -x c++ -c -o "$scratch/probe.o" -
if [[ $(calls "$scratch/probe.o" | wc -l) != 2 ]]; then
  echo "libm_test.sh: does not see sin and expm1 in an object that calls them" >&2
  exit 1
fi
mapfile -t archives < <(find "$build"/lib{gas,membrane,jet,coupling} -name 'libgasjet_*.a')
found=$(calls "${archives[@]}"; grep -rHnE "\bstd::(${rounded//|10|/|})[fl]?\(|\b(AngleAxis|EigenSolver)" "$(dirname "${BASH_SOURCE[0]}")"/../../driver || true)
if [[ -n $found ]]; then
  printf '%s\ncalled in place of the function in elementary/\n' "$found"
  exit 1
fi
