// SPDX-License-Identifier: Apache-2.0
#include "compare_enclosure.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "argument_list.hpp"
#include "base/case_reader.hpp"
#include "base/json_head.hpp"
#include "compare/enclosure.hpp"

namespace driver::commands {
namespace {

using Json = nlohmann::ordered_json;

void print_text(const CompareArguments& a, const EnclosureVerdict& verdict) {
  fmt::print("{} against the proved bounds of {}\n", a.mine.string(), a.reference.string());
  fmt::print("{:34} {:>6} {:>12} {:>10} {:>10} {:>10} verdict\n", "quantity", "rows", "outside by", "at [s]",
             "share", "width");
  for (const auto& q : verdict.quantities)
    fmt::print("{:34} {:6} {:12.4g} {:10.4g} {:10.2e} {:10.2e} {}{}\n", q.name, q.rows, q.distance, q.time,
               q.share, q.width, verdict_name(q.verdict), q.reason.empty() ? "" : ": " + q.reason);
  fmt::print("{}\n", verdict_name(verdict.verdict));
}

void print_json(const CompareArguments& a, const EnclosureVerdict& verdict) {
  auto object = json_head<Json>();
  object.update({{"mine", a.mine.string()},
                 {"enclosure", a.reference.string()},
                 {"verdict", verdict_name(verdict.verdict)},
                 {"quantities", Json::array()}});
  for (const auto& q : verdict.quantities)
    object["quantities"].push_back({{"name", q.name},
                                    {"verdict", verdict_name(q.verdict)},
                                    {"reason", q.reason},
                                    {"rows", q.rows},
                                    {"outside_by", q.distance},
                                    {"time_s", q.time},
                                    {"share", q.share},
                                    {"width", q.width}});
  fmt::print("{}\n", object.dump(2));
}

}  // namespace

int compare_enclosure(const CompareArguments& a, const Tolerance& tolerance) {
  if (!a.rows.empty()) throw CaseError("--rows: writes two histories; with --enclosure there is one");
  const ProvedBounds enclosure = read_enclosure(a.reference);
  const History mine = read_history(a.mine, a.map);
  const EnclosureVerdict verdict = judge(mine, enclosure, names_of(a.columns), tolerance);
  a.format == "json" ? print_json(a, verdict) : print_text(a, verdict);
  return exit_code(verdict.verdict);
}

}  // namespace driver::commands
