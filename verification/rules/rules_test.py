# SPDX-License-Identifier: Apache-2.0
"""Each rule can fail: it keeps quiet on a small good tree, and names the file of each violation put into it alone."""

import pytest

import rules

SPDX = "// SPDX-License-Identifier: Apache-2.0\n"
MEMBERS = 3 * "double a1, a2, a3, a4; std::map<int, double> b1; void b2(int, int); int b3() const { return 1; } " + \
    "enum Kind { x, y, z }; Small(int, int); Small(const Small&) = delete; double d1[3], d2, d3;"
VERSIONS = ["program and libraries | 1.2.3", "case files | 2", "result files | 3", "JSON of commands | 5", "reference data | 4"]


def rows(names):
    return "".join(f"| {name} |\n" for name in names)


GOOD = {
    ".clang-format": "BasedOnStyle: Google\n",
    "libjet/src/tree.cpp": SPDX + "#include <CGAL/AABB_tree.h>\n\n#include <Eigen/Dense>\n",
    "libgas/src/ode.cpp": SPDX + "#include <boost/numeric/odeint.hpp>\n",
    "libmembrane/mesh/include/mesh/stl.hpp": SPDX + "#include <Eigen/Core>\n",
    "libmembrane/mesh/src/stl.cpp": SPDX + '#include "mesh/stl.hpp"\n',
    "verification/closed_form/src/gas.cpp": SPDX + "#include <gsl/gsl_sf_hyperg.h>\n",
    "verification/enclosure/src/tank.cpp": SPDX + "#include <arb.h>\n#include <flint/fmpz.h>\n",
    "driver/main.cpp": SPDX + '#include "commands/program.hpp"\n',
    "driver/base/include/base/formats.hpp":
        SPDX + "inline constexpr int case_file = 2;\ninline constexpr int results = 3;  // of\ninline constexpr int json = 5;\n",
    "driver/engine/include/engine/step.hpp": SPDX + '#include "base/formats.hpp"\n#include "gas/model.hpp"\n',
    "driver/engine/src/stages.hpp": SPDX,
    "driver/engine/src/scene/scene.cpp":
        SPDX + '#include "../stages.hpp"\n#include "engine/step.hpp"\n#include "stages.hpp"\n'
               'double v = table.at("volume").number(positive) + t->at("law").choice<Law>(laws);\n',
    "driver/engine/src/columns/columns.cpp":
        SPDX + '// clang-format off\nColumns a{{"pressure_Pa", has, f}, add("inflator_" + std::to_string(i) + "_in_kg", g)};\n',
    "driver/engine/src/columns/energy_terms.cpp": SPDX + 'Columns b{{"strap_J", held, straps, f}};\n',
    "driver/engine/CMakeLists.txt": "# SPDX-License-Identifier: Apache-2.0\ntarget_link_libraries(gasjet_engine PUBLIC gasjet_base)\n",
    "driver/compare/include/compare/history.hpp": SPDX,
    "driver/export/src/deck.cpp": SPDX + '#include "base/formats.hpp"\n',
    "driver/commands/include/commands/program.hpp": SPDX,
    "docs/case_files.md": rows(["`volume` | of the tank", "`law` | of `spread`"]),
    "docs/results.md": "## `history.csv`\n" + rows(["`pressure_Pa`", "`inflator_*_in_kg`"]) + "## `energy.csv`\n" + rows(["`strap_J`"]) +
                       "## `summary.json`\n" + rows(["`status`"]),
    "docs/versions.md": rows(VERSIONS),
    "docs/exact.md": "**`tank_fill`**: of a tank\n",
    "docs/theory/gas.md": "$$ p V = m R T \\tag{G.1} $$\n",
    "docs/figure.svg": "<svg/>\n",
    "README.md": "![figure](docs/figure.svg) [gas](docs/theory/gas.md#tag) [web](https://example.org)\n```cpp\nrun([&](int i) {});\n```\n",
    "scripts/run.sh": "#!/usr/bin/env bash\n# SPDX-License-Identifier: Apache-2.0\n# built without -ffast-math\n",
    "build/CTestTestfile.cmake": 'add_test(gas.tank "true")\nadd_test(faults/bad_input.one/nan "true")\n',
    "verification/mutations.tsv": "# comment\ngas.(tank|vent)\tREADME.md\ts/gas/b/\nbad_input.*/nan( |$)\tREADME.md\ts/gas/b/\n",
    "verification/schemas/scene.schema.json": '    "format": { "const": 5, "description": "x" },\n',
    "benchmarks/ablation.tsv": "# comment\ngas lines\tREADME.md\ts/gas/b/\twhat happens\n",
    "cases/tank.toml": "# Closed form: `gasjet exact tank_fill`.\n[scene]\nformat = 2\n",
    "cases/reference/VERSION": "4\n",
    "cmake/GasjetVersion.cmake": "# SPDX-License-Identifier: Apache-2.0\nset(GASJET_VERSION 1.2.3)\n",
    "CITATION.cff": "version: 1.2.3\ndate-released: 2026-01-02\n",
    "CHANGELOG.md": "## Unreleased\n## 1.2.3 (2026-01-02)\n## 1.2.2 (2026-01-01)\n",
    "libjet/src/small.hpp": SPDX + "// clang-format off\nclass Small { " + MEMBERS + " };\n",
    "libjet/src/one.cpp": SPDX + "struct Other {};\ndouble Other::operator()(int) const { return 3; }\n",
    "libjet/src/two.cpp": SPDX + "double Other::b() { return 3; }\n",
}
for NAME in ("gas", "membrane", "jet", "coupling"):
    GOOD |= {f"lib{NAME}/include/{NAME}/model.hpp": SPDX + f"#include <vector>\n// see gas::Curve (G.1), {NAME}::Model\n",
             f"lib{NAME}/src/model.cpp": SPDX + f'#include "{NAME}/model.hpp"\n\n#include <cmath>\n\n#include "detail.hpp"\n',
             f"lib{NAME}/src/detail.hpp": SPDX,
             f"lib{NAME}/CMakeLists.txt": f"# SPDX-License-Identifier: Apache-2.0\ngasjet_library({NAME} SOURCES src/model.cpp)\n"}

