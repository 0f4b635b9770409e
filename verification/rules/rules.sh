#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The rules that the source tree keeps, one function each. A rule prints every violation as `file:line: what`.
# usage: rules.sh RULE [ROOT [BUILD]]; exit code 0: kept, 1: broken, 2: no such rule
set -euo pipefail
shopt -s extglob

rule=${1:?usage: rules.sh RULE [ROOT [BUILD]]}
rules=$(cd "${BASH_SOURCE[0]%/*}" && pwd)
root=${2:-$rules/../..}
build=${3:-build}
scripts=$rules/../../scripts
cd "$root"
max_file_lines=300
max_numbers=100    # in sentences: what a table says is not said again
max_mutations=200  # by hand

# files NAME_PATTERN...: every file of the tree with such a name; build folders, results and these rules left out.
files() {
  local names=() pattern
  for pattern in "$@"; do names+=(-o -name "$pattern"); done
  find . \( -path './build*' -o -path ./results -o -path ./.git -o -path ./verification/rules \) -prune \
    -o -type f \( "${names[@]:1}" \) -printf '%P\n' | LC_ALL=C sort
}

cpp_files() { files '*.cpp' '*.hpp' '*.h' '*.cpp.in' '*.hpp.in'; }
cmake_files() { files CMakeLists.txt '*.cmake' CMakePresets.json; }
script_files() { files '*.sh' '*.gp' run; }

