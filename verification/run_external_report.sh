# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2154
# The reports of run_external.sh (sourced): report.json and junit.xml of the folder $work.

# verdicts SCENE: lines `column<tab>verdict<tab>reason` of the columns that were judged, from the JSON of `gasjet compare`
verdicts() {
  awk '
    function text(line) { sub(/^[^:]*: "/, "", line); sub(/",?$/, "", line); gsub(/\\"/, "\"", line); gsub(/\\\\/, "\\", line); return line }
    /^    "[^"]*": \{$/ { name = $1; gsub(/[":]/, "", name) }
    /^      "verdict": / { verdict = text($0) }
    /^      "reason": / { if (verdict != "not judged") printf "%s\t%s\t%s\n", name, verdict, text($0) }' "$work/$1.verdict.json" 2>/dev/null
}

# columns_not_inside SCENE: one line for each, if there are more than the one that the verdict names
columns_not_inside() {
  verdicts "$1" | awk -F'\t' '$2 != "inside" { line[++n] = "  " $2 ": " $1 ": " $3 } END { for (i = 1; n > 1 && i <= n; i++) print line[i] }'
}

# escaped TEXT FROM TO...: sets `text` to TEXT with each FROM replaced. No process: texts are many.
escaped() {
  text=$1
  shift
  while (($#)); do
    text=${text//"$1"/"$2"}
    shift 2
  done
  text=${text//[[:cntrl:]]/}
}
json_text() { escaped "$1" '\' '\\' '"' '\"' $'\t' ' ' $'\n' '\n' && text="\"$text\""; }
xml_text() { escaped "$1" '&' '&amp;' '<' '&lt;' '>' '&gt;' '"' '&quot;' $'\t' ' ' $'\n' ' '; }

report_parts='' suites='' # JSON objects and <testsuite> elements, one for each scene

# report_scene SCENE SECONDS STATUS REASON: status is judged, failed or `not done`
report_scene() {
  local comparison=null state=$3 text
  [[ -n $out ]] || return 0
  if [[ $state == judged ]]; then
    if [[ -s $work/$1.verdict.json ]]; then comparison=$(sed '2,$s/^/    /' "$work/$1.verdict.json"); else state=failed; fi
  fi
  [[ -z $report_parts ]] || report_parts+=$',\n'
  json_text "$4"
  report_parts+="    { \"scene\": \"$1\", \"status\": \"$state\", \"seconds\": $2, \"message\": $text, \"comparison\": $comparison }"
  suites+=$(junit_suite "$1" "$2" "$state" "$4")$'\n'
}

# junit_suite SCENE SECONDS STATUS REASON: a test for each judged column; one named `run` where nothing was judged
junit_suite() {
  local column verdict reason text cases='' tests=0 failures=0 errors=0 skipped=0
  case $3 in
    judged)
      while IFS=$'\t' read -r column verdict reason; do
        tests=$((tests + 1))
        xml_text "$column"
        cases+="    <testcase classname=\"$1\" name=\"$text\""
        if [[ $verdict == inside ]]; then cases+=$'/>\n'; continue; fi
        failures=$((failures + 1))
        xml_text "$reason"
        cases+="><failure type=\"$verdict\" message=\"$text\"/></testcase>"$'\n'
      done < <(verdicts "$1")
      ;;
    failed)
      xml_text "$4"
      tests=1 errors=1 cases="    <testcase classname=\"$1\" name=\"run\"><error message=\"$text\"/></testcase>"$'\n'
      ;;
    *) tests=1 skipped=1 cases="    <testcase classname=\"$1\" name=\"run\"><skipped message=\"not done by the program\"/></testcase>"$'\n' ;;
  esac
  printf '  <testsuite name="%s" tests="%d" failures="%d" errors="%d" skipped="%d" time="%s">\n%s  </testsuite>' \
    "$1" $tests $failures $errors $skipped "$2" "$cases"
}

# write_reports COMMAND: of all scenes
write_reports() {
  local names=(inside outside failed '' undecided) version commit text
  read -r version commit < <("$gasjet" --version | sed -E 's/^gasjet ([^ ]+) \(([^,]+),.*/\1 \2/')
  ((judged > 0)) || names[0]='not judged'
  json_text "$1"
  printf '{\n  "format": 1,\n  "version": "%s",\n  "commit": "%s",\n  "reference_data": %s,\n  "command": %s,\n  "verdict": "%s",\n  "scenes": [\n%s\n  ]\n}\n' \
    "$version" "$commit" "$(cat "$reference/VERSION")" "$text" "${names[worst]}" "$report_parts" >"$work/report.json"
  printf '<?xml version="1.0" encoding="UTF-8"?>\n<testsuites name="gasjet reference set %s">\n%s</testsuites>\n' \
    "$(cat "$reference/VERSION")" "$suites" >"$work/junit.xml"
}
