#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Test of the rules: a small good tree keeps every rule; each violation below, put into it alone, breaks its rule
# and is named in the report.
# usage: rules_can_fail.sh RULE
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
rule=${1:?usage: rules_can_fail.sh RULE}
tree=$(mktemp -d)
good=$(mktemp -d)
trap 'rm -rf "$tree" "$good"' EXIT
spdx='// SPDX-License-Identifier: Apache-2.0'

# put FILE LINE...: writes the lines to that file of the tree.
put() {
  [[ $1 != */* || -d $tree/${1%/*} ]] || mkdir -p "$tree/${1%/*}"
  printf '%s\n' "${@:2}" >"$tree/$1"
}

good_tree() {
  rm -rf "${tree:?}"/*
  local name
  for name in gas membrane jet coupling; do
    put "lib$name/include/$name/model.hpp" "$spdx" '#pragma once' '#include <vector>' '// see gas::Curve (G.1)'
    put "lib$name/src/model.cpp" "$spdx" "#include \"$name/model.hpp\"" '#include "detail.hpp"' '#include <cmath>'
    put "lib$name/src/detail.hpp" "$spdx" '#pragma once'
    put "lib$name/CMakeLists.txt" '# SPDX-License-Identifier: Apache-2.0' "gasjet_library($name SOURCES src/model.cpp)"
  done
  put libjet/src/tree.cpp "$spdx" '#include <CGAL/AABB_tree.h>' '#include <Eigen/Dense>'
  put libgas/src/ode.cpp "$spdx" '#include <boost/numeric/odeint.hpp>'
  put verification/closed_form/src/gas.cpp "$spdx" '#include <gsl/gsl_sf_hyperg.h>'
  put driver/engine/src/step/step.cpp "$spdx" '#include "gas/model.hpp"' '#include "jet/model.hpp"'
  put driver/engine/src/scene/scene.cpp "$spdx" 'double v = table.at("volume").number(positive) + t->at(' '    "law").choice<Law>(laws);'
  put docs/case_files.md '| key | meaning |' '|---|---|' '| `volume` | of the tank |' '| `law` | of `spread` |'
  put driver/engine/src/columns/history_columns.cpp "$spdx" '{"pressure_Pa", has::volume, f},' 'add("inflator_" + std::to_string(i) + "_in_kg", g);'
  put driver/engine/src/columns/energy_columns.cpp "$spdx" '{"strap_J", Role::held,' ' has::straps, f},'
  put docs/results.md '## `history.csv`' '| `pressure_Pa` | of the gas |' '| `inflator_*_in_kg` | mass |' '## `energy.csv`' '| `strap_J` | strain |' \
    '## `summary.json`' '| `status` | of the run |'
  put scripts/run.sh '#!/usr/bin/env bash' '# SPDX-License-Identifier: Apache-2.0' '# built without -ffast-math'
  put README.md '![figure](docs/figure.svg) [gas](docs/theory/gas.md#tag) [web](https://example.org)' '```cpp' 'run([&](int i) {});' '```'
  put docs/figure.svg '<svg/>'
  put build/CTestTestfile.cmake 'add_test(gas.tank "true")' 'add_test(faults/bad_input.one/nan "true")' \
    'add_test(rules.links "true")' 'add_test(rules.links_can_fail "true")'
  put verification/mutations.tsv '# comment' $'gas.(tank|vent)\tREADME.md\ts/gas/b/' $'bad_input.*/nan( |$)\tREADME.md\ts/gas/b/'
  put benchmarks/ablation.tsv '# comment' $'gas lines\tREADME.md\ts/gas/b/\twhat happens'
  put docs/exact.md '**`tank_fill`**: of a tank'
  put cases/tank.toml '# Closed form: `gasjet exact tank_fill`.'
  put docs/page.md 'The force is 12.3 N.' 'Two is larger by 4.988 kN, 405 times, 40419 %. It is off by 3 %.' 'The rung is off by 2.5 %, 11.46 degrees.' \
    'It settles at 1.0 by order 2.0.'
  put docs/levels.csv 'level,x' '1,17' '2,5' '3,2'
  put docs/table.csv '# machine' 'case,force_kN' 'one,0.01234' 'two,5'
  put docs/charts/ladder.csv '# machine: M, 2 cores' '# commit: 0123abc' '# compiler: GNU 12' '# flags: -O3' '# counted from: 3' \
    '# reference: 1' 'rung,runs,error' 'full,16,0.05'
  put docs/charts/bag.csv '# machine: M, 2 cores' '# gasjet 0.1.0 (0123abc, GNU 12, Release -O3)' 'x' '1'
  put docs/charts/bag.svg '<svg/>'
  put docs/provenance.tsv '# comment' $'@bag\t-\tlibgas libmembrane :(exclude)*.md' $'docs/charts/ladder.csv\tscripts/run.sh\t@bag cases/tank.toml' \
    $'docs/charts/bag.csv\tscripts/run.sh\t@bag' $'docs/charts/bag.svg\tscripts/run.sh\tdocs/charts/bag.csv'
  put docs/report.md '| check | off |' '|---|---|' '| one | 0.03 |' '| two | 0 |'
  put docs/numbers.tsv '# comment' $'docs/page.md\tforce is ([0-9.]+) N\tdocs/table.csv\tcase=one\tforce_kN\t1000\t%.1f' \
    $'docs/page.md\tlarger by ([0-9.]+) kN\tdocs/table.csv\tcase=two - case=one\tforce_kN\t1\t%.3f' \
    $'docs/page.md\tkN, ([0-9.]+) times\tdocs/table.csv\tcase=two / case=one\tforce_kN\t1\t%.0f' \
    $'docs/page.md\ttimes, ([0-9.]+) %\tdocs/table.csv\tcase=two % case=one\tforce_kN\t100\t%.0f' \
    $'docs/page.md\trung is off by ([0-9.]+) %\tdocs/charts/ladder.csv\trung=full\terror\t100/reference\t%.1f' \
    $'docs/page.md\t%, ([0-9.]+) degrees\tdocs/charts/ladder.csv\trung=full\terror\t180/pi*root_runs\t%.2f' \
    $'docs/page.md\tsettles at ([0-9.]+) by\tdocs/levels.csv\tlevel=1 > level=2 > level=3\tx\t1\t%.1f' \
    $'docs/page.md\tby order ([0-9.]+)\.\tdocs/levels.csv\tlevel=1 ~ level=2 ~ level=3\tx\t1\t%.1f' \
    $'docs/page.md\tIt is off by ([0-9.]+) %\tdocs/report.md\tcheck=one\toff\t100\t%.0f'
  put docs/tables.tsv '# comment' $'table\tforces\tdocs/table.csv' $'columns\tcase\tforce [N]\tover one' \
    $'cells\t{case=@1|force_kN} at {case=@2|force_kN|1}\t{case=@1 / case=one|force_kN|1}' $'row\tfirst\tone; two\t1000\t%.1f %.0f' \
    $'cells\t{case=@|case}\tnone' $'row\tsecond\ttwo\t1\t%s' $'table\trungs\tdocs/charts/ladder.csv' $'columns\trung\terror [%]\tlevel' \
    $'cells\t{rung=@|error|100/reference}\t{level=1|x||docs/levels.csv}' $'row\tall\tfull\t1\t%.1f %.0f'
  put results.md 'All:' '' '<!-- table forces -->' '' '| case | force [N] | over one |' '|---|---|---|' '| first | 12.3 at 5 | 1 |' '| second | two | none |' '' \
    'Taken from [table.csv](docs/table.csv).' '' '<!-- end of table forces -->' '' 'End.'
  put docs/rungs.md '<!-- table rungs -->' '' '| rung | error [%] | level |' '|---|---|---|' '| all | 2.5 | 17 |' '' \
    'Made at commit `0123abc` ([ladder.csv](charts/ladder.csv)). Taken from [levels.csv](levels.csv).' '' '<!-- end of table rungs -->'
  put cmake/GasjetVersion.cmake '# SPDX-License-Identifier: Apache-2.0' 'set(GASJET_VERSION 1.2.3)'
  put CITATION.cff 'version: 1.2.3' 'date-released: 2026-01-02'
  put CHANGELOG.md '## Unreleased' '## 1.2.3 (2026-01-02)' '## 1.2.2 (2026-01-01)'
  put cases/reference/VERSION 4
  put cases/pulse.toml '[scene]' 'format = 2'
  put driver/base/include/base/formats.hpp "$spdx" 'inline constexpr int case_file = 2;' 'inline constexpr int results = 3;  // of' 'inline constexpr int json = 5;'
  put docs/versions.md '| program and libraries | 1.2.3 | x |' '| case files | 2 |' '| result files | 3 |' '| JSON of commands | 5 |' '| reference data | 4 |'
  put verification/schemas/scene.schema.json '    "format": { "const": 5, "description": "x" },'
  put docs/theory/gas.md '$$ p V = m R T \tag{G.1} $$'
}

if [[ $rule == format ]]; then
  good_tree() {
    put .clang-format 'BasedOnStyle: Google'
    put libgas/src/model.cpp "$spdx" 'int two() { return 2; }'
  }
fi

members='double a1, a2, a3, a4; std::map<int, double> b1; void b2(int, int); int b3() const { return 1; }'
members="$members $members $members enum Kind { x, y, z }; Small(int, int); Small(const Small&) = delete; double d1[3], d2, d3;"
[[ $rule != class_sizes ]] ||
  good_tree() {
    put libjet/src/small.hpp "class Small { $members };"
    put libjet/src/one.cpp 'struct Other {};' 'double Other::operator()(int) const { return 3; }'
    put libjet/src/two.cpp 'double Other::b() { return 3; }'
  }
check() { "$here/rules.sh" "$rule" "$tree" 2>&1; }

# breaks FILE LINE...: this file with these lines breaks the rule, and the report names it. Then the tree is good again.
tried=0
breaks() {
  local report was=
  [[ ! -e $tree/$1 ]] || { was=$good/${1//\//,} && cp -a "$tree/$1" "$was"; }
  put "$@"
  tried=$((tried + 1))
  if report=$(check); then
    echo "rule $rule did not notice $1: ${*:2}"
    exit 1
  elif [[ $report != *"$1"* ]]; then
    printf 'rule %s broke for another reason than %s:\n%s\n' "$rule" "$1" "$report"
    exit 1
  fi
  if [[ -n $was ]]; then mv "$was" "$tree/$1"; else rm "$tree/$1"; fi
}

good_tree
if ! check; then
  echo "rule $rule refuses the good tree"
  exit 1
fi

case $rule in
  include_rule)
    breaks libgas/src/model.cpp "$spdx" '#include "jet/model.hpp"'
    breaks libgas/include/gas/model.hpp "$spdx" '#include <membrane/model.hpp>'
    breaks libjet/src/model.cpp "$spdx" '#include "../../libgas/include/gas/model.hpp"'
    breaks libcoupling/src/model.cpp "$spdx" '  #  include "engine/step.hpp"'
    breaks libmembrane/src/model.cpp "$spdx" '#include "closed_form/membrane.hpp"'
    breaks libgas/src/model.cpp "$spdx" '#include <Eigen/Dense>'
    breaks libmembrane/include/membrane/model.hpp "$spdx" 'void f(const gas::Curve& curve);'
    breaks libjet/CMakeLists.txt 'gasjet_library(jet SOURCES a.cpp PUBLIC_LINK gasjet::gas)'
    breaks libjet/CMakeLists.txt 'target_include_directories(x PRIVATE ../libgas/include)'
    breaks libjet/include/jet/model.hpp "$spdx" '#include <CGAL/Epick.h>'
    breaks driver/engine/src/step/step.cpp "$spdx" '#include <CGAL/Epick.h>'
    breaks driver/results/src/mesh_files/reader.cpp "$spdx" '#include <CGAL/Epick.h>'
    breaks verification/closed_form/src/gas.cpp "$spdx" '#include "gas/model.hpp"'
    breaks verification/closed_form/src/gas.cpp "$spdx" '#include <boost/math/quadrature/gauss.hpp>'
    ;;
  geometry_include)
    breaks libgas/src/model.cpp "$spdx" '#include <Eigen/Core>' 'const auto n = a.cross(b);'
    breaks libgas/src/model.cpp "$spdx" 'const auto n = a->unitOrthogonal();'
    breaks libgas/include/gas/model.hpp "$spdx" 'const Eigen::AngleAxisd turn(1.0, axis);'
    ;;
  spdx)
    breaks libgas/src/model.cpp '#include <cmath>'
    breaks libgas/include/gas/model.hpp '#pragma once' "$spdx"
    breaks libgas/CMakeLists.txt 'project(gas)'
    breaks scripts/run.sh '#!/usr/bin/env bash' 'true'
    breaks scripts/plot.gp 'plot x'
    breaks driver/base/src/version.hpp.in '#pragma once'
    breaks libgas/src/model.cpp '// SPDX-License-Identifier: MIT'
    ;;
  file_size)
    mapfile -t long_text < <(yes '//' | head -301 || true)
    breaks libgas/src/model.cpp "${long_text[@]}"
    breaks scripts/run.sh "${long_text[@]}"
    ;;
  forbidden_words)
    breaks libgas/CMakeLists.txt 'target_compile_options(x PRIVATE -ffast-math)'
    breaks CMakePresets.json '{ "CMAKE_CXX_FLAGS": "-Ofast" }'
    breaks docs/stages.md 'Results are in /home/user/results.'
    breaks README.md 'See /root/gasjet/docs.'
    breaks libgas/src/model.cpp 'std::ofstream out("/tmp/trace.csv");'
    breaks libgas/src/model.cpp 'int x = 0;  // TODO: compute'
    breaks docs/stages.md 'FIXME'
    ;;
  equation_tags)
    breaks libgas/src/model.cpp '// pressure (G.99)'
    breaks libgas/src/model.cpp '// pressure (G.1, G.99)'
    breaks docs/limits.md 'by (M.97)'
    breaks docs/theory/membrane.md '$$ V = x \tag{M.98} $$'
    breaks docs/theory/membrane.md '$$ V = x \tag{M.5} $$' '$$ V = y \tag{M.5} $$'
    ;;
  links)
    breaks README.md '[gas](docs/gas.md)'
    breaks docs/theory/jet.md 'see [gas](gas.md) and ![figure](figure.svg)'
    ;;
  exact_names)
    breaks cases/tank.toml '# Closed form: `gasjet exact tank_filled`.'
    breaks scripts/chart.sh '"$build/gasjet" exact round_jet --times 0:1:0.1'
    ;;
  class_sizes)
    breaks libjet/src/small.hpp "class Small { $members int b4; };"
    breaks libjet/src/three.cpp 'struct Other {};' 'Other::Other() { }'
    ;;
  case_keys)
    breaks docs/case_files.md '| `volume` | of the tank |'
    breaks docs/case_files.md '| `volume`, `law` | of the tank |' '| `colour` | of the bag |'
    ;;
  columns)
    breaks docs/results.md '## `history.csv`' '| `pressure_Pa` | of the gas |' '## `energy.csv`' '| `strap_J` | strain |' '## `summary.json`'
    breaks docs/results.md '## `history.csv`' '| `pressure_Pa` | of the gas |' '| `inflator_*_in_kg` | mass |' '| `strap_J` | strain |' '| `colour_J` | of it |'
    ;;
  numbers)
    rung='The rung is off by 2.5 %, 11.46 degrees.'
    settles='It settles at 1.0 by order 2.0.'
    two='Two is larger by 4.988 kN, 405 times, 40419 %. It is off by 3 %.'
    breaks docs/page.md 'The force is 12.4 N.' "$two" "$rung" "$settles"
    breaks docs/page.md 'The force is twelve N.' "$two" "$rung" "$settles"
    breaks docs/page.md 'The force is 12.3 N.' "${two/4.988/4.989}" "$rung" "$settles"
    breaks docs/page.md 'The force is 12.3 N.' "${two/405/406}" "$rung" "$settles"
    breaks docs/page.md 'The force is 12.3 N.' "${two/40419/40519}" "$rung" "$settles"
    breaks docs/page.md 'The force is 12.3 N.' "${two/by 3/by 4}" "$rung" "$settles"
    breaks docs/page.md 'The force is 12.3 N.' "$two" "${rung/2.5/5.0}" "$settles"
    breaks docs/page.md 'The force is 12.3 N.' "$two" "${rung/11.46/2.86}" "$settles"
    breaks docs/charts/ladder.csv '# machine: M' '# counted from: 0' '# reference: 1' 'rung,runs,error' 'full,16,0.05'
    breaks docs/charts/ladder.csv '# machine: M' '# counted from: 3' '# reference: 1' 'rung,runs,error' 'full,9,0.05'
    breaks docs/page.md 'The force is 12.3 N.' "$two" "$rung" "${settles/1.0/2.0}"
    breaks docs/page.md 'The force is 12.3 N.' "$two" "$rung" "${settles/2.0/1.0}"
    breaks docs/report.md '| check | off |' '|---|---|' '| other | 0.03 |'
    breaks docs/table.csv 'case,force_kN' 'one,0.0125' 'two,5'
    breaks docs/table.csv 'case,force_kN' 'two,0.01234'
    breaks docs/table.csv 'case,load' 'one,0.01234' 'two,5'
    breaks docs/numbers.tsv $'docs/page.md\tforce is ([0-9.]+) N\tdocs/gone.csv\tcase=one\tforce_kN\t1000\t%.1f'
    breaks docs/levels.csv 'level,x' '1,17' '2,' '3,2'
    mapfile -t many < <(yes $'docs/page.md\tforce is ([0-9.]+) N\tdocs/table.csv\tcase=one\tforce_kN\t1000\t%.1f' | head -101 || true)
    breaks docs/numbers.tsv "${many[@]}"
    ;;
  tables)
    mapfile -t results <"$tree/results.md"
    mapfile -t rungs <"$tree/docs/rungs.md"
    mapfile -t tables <"$tree/docs/tables.tsv"
    breaks results.md "${results[@]/12.3/12.4}"
    breaks results.md "${results[@]/two | none/one | none}"
    breaks results.md "${results[@]/'<!-- end of table forces -->'/End}"
    breaks results.md "${results[@]/'<!-- table forces -->'/<!-- table force -->}"
    breaks results.md "${results[@]/'<!-- end of table forces -->'/End}" "${results[@]}"
    breaks results.md "${results[@]:0:8}" "${results[@]:9}"
    breaks docs/rungs.md "${rungs[@]/0123abc/0123abd}"
    breaks docs/rungs.md "${rungs[@]/| 2.5/| 2.4}"
    breaks docs/table.csv 'case,force_kN' 'two,5'
    breaks docs/table.csv 'case,force_kN' 'one,' 'two,5'
    breaks docs/table.csv 'case,load' 'one,0.01234' 'two,5'
    breaks docs/levels.csv 'level,x' '1,17' '1,5'
    breaks docs/tables.tsv "${tables[@]/1f %.0f/1f %.0f %.0f %.0f}"
    breaks docs/tables.tsv "${tables[@]/docs\/levels.csv/docs/gone.csv}"
    breaks docs/tables.tsv "${tables[@]/100\/reference/100/references}"
    breaks docs/tables.tsv "${tables[@]/none/none$'\t'more}"
    breaks docs/tables.tsv "${tables[@]/x||docs\/levels.csv\}/x}"
    breaks docs/tables.tsv "${tables[@]}" $'rows\tall\tfull\t1\t%.1f'
    breaks docs/tables.tsv "${tables[@]}" "${tables[@]}"
    breaks docs/tables.tsv "${tables[@]/1000$'\t'%.1f %.0f/1000$'\t'}"
    breaks docs/tables.tsv "${tables[@]/1000$'\t'%.1f %.0f/1000$'\t'%.1x}"
    breaks docs/tables.tsv "${tables[@]}" $'table\tspare\tdocs/table.csv'
    ;;
  table_heads)
    version='# gasjet 0.1.0 (0123abc, GNU 12, Release -O3)'
    breaks docs/charts/bag.csv 'x' '1'
    breaks docs/charts/bag.csv "$version" 'x' '1'
    breaks docs/charts/bag.csv '# machine: M, 2 cores' 'x' "$version" '1'
    breaks docs/figures/bag.csv '# machine: M, 2 cores' '# gasjet 0.1.0 (unknown, GNU 12, Release -O3)' 'x' '1'
    breaks docs/charts/ladder.csv '# machine: M' '# commit: 0123abc' '# compiler: GNU 12' 'rung,error' 'full,0.05'
    breaks docs/charts/bag.csv '# machine: M, 2 cores' '# gasjet 0.1.0 (0123abc-dirty, GNU 12, Release -O3)' 'x' '1'
    breaks docs/charts/ladder.csv '# machine: ' '# commit: 0123abc' '# compiler: GNU 12' '# flags: -O3' 'rung,error' 'full,0.05'
    mapfile -t lines <"$tree/docs/provenance.tsv"
    breaks docs/figures/bag.jpg 'JFIF'
    breaks docs/provenance.tsv "${lines[@]:0:4}"
    breaks docs/provenance.tsv "${lines[@]}" $'docs/charts/gone.csv\tscripts/run.sh\t@bag'
    breaks docs/provenance.tsv "${lines[@]//scripts\/run.sh/scripts/gone.sh}"
    breaks docs/provenance.tsv "${lines[@]/libgas/libgone}"
    breaks docs/provenance.tsv "${lines[@]/@bag cases/@jet cases}"
    breaks docs/provenance.tsv "${lines[@]/@bag cases\/tank.toml/}"
    ;;
  format)
    breaks libgas/src/model.cpp "$spdx" '#include "gas/model.hpp"' 'int  two(){ return 2; }'
    ;;
  versions)
    breaks CITATION.cff 'version: 1.2.4' 'date-released: 2026-01-02'
    breaks CITATION.cff 'version: 1.2.3' 'date-released: 2026-01-01'
    breaks CITATION.cff 'version: 1.2.3'
    breaks CHANGELOG.md '## Unreleased' '## 1.2.4 (2026-01-03)' '## 1.2.3 (2026-01-02)'
    breaks docs/versions.md '| program and libraries | 1.2.3 | x |' '| case files | 2 |' '| result files | 3 |' '| JSON of commands | 6 |' '| reference data | 4 |'
    breaks docs/versions.md '| program and libraries | 1.2.3 | x |' '| case files | 2 |' '| JSON of commands | 5 |' '| reference data | 4 |'
    breaks docs/versions.md '| program and libraries | 1.2.2 | x |' '| case files | 2 |' '| result files | 3 |' '| JSON of commands | 5 |' '| reference data | 4 |'
    breaks docs/versions.md '| program and libraries | 1.2.3 | x |' '| case files | 2 |' '| result files | 3 |' '| JSON of commands | 5 |' '| reference data | 5 |'
    breaks cases/pulse.toml '[scene]' 'format = 1'
    breaks verification/schemas/scene.schema.json '    "format": { "const": 4, "description": "x" },'
    breaks libgas/CMakeLists.txt '# SPDX-License-Identifier: Apache-2.0' 'project(gasjet_gas VERSION 1.2.3 LANGUAGES CXX)'
    ;;
  mutation_lines)
    mapfile -t many < <(printf 'gas.tank\tREADME.md\ts/gas/%s/\n' {1..201})
    breaks verification/mutations.tsv "${many[@]}"
    breaks verification/mutations.tsv $'bad_input.*/inf( |$)\tREADME.md\ts/gas/b/'
    breaks verification/mutations.tsv $'.*\tREADME.md\ts/gas/b/' $'jet.plume\tREADME.md\ts/gas/b/'
    breaks verification/mutations.tsv $'.*\tREADME.md\ts/absent/b/'
    breaks verification/mutations.tsv $'.*\tgone.cpp\ts/gas/b/'
    ;;
  ablation_lines)
    breaks benchmarks/ablation.tsv $'gas lines\tREADME.md\ts/absent/b/\twhat happens'
    breaks benchmarks/ablation.tsv $'gas lines\tgone.cpp\ts/gas/b/\twhat happens'
    ;;
  *)
    echo "rules_can_fail.sh: no violations are listed for rule '$rule'"
    exit 2
    ;;
esac
echo "rule $rule noticed each of $tried violations"