# includes FILES...: lines `file:line:<header` or `file:line:"header`.
includes() {
  (($# == 0)) && return
  { grep -HnE '^[[:space:]]*#[[:space:]]*include\b' "$@" || true; } |
    sed -E 's/^([^:]*:[0-9]+):[[:space:]]*#[[:space:]]*include[[:space:]]*([<"][^>"]*)[>"].*/\1:\2/'
}

# quoted_is_own FILE HEADER OWN_FOLDER: a header of the library itself, found where the compiler finds it.
quoted_is_own() {
  [[ $2 != *..* ]] && { [[ -e $3/include/$2 ]] || [[ -e $3/src/$2 ]] || [[ -e ${1%/*}/$2 ]]; }
}

# check_include PLACE FILE HEADER FOLDER PREFIX...: a file of the library in FOLDER includes its own headers, the standard library
# (a name without a folder), the compiler's intrinsics and the packages named, nothing else.
check_include() {
  local place=$1 file=$2 header=$3 folder=$4 prefix
  shift 4
  if [[ $header == \"* ]]; then
    quoted_is_own "$file" "${header:1}" "$folder" && return
  else
    [[ $header != '<'@(+([a-z0-9_])|[a-z]mmintrin.h) ]] || return 0
    for prefix in "$@"; do [[ $header != "<$prefix"/* ]] || return 0; done
  fi
  echo "$place: includes ${header:1}: allowed are $folder, the standard library${*:+, $*}"
}

# chosen PATTERN FILE...: sets `list` to the files that match, without a process, which costs more than a rule's whole work.
chosen() {
  local file
  list=()
  for file in "${@:2}"; do [[ ! $file =~ $1 ]] || list+=("$file"); done
}

# code_matches PATTERN FILES...: lines `file:line:code` that match once comments are taken off.
code_matches() {
  (($# < 2)) || perl -ne '
    BEGIN { $pattern = shift }
    $ARGV =~ /[.](cpp|hpp|h)([.]in)?$/ ? s{//.*}{} : s{(^|\s)#.*}{};
    print "$ARGV:$.:$_" if /$pattern/;
    close ARGV if eof' -- "$@"
}

rule_include_rule() {
  local cpp list line place file header folder others='(gas|membrane|jet|coupling|closed_form|driver)'
  mapfile -t cpp < <(cpp_files)
  while IFS= read -r line; do
    file=${line%%:*} header=${line#*:*:} place=${line%:"${line#*:*:}"}
    folder=${file%/@(include|src)/*}
    case $folder in
      libgas) check_include "$place" "$file" "$header" "$folder" elementary boost gsl ;;
      libjet) check_include "$place" "$file" "$header" "$folder" elementary Eigen CGAL experimental ;;
      libmembrane | libcoupling) check_include "$place" "$file" "$header" "$folder" elementary Eigen experimental ;;
      verification/closed_form) check_include "$place" "$file" "$header" "$folder" gsl ;;
    esac
    [[ $header != '<CGAL/'* || $file == @(libjet/src/*.cpp|driver/results/src/mesh_files/soup.cpp|driver/results/src/crossing/exact.cpp|verification/*|benchmarks/*) ]] ||
      echo "$place: includes ${header:1} (CGAL belongs in .cpp files of libjet/src, in driver/results/src/mesh_files/soup.cpp and driver/results/src/crossing/exact.cpp)"
  done < <(includes "${cpp[@]}")
  chosen '^lib(gas|membrane|jet|coupling)/' "${cpp[@]}"
  { code_matches "\\b${others}::" "${list[@]}" | grep -P "^lib(\w+)/[^:]*:\d+:.*\b(?!\1::)${others}::" || true; } |
    sed 's/$/   (names another library)/'
  { code_matches "\\b(gasjet::|gasjet_|lib)${others}\\b" lib{gas,membrane,jet,coupling}/CMakeLists.txt |
    grep -P "^lib(\w+)/[^:]*:\d+:.*\b(gasjet::|gasjet_|lib)(?!\1\b)${others}\b" || true; } | sed 's/$/   (links another library)/'
}

# Whoever calls Eigen's geometry includes it. Without that, a file builds only behind another one that does, as in a
# unity build.
rule_geometry_include() {
  local list
  mapfile -t list < <(cpp_files | grep -v '^verification/')  # tests have it from the headers that they share
  code_matches '([.]|->)(cross|unitOrthogonal)\(|\b(AngleAxisd|Quaterniond)\b' "${list[@]}" | sed -E 's/^([^:]*):([0-9]+):.*/\1 \2/' |
    awk '!seen[$1]++' | while read -r file line; do
      grep -qE '<Eigen/(Geometry|Dense)>' "$file" || echo "$file:$line: calls Eigen's geometry: include <Eigen/Geometry>"
    done
}

rule_spdx() {
  local list
  mapfile -t list < <(cpp_files; cmake_files | grep -v '\.json$'; script_files)
  perl -ne '
    next if $. == 1 && /^#!/;
    print "$ARGV:1: does not begin with the line SPDX-License-Identifier: Apache-2.0\n" unless m{^(//|#) SPDX-License-Identifier: Apache-2\.0$};
    close ARGV;' -- "${list[@]}"
}

rule_file_size() {
  local list
  mapfile -t list < <(cpp_files; cmake_files; script_files)
  wc -l -- "${list[@]}" | awk -v most="$max_file_lines" '$2 != "total" && $1 > most { print $2 ":" $1 ": more than " most " lines" }'
}

# Every C++ file is as clang-format writes it.
rule_format() {
  local list
  mapfile -t list < <(cpp_files | grep -v '\.in$')
  clang-format --dry-run "${list[@]}" 2>&1 | grep 'warning:' || true
}

# A class has at most 25 members, and its functions are in at most two .cpp files.
rule_class_sizes() {
  local list
  mapfile -t list < <(cpp_files | grep -E '^(lib[a-z]+|driver|bindings)/.*[.][chp]+$')
  /usr/bin/python3 "$rules/class_sizes.py" "${list[@]}"
}

# Compiler options that change values, paths of one machine, unfinished work.
rule_forbidden_words() {
  local list
  mapfile -t list < <(cpp_files; cmake_files; script_files)
  code_matches '-(ffast-math|Ofast|funsafe-math-optimizations|fassociative-math|ffinite-math-only)' "${list[@]}"
  mapfile -t list < <(files '*.cpp' '*.hpp' '*.h' '*.in' CMakeLists.txt '*.cmake' '*.json' '*.sh' '*.gp' run '*.md' '*.toml' '*.tsv' '*.csv')
  grep -HnE '(^|[^A-Za-z0-9_./$}-])/(work|home|root|tmp|Users|mnt)/' "${list[@]}" || true
  grep -HnwE 'TODO|FIXME|XXX' "${list[@]}" || true
}

# Every tag such as (G.3) in code, pages and cases is an equation of docs/theory, each of those is named in the code, and none is
# defined twice.
rule_equation_tags() {
  local definitions defined list
  definitions=$(grep -HnoE '\\tag\{[GMJK]\.[0-9]+\}' docs/theory/*.md)
  awk -F: 'seen[$3]++ { print $0 ": equation defined twice" }' <<<"$definitions"
  defined=$(sed -E 's/.*\{(.*)\}/\1/' <<<"$definitions")
  mapfile -t list < <(cpp_files; files '*.md' '*.toml')
  { grep -HnoE '(^|[^A-Za-z0-9_.])[GMJK]\.[0-9]+' "${list[@]}" || true; } |
    awk 'NR == FNR { is_defined[$0]; next }
         { match($0, /[GMJK]\.[0-9]+$/) }
         !(substr($0, RSTART) in is_defined) { print $0 ": no such equation in docs/theory" }' <(echo "$defined") -
  mapfile -t list < <(cpp_files)
  { grep -hoP '(?<=[(, ])[GMJK]\.[0-9]+(?=[),])' "${list[@]}" /dev/null || true; } |
    awk -F: 'NR == FNR { is_named[$0]; next }
             { tag = $3; gsub(/[^GMJK.0-9]/, "", tag) }
             tag != "" && !(tag in is_named) { print $1 ":" $2 ": no code names equation " tag }' - <(echo "$definitions")
}

# Every relative link of a Markdown file, code blocks aside, leads to a file of the tree.
rule_links() {
  local place target file list
  mapfile -t list < <(files '*.md')
  awk 'FNR == 1 { code = 0 }
       /^```/ { code = !code }
       !code { text = $0
               while (match(text, /\]\([^)]+\)/)) {
                 print FILENAME ":" FNR " " substr(text, RSTART + 2, RLENGTH - 3)
                 text = substr(text, RSTART + RLENGTH) } }' "${list[@]}" |
    while read -r place target; do
      file=./${place%:*} # no process for each link: there are thousands
      [[ $target == *://* || $target == '#'* || -e ${file%/*}/${target%%#*} ]] || echo "$place: no file $target"
    done
}

# Every closed form that a text, a case or a script names as `gasjet exact NAME` is in the catalogue.
rule_exact_names() {
  local list known
  known=$(sed -nE 's/^\*\*`([a-z0-9_]+)`\*\*:.*/\1/p' docs/exact.md)
  mapfile -t list < <(files '*.md' '*.toml' '*.sh' '*.csv' | grep -v '^verification/')  # tests name absent ones
  { grep -HnoE 'gasjet"? exact [a-z0-9_]+' "${list[@]}" || true; } |
    awk 'NR == FNR { is_known[$0]; next } !($NF in is_known) { print $0 ": no such closed form in docs/exact.md" }' <(echo "$known") -
}

# Every key that the driver reads from a case has a row in docs/case_files.md, and every row's key is read there.
rule_case_keys() {
  local list
  mapfile -t list < <(cpp_files | grep -E '^driver/(base|engine|compare)/')
  keys_have_rows docs/case_files.md <(cat docs/case_files.md) "${list[@]}"
  mapfile -t list < <(cpp_files | grep -E '^driver/many_runs/src/study/(plan|design)')
  keys_have_rows docs/study.md <(sed -n '/^## The plan/,/^## Designs/p' docs/study.md) "${list[@]}"
}

# keys_have_rows PAGE TEXT FILE...: the keys that the files read are those of the rows in the text of the page
keys_have_rows() {
  local page=$1 read_keys rows key
  rows=$(grep -E '^\| `' "$2" | cut -d'|' -f2 | grep -oE '[a-z_0-9]+' | sort -u)
  read_keys=$(cat "${@:3}" | tr -d '\n' |
    grep -oE '[^a-z_](at|number|table|optional_table|tables)\([[:space:]]*"[a-z_0-9]+"|\(\*?(table|reader|base), "[a-z_0-9]+"|\{"[a-z_0-9]+", &Options::' |
    grep -oE '"[a-z_0-9]+"' | tr -d '"' | sort -u)
  for key in $(comm -23 <(echo "$read_keys") <(echo "$rows")); do echo "$page: no row for the key $key"; done
  for key in $(comm -13 <(echo "$read_keys") <(echo "$rows")); do echo "$page: no code reads the key $key"; done
}

# Every column of the history and of the energy file has a row in docs/results.md, and every row's column is one.
rule_columns() {
  local page=docs/results.md columns rows name
  columns=$(cat driver/engine/src/columns/history_columns.cpp driver/engine/src/columns/energy_columns.cpp | tr -d '\n' |
    grep -oE '\{"[A-Za-z0-9_]+", |add\([^,]*, ' |
    sed -E 's/^\{//; s/^add\(//; s/, $//; s/vent \+/"vent_*" +/; s/" \+ [^"]* \+ "/*/g; s/" \+ "//g; s/"//g' | sort -u)
  rows=$(sed -nE '/^## .(history|energy)/,/^## .summary/ s/^\| `([^`]+)`.*/\1/p' "$page" | sort -u)
  for name in $(comm -23 <(echo "$columns") <(echo "$rows") | tr '*' '?'); do echo "$page: no row for the column $name"; done
  for name in $(comm -13 <(echo "$columns") <(echo "$rows") | tr '*' '?'); do echo "$page: no such column as $name"; done
}

# Every line of mutations.tsv and of the gas's safeguards matches a test of the build and changes its file.
rule_mutation_lines() {
  local list tests
  tests=$(ctest --test-dir "$build" -N </dev/null | sed -nE 's/^ *Test +#[0-9]+: //p' | grep -v '_NOT_BUILT$')
  for list in verification/mutations.tsv verification/gas/safeguards.tsv; do
    [[ ! -f $list ]] || perl "$rules/mutation_lines.pl" "$list" "$max_mutations" <<<"$tests"
  done
}

# Every line of ablation.tsv still turns its heuristic off: it changes its file.
rule_ablation_lines() {
  sed -nE 's/^([^#\t]+)\t.*/\1/p' benchmarks/ablation.tsv | perl "$rules/mutation_lines.pl" benchmarks/ablation.tsv 100
}

# Every table of the pages says first what it was made on and by: machine, commit, compiler and flags; docs/provenance.tsv has a line for
# it and for every figure, and names files that there are.
rule_table_heads() {
  perl "$rules/table_heads.pl" docs/provenance.tsv
}

# Each number that docs/numbers.tsv lists says what its source file says.
rule_numbers() {
  awk -F'\t' -f "$rules/../../docs/make/pages/csv_number.awk" -f <(echo '{ print /^#/ || NF < 7 ? "" : formatted($3, $4, $5, $6, $7) }') docs/numbers.tsv |
    perl "$rules/numbers.pl" docs/numbers.tsv "$max_numbers"
}

# Each table that docs/tables.tsv lists is in a page and says what its CSV files say.
rule_tables() {
  "$rules/../../docs/make/pages/write.sh" --check "$PWD" 2>&1 || echo "docs/tables.tsv: docs/make/pages/write.sh writes the tables anew"
}

# CITATION, changelog, docs/versions.md, shipped cases and schemas say the versions that cmake/GasjetVersion.cmake, formats.hpp and the reference data have.
rule_versions() {
  local version date name now page=docs/versions.md formats=driver/base/include/base/formats.hpp list
  version=$(sed -nE 's/^set\(GASJET_VERSION ([0-9.]+)\)$/\1/p' cmake/GasjetVersion.cmake)
  date=$(sed -nE "s/^## ${version//./[.]} \(([0-9-]+)\)$/\1/p" CHANGELOG.md)
  [[ $(sed -nE 's/^## ([0-9].*) \(.*/\1/p' CHANGELOG.md | head -1) == "$version" ]] || echo "CHANGELOG.md: the newest release is not $version"
  [[ $(sed -n 's/^version: //p' CITATION.cff) == "$version" ]] || echo "CITATION.cff: the version is not $version"
  [[ -n $date && $(sed -n 's/^date-released: //p' CITATION.cff) == "$date" ]] || echo "CITATION.cff: the date is not '$date', that of CHANGELOG.md"
  while IFS='|' read -r name now; do
    [[ $(sed -nE "s/^\| $name \| ([^ ]+) \|.*/\1/p" $page) == "$now" ]] || echo "$page: '$name' is not '$now'"
  done < <(echo "program and libraries|$version"; echo "reference data|$(cat cases/reference/VERSION)"
    sed -nE 's/^inline constexpr int (case_file|results|json) = ([0-9]+);.*/\1|\2/p' $formats |
      sed 's/^case_file/case files/; s/^results/result files/; s/^json/JSON of commands/')
  for name in verification/schemas/*.json; do
    now=$(sed -nE 's/^inline constexpr int json = ([0-9]+);.*/\1/p' $formats)
    grep -qE "^    \"format\": \{ \"const\": $now," "$name" || echo "$name: its format is not $now"
  done
  now=$(sed -nE 's/^inline constexpr int case_file = ([0-9]+);.*/\1/p' $formats)
  mapfile -t list < <(files '*.toml' | grep '^cases/' | xargs grep -l '^\[scene\]')
  for name in "${list[@]}"; do
    grep -qx "format = $now" "$name" || echo "$name: says no format = $now"
  done
  mapfile -t list < <(cmake_files)
  code_matches 'VERSION [0-9]+\.[0-9]+\.[0-9]' "${list[@]}" | grep project | sed 's/$/   (the version stands in cmake\/GasjetVersion.cmake alone)/' || true
}

if [[ $(type -t "rule_$rule") != function ]]; then
  echo "rules.sh: no rule '$rule'" >&2
  exit 2
fi
violations=$("rule_$rule")
if [[ -n $violations ]]; then
  printf '%s\nrule %s is broken: %d violations\n' "$violations" "$rule" "$(wc -l <<<"$violations")"
  exit 1
fi
echo "rule $rule is kept"
