# SPDX-License-Identifier: Apache-2.0
"""The rule of names notices each kind of function that is defined under another name than its header's, and no other."""
import pathlib
import subprocess
import sys

RULE = pathlib.Path(__file__).parent / "header_names.py"
HEADER = """namespace gas {
struct Curve {
  std::vector<double> values() const;
  int count = 0;
};
template <class T>
T twice(T x) { return x + x; }
std::map<int, double> areas(const Curve& curve, int count = 1);
}
"""
SOURCE = """#include "curve.hpp"
namespace gas {
namespace {
double areas(int x) { return x; }
}  // namespace
static int one() { return 1; }
std::map<int, double> areas(const Curve& curve, int count) {
  return f(curve, [&](int i) { return i; });
}
std::vector<double> Curve::values() const { return {1.0, 2.0}; }
}  // namespace gas
"""


def broken(folder, source, limit="0"):
    (folder / "libgas/src").mkdir(parents=True)
    (folder / "libgas/src/curve.hpp").write_text(HEADER)
    (folder / f"libgas/src/{source}").write_text(SOURCE)
    result = subprocess.run([sys.executable, "-B", RULE, folder, f"libgas={limit}"], capture_output=True, text=True)
    assert result.returncode == bool(result.stdout), result.stderr
    return result.stdout.splitlines()


def test_a_source_of_the_headers_name_is_good(tmp_path):
    assert not broken(tmp_path / "same", "curve.cpp")
    assert not broken(tmp_path / "longer", "curve_areas.cpp")


def test_another_name_is_told(tmp_path):
    assert broken(tmp_path, "table.cpp") == ["libgas/src/table.cpp:7: areas is declared in libgas/src/curve.hpp",
                                             "libgas/src/table.cpp:10: Curve::values is declared in libgas/src/curve.hpp"]


def test_a_share_is_allowed(tmp_path):
    assert not broken(tmp_path / "all", "table.cpp", "100")
    assert broken(tmp_path / "less", "table.cpp", "99")
