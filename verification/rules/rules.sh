#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The rules that the source tree keeps, one function each. A rule prints every violation as `file:line: what`.
# usage: rules.sh RULE [ROOT [BUILD]]; exit code 0: kept, 1: broken, 2: no such rule
set -euo pipefail
shopt -s extglob

rule=${1:?usage: rules.sh RULE [ROOT [BUILD]]}
root=${2:-$(dirname "${BASH_SOURCE[0]}")/../..}
build=${3:-build}
scripts=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../scripts" && pwd)
# shellcheck source=../../scripts/pages/source_number.sh
source "$scripts/pages/source_number.sh"
cd "$root"
max_file_lines=300
max_numbers=100    # in sentences: what a table says is not said again
max_mutations=200  # by hand

# files NAME_PATTERN...: every file of the tree with such a name; build folders, results and these rules left out.
files() {
  local names=() pattern
  for pattern in "$@"; do names+=(-o -name "$pattern"); done
  find . \( -path './build*' -o -path ./results -o -path ./.git -o -path ./verification/rules \) -prune \
    -o -type f \( "${names[@]:1}" \) -print | sed 's|^\./||' | LC_ALL=C sort
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

# check_includes FOLDER ALLOWED_PREFIX...: the files under FOLDER include their own headers, the standard library
# (a name without a folder), the compiler's intrinsics and the packages named, nothing else.
check_includes() {
  local folder=$1 place header prefix allowed file
  shift
  while IFS= read -r line; do
    file=${line%%:*} header=${line#*:*:} place=${line%:"$header"} allowed=no
    if [[ $header == \"* ]]; then
      quoted_is_own "$file" "${header:1}" "$folder" && allowed=yes
    elif [[ $header == '<'@(+([a-z0-9_])|[a-z]mmintrin.h) ]]; then
      allowed=yes
    else
      for prefix in "$@"; do [[ $header == "<$prefix"/* ]] && allowed=yes; done
    fi
    [[ $allowed == yes ]] || echo "$place: includes ${header:1}: allowed are $folder, the standard library${*:+, $*}"
  done < <(mapfile -t list < <(cpp_files | grep -E "^$folder/(include|src)/"); includes "${list[@]}")
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
  local libraries=(gas membrane jet coupling) name other list
  check_includes libgas boost gsl
  check_includes libmembrane Eigen experimental
  check_includes libjet Eigen CGAL experimental
  check_includes libcoupling Eigen experimental
  check_includes verification/closed_form gsl
  for name in "${libraries[@]}"; do
    other=$(printf '%s\n' "${libraries[@]}" closed_form driver | grep -vx "$name" | paste -sd '|')
    mapfile -t list < <(cpp_files | grep -E "^lib$name/")
    ((${#list[@]} == 0)) || code_matches "\\b($other)::" "${list[@]}" | sed 's/$/   (names another library)/'
    code_matches "\\b(gasjet::|gasjet_|lib)($other)\\b" "lib$name/CMakeLists.txt" | sed 's/$/   (links another library)/'
  done
  mapfile -t list < <(cpp_files | grep -vE '^(libjet/src/.*\.cpp|driver/src/mesh_files/soup\.cpp|verification/|benchmarks/)')
  includes "${list[@]}" | { grep '<CGAL/' || true; } | sed 's|$|> (CGAL belongs in .cpp files of libjet/src and in driver/src/mesh_files/soup.cpp)|'
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
  local definitions defined list place line tag
  definitions=$(grep -HnoE '\\tag\{[GMJK]\.[0-9]+\}' docs/theory/*.md)
  awk -F: 'seen[$3]++ { print $0 ": equation defined twice" }' <<<"$definitions"
  defined=$(sed -E 's/.*\{(.*)\}/\1/' <<<"$definitions")
  mapfile -t list < <(cpp_files; files '*.md' '*.toml')
  { grep -HnoE '(^|[^A-Za-z0-9_.])[GMJK]\.[0-9]+' "${list[@]}" || true; } |
    awk 'NR == FNR { is_defined[$0]; next }
         { match($0, /[GMJK]\.[0-9]+$/) }
         !(substr($0, RSTART) in is_defined) { print $0 ": no such equation in docs/theory" }' <(echo "$defined") -
  mapfile -t list < <(cpp_files)
  while IFS=: read -r place line tag; do
    tag=${tag//[^GMJK.0-9]/}
    [[ -z $tag ]] || grep -qE "[(, ]${tag/./[.]}[),]" "${list[@]}" /dev/null || echo "$place:$line: no code names equation $tag"
  done <<<"$definitions"
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
  { grep -HnoE 'gasjet"? exact [a-z0-9_]+' "${list[@]}" || true; } | while IFS= read -r line; do
    grep -qxF "${line##* }" <<<"$known" || echo "$line: no such closed form in docs/exact.md"
  done
}

# Every key that the driver reads from a case has a row in docs/case_files.md, and every row's key is read there.
rule_case_keys() {
  local list
  mapfile -t list < <(cpp_files | grep '^driver/src/' | grep -v '^driver/src/study/')
  keys_have_rows docs/case_files.md <(cat docs/case_files.md) "${list[@]}"
  mapfile -t list < <(cpp_files | grep '^driver/src/study/')
  keys_have_rows docs/study.md <(sed -n '/^## The plan/,/^## Designs/p' docs/study.md) "${list[@]}"
}

# keys_have_rows PAGE TEXT FILE...: the keys that the files read are those of the rows in the text of the page
keys_have_rows() {
  local page=$1 read_keys rows key
  rows=$(grep -E '^\| `' "$2" | cut -d'|' -f2 | grep -oE '[a-z_0-9]+' | sort -u)
  read_keys=$(cat "${@:3}" | tr -d '\n' |
    grep -oE '[^a-z_](number|optional_number|integer|flag|texts?|numbers|elements|vector|curve|composition|choice(<[A-Za-z_:]+>)?|table|optional_table|tables)\([[:space:]]*"[a-z_0-9]+"|\(\*?(table|reader|base), "[a-z_0-9]+"|\{"[a-z_0-9]+", &Options::' |
    grep -oE '"[a-z_0-9]+"' | tr -d '"' | sort -u)
  for key in $(comm -23 <(echo "$read_keys") <(echo "$rows")); do echo "$page: no row for the key $key"; done
  for key in $(comm -13 <(echo "$read_keys") <(echo "$rows")); do echo "$page: no code reads the key $key"; done
}

# Every column of the history and of the energy file has a row in docs/results.md, and every row's column is one.
rule_columns() {
  local page=docs/results.md columns rows name
  columns=$(cat driver/src/results/history_columns.cpp driver/src/results/energy_columns.cpp | tr -d '\n' |
    grep -oE '\{"[A-Za-z0-9_]+", |add\([^,]*, ' |
    sed -E 's/^\{//; s/^add\(//; s/, $//; s/vent \+/"vent_*" +/; s/" \+ [^"]* \+ "/*/g; s/" \+ "//g; s/"//g' | sort -u)
  rows=$(sed -nE '/^## .(history|energy)/,/^## .summary/ s/^\| `([^`]+)`.*/\1/p' "$page" | sort -u)
  for name in $(comm -23 <(echo "$columns") <(echo "$rows") | tr '*' '?'); do echo "$page: no row for the column $name"; done
  for name in $(comm -13 <(echo "$columns") <(echo "$rows") | tr '*' '?'); do echo "$page: no such column as $name"; done
}

# Every line of mutations.tsv matches a test of the build and changes its file.
rule_mutation_lines() {
  local list=verification/mutations.tsv names
  names=$(ctest --test-dir "$build" -N </dev/null | sed -nE 's/^ *Test +#[0-9]+: //p' | grep -v '_NOT_BUILT$')
  grep -nv -e '^#' -e '^[[:space:]]*$' "$list" | while IFS=$'\t' read -r name file expression; do
    grep -qE -e "${name#*:}" <<<"$names" || echo "$list:${name%%:*}: '${name#*:}' matches no test"
    sed -e "$expression" "$file" 2>/dev/null | cmp -s "$file" - && echo "$list:${name%%:*}: '$expression' changes nothing in $file"
    [[ -f $file ]] || echo "$list:${name%%:*}: no file $file"
  done
  grep -cv -e '^#' -e '^[[:space:]]*$' "$list" | awk -v most="$max_mutations" -v list="$list" \
    '$1 > most { print list ": " $1 " lines, " most " at most: what is no error of physics is left to scripts/tests/random_mutations.py" }'
}

# Every table of the pages says first what it was made on and by: machine, commit, compiler and flags; docs/provenance.tsv has a line for
# it and for every figure, and names files that there are.
rule_table_heads() {
  local list=docs/provenance.tsv file script paths path head part
  for file in docs/charts/*.csv docs/figures/*.csv; do
    [[ -f $file ]] || continue
    head=$(sed '/^#/!q' "$file" | sed -E 's/^# gasjet [^ ]+ \(([0-9a-f]+[^,]*), ([^,]+), ([^)]+)\)$/# commit: \1\n# compiler: \2\n# flags: \3/')
    for part in machine commit compiler flags; do
      grep -qE "^# $part: ." <<<"$head" || echo "$file:1: the lines above the columns do not name its $part (scripts/charts/provenance.sh)"
    done
    ! grep -q -- '-dirty' <<<"$head" || echo "$file:1: made by a build of changed sources, of which no commit tells"
  done
  for file in docs/charts/* docs/figures/*; do
    [[ ! -f $file || $file == */README.md ]] || cut -f1 "$list" | grep -qxF -- "$file" ||
      echo "$list: no line for $file: add the file, the script that makes it and the code that it depends on (tabs between)"
  done
  while IFS=$'\t' read -r file script paths; do
    [[ -n $file && $file != \#* ]] || continue
    [[ $file == @* || -f $file && -f $script ]] || echo "$list: $file by '$script': no such files"
    [[ -n $paths ]] || echo "$list: $file depends on nothing"
    for path in $paths; do
      if [[ $path == @* ]]; then cut -f1 "$list" | grep -qxF -- "$path"; else [[ $path == ':('* || -e $path ]]; fi ||
        echo "$list: $file depends on $path: no such file or line"
    done
  done <"$list"
}

# Each number that docs/numbers.tsv lists says what its source file says.
rule_numbers() {
  local page pattern source row column scale format number=0 says
  while IFS=$'\t' read -r page pattern source row column scale format; do
    number=$((number + 1))
    [[ -n $page && $page != \#* ]] || continue
    if [[ ! -f $page || ! -f $source || -z $format ]]; then
      echo "docs/numbers.tsv:$number: $page, $source: seven columns and two files of the tree are needed"
      continue
    fi
    says=$(sed -nE "s@.*$pattern.*@\\1@p" "$page")
    [[ $says == "$(source_number "$source" "$row" "$column" "$scale" "$format")" ]] ||
      echo "$page: '$pattern' says '$says', $source ($row, $column): $(source_number "$source" "$row" "$column" "$scale" "$format")"
  done <docs/numbers.tsv
  number=$(grep -c '^[^#]' docs/numbers.tsv)
  ((number <= max_numbers)) || echo "docs/numbers.tsv: $number numbers in sentences, allowed are $max_numbers: let a table say them (docs/tables.tsv)"
}

# Each table that docs/tables.tsv lists is in a page and says what its CSV files say.
rule_tables() {
  "$scripts/pages/write_tables.sh" --check "$PWD" 2>&1 || echo "docs/tables.tsv: scripts/pages/write_tables.sh writes the tables anew"
}

# CITATION, changelog, docs/versions.md and schemas say the versions that cmake/GasjetVersion.cmake, formats.hpp and the reference data have.
rule_versions() {
  local version date name now page=docs/versions.md formats=driver/include/driver/formats.hpp list
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
