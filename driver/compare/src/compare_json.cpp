// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/json_head.hpp"
#include "compare/compare.hpp"

namespace driver {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const Peak& peak) {
  return {{"value", peak.value}, {"time_s", peak.time}};
}

Json to_json(const QuantityDifference& q) {
  Json object{{"verdict", verdict_name(q.verdict)}, {"reason", q.reason}};
  if (q.values.empty()) return object;
  object["max_error"] = to_json(q.largest);
  object["l2_error"] = q.l2;
  object["relative_error"] = q.relative ? Json(*q.relative) : Json();
  if (!q.band.empty())
    object["share_of_band"] = std::isfinite(q.share_of_band) ? Json(q.share_of_band) : Json();
  if (q.seen) object["seen_share"] = std::isfinite(*q.seen) ? Json(*q.seen) : Json();
  object["phase_lag_s"] = q.phase_lag ? Json(*q.phase_lag) : Json();
  object["peak"] = to_json(q.mine);
  object["reference_peak"] = to_json(q.reference);
  return object;
}

}  // namespace

std::string json_of(const Difference& difference, const std::string& mine, const std::string& reference) {
  auto object = json_head<Json>();
  object.update({{"mine", mine},
                 {"reference", reference},
                 {"verdict", verdict_name(difference.verdict)},
                 {"reason", difference.reason},
                 {"rows", difference.time.size()},
                 {"quantities", Json::object()}});
  if (difference.reference_runs > 1)
    object.update({{"runs", difference.runs}, {"reference_runs", difference.reference_runs}});
  for (const auto& q : difference.quantities) object["quantities"][q.name] = to_json(q);
  return object.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace driver