VIOLATIONS = {
    "include_rule": [
        ("libgas/src/model.cpp", SPDX + '#include "jet/model.hpp"'),
        ("libgas/include/gas/model.hpp", SPDX + "#include <membrane/model.hpp>"),
        ("libjet/src/model.cpp", SPDX + '#include "../../libgas/include/gas/model.hpp"'),
        ("libcoupling/src/model.cpp", SPDX + '  #  include "engine/step.hpp"'),
        ("libmembrane/src/model.cpp", SPDX + '#include "closed_form/membrane.hpp"'),
        ("libmembrane/mesh/src/stl.cpp", SPDX + '#include "membrane/model.hpp"'),
        ("libmembrane/mesh/src/stl.cpp", SPDX + "#include <CGAL/Epick.h>"),
        ("libmembrane/mesh/src/stl.cpp", SPDX + "void f(const membrane::Mesh& mesh);"),
        ("libgas/src/model.cpp", SPDX + "#include <Eigen/Dense>"),
        ("libmembrane/include/membrane/model.hpp", SPDX + "void f(const gas::Curve& curve);"),
        ("libjet/CMakeLists.txt", "gasjet_library(jet SOURCES a.cpp PUBLIC_LINK gasjet::gas)"),
        ("libjet/CMakeLists.txt", "target_include_directories(x PRIVATE ../libgas/include)"),
        ("libjet/include/jet/model.hpp", SPDX + "#include <CGAL/Epick.h>"),
        ("driver/engine/src/stages.hpp", SPDX + "#include <CGAL/Epick.h>"),
        ("verification/closed_form/src/gas.cpp", SPDX + '#include "gas/model.hpp"'),
        ("verification/enclosure/src/tank.cpp", SPDX + '#include "gas/model.hpp"'),
        ("libgas/src/model.cpp", SPDX + '#include "enclosure/scene.hpp"'),
        ("verification/closed_form/src/gas.cpp", SPDX + "#include <boost/math/quadrature/gauss.hpp>"),
    ],
    "layers": [
        ("driver/base/src/case.cpp", SPDX + '#include "engine/step.hpp"'),
        ("driver/export/src/deck.cpp", SPDX + '#include "compare/history.hpp"'),
        ("driver/commands/src/run.cpp", SPDX + '#include "stages.hpp"'),
        ("driver/commands/src/run.cpp", SPDX + '#include "../../engine/src/stages.hpp"'),
        ("driver/base/CMakeLists.txt", "target_link_libraries(gasjet_base PUBLIC gasjet_engine)"),
    ],
    "geometry_include": [
        ("libgas/src/model.cpp", SPDX + "#include <Eigen/Core>\nconst auto n = a.cross(b);"),
        ("libgas/src/model.cpp", SPDX + "const auto n = a->unitOrthogonal();"),
        ("libgas/include/gas/model.hpp", SPDX + "const Eigen::AngleAxisd turn(1.0, axis);"),
    ],
    "spdx": [
        ("libgas/include/gas/model.hpp", "#pragma once\n" + SPDX),
        ("libgas/CMakeLists.txt", "project(gas)"),
        ("scripts/run.sh", "#!/usr/bin/env bash\ntrue"),
        ("scripts/plot.gp", "plot x"),
        ("scripts/plot.py", '"""A module."""'),
        ("driver/base/src/version.hpp.in", "#pragma once"),
        ("libgas/src/model.cpp", "// SPDX-License-Identifier: MIT"),
    ],
    "file_size": [(name, 301 * "//\n") for name in ("libgas/src/model.cpp", "scripts/run.sh")],
    "format": [("libgas/src/model.cpp", SPDX + "int  two(){ return 2; }")],
    "forbidden_words": [
        ("libgas/CMakeLists.txt", "target_compile_options(x PRIVATE -ffast-math)"),
        ("CMakePresets.json", '{ "CMAKE_CXX_FLAGS": "-Ofast" }'),
        ("docs/stages.md", "Results are in /home/user/results."),
        ("README.md", "See /root/gasjet/docs."),
        ("libgas/src/model.cpp", 'std::ofstream out("/tmp/trace.csv");'),
        ("libgas/src/model.cpp", "int x = 0;  // TODO: compute"),
        ("docs/stages.md", "FIXME"),
    ],
    "equation_tags": [
        ("libgas/src/model.cpp", "// pressure (G.99)"),
        ("libgas/src/model.cpp", "// pressure (G.1, G.99)"),
        ("docs/limits.md", "by (M.97)"),
        ("docs/theory/membrane.md", r"$$ V = x \tag{M.98} $$"),
        ("docs/theory/membrane.md", r"$$ V = x \tag{G.1} $$"),
    ],
    "links": [
        ("README.md", "[gas](docs/gas.md)"),
        ("docs/theory/jet.md", "see [gas](gas.md) and ![figure](figure.svg)"),
    ],
    "exact_names": [
        ("cases/tank.toml", "# Closed form: `gasjet exact tank_filled`."),
        ("scripts/chart.sh", '"$build/gasjet" exact round_jet --times 0:1:0.1'),
    ],
    "class_sizes": [
        ("libjet/src/small.hpp", f"class Small {{ {MEMBERS} int b4; }};"),
        ("libjet/src/three.cpp", "struct Other {};\nOther::Other() { }"),
    ],
    "case_keys": [
        ("docs/case_files.md", rows(["`volume` | of the tank"])),
        ("docs/case_files.md", rows(["`volume`, `law` | of the tank", "`colour` | of the bag"])),
    ],
    "columns": [
        ("docs/results.md", GOOD["docs/results.md"].replace("| `inflator_*_in_kg` |\n", "")),
        ("docs/results.md", GOOD["docs/results.md"].replace("`strap_J` |", "`strap_J` |\n| `colour_J` |")),
    ],
    "versions": [
        ("CITATION.cff", "version: 1.2.4\ndate-released: 2026-01-02"),
        ("CITATION.cff", "version: 1.2.3\ndate-released: 2026-01-01"),
        ("CITATION.cff", "version: 1.2.3"),
        ("CHANGELOG.md", "## Unreleased\n## 1.2.4 (2026-01-03)\n## 1.2.3 (2026-01-02)"),
        *(("docs/versions.md", rows(VERSIONS[:i] + [VERSIONS[i] + "1"] + VERSIONS[i + 1:])) for i in range(len(VERSIONS))),
        ("docs/versions.md", rows(VERSIONS[1:])),
        ("cases/tank.toml", "[scene]\nformat = 1"),
        ("verification/schemas/scene.schema.json", '    "format": { "const": 4, "description": "x" },'),
        ("libgas/CMakeLists.txt", "project(gasjet_gas VERSION 1.2.3 LANGUAGES CXX)"),
    ],
    "mutation_lines": [
        ("verification/mutations.tsv", 201 * "gas.tank\tREADME.md\ts/gas/b/\n"),
        ("verification/mutations.tsv", "bad_input.*/inf( |$)\tREADME.md\ts/gas/b/"),
        ("verification/mutations.tsv", ".*\tREADME.md\ts/absent/b/"),
        ("verification/mutations.tsv", ".*\tgone.cpp\ts/gas/b/"),
    ],
    "ablation_lines": [
        ("benchmarks/ablation.tsv", "gas lines\tREADME.md\ts/absent/b/\twhat happens"),
        ("benchmarks/ablation.tsv", "gas lines\tgone.cpp\ts/gas/b/\twhat happens"),
    ],
}


def found_by(rule, folder):
    return list(rules.RULES[rule](rules.Tree(str(folder), str(folder / "build"))))


@pytest.mark.parametrize("rule", VIOLATIONS)
def test_can_fail(rule, tmp_path):
    for name, text in GOOD.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)
    assert found_by(rule, tmp_path) == []
    for name, text in VIOLATIONS[rule]:
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text + "\n")
        found = found_by(rule, tmp_path)
        assert any(name in line for line in found), (name, text)
        if name in GOOD:
            (tmp_path / name).write_text(GOOD[name])
        else:
            (tmp_path / name).unlink()
