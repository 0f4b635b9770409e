// SPDX-License-Identifier: Apache-2.0
#include "skin_object.hpp"

#include <algorithm>

namespace border {
namespace {

constexpr int64_t kOtherNodes = 20'000'000;  // nodes of other parts of the user's model

// Checks the count first: a wrong one could use up the memory.
int64_t checked(int64_t nodes, int64_t triangle_count) {
  const int64_t most =
      3 * std::clamp<int64_t>(triangle_count, 0, std::numeric_limits<int>::max()) + kOtherNodes;
  if (nodes > most)
    refuse("node_count", "is " + std::to_string(nodes) + ", allowed: at most " + std::to_string(most) +
                             " for this number of triangles");
  return nodes;
}

}  // namespace

Skin::Skin(const int32_t* data, int64_t count, const int64_t* stride, int64_t nodes,
           const int32_t* null_elements, int64_t null_count, const int32_t* attachment_elements,
           int64_t attachment_count)
    : triangles(triangles_of(data, count, stride, checked(nodes, count))),
      roles{numbers_of(null_elements, null_count, count, "null_elements"),
            numbers_of(attachment_elements, attachment_count, count, "attachment_elements")},
      named(triangles.data(), triangles.data() + triangles.size()),
      node_count(nodes) {
  std::sort(named.begin(), named.end());
  named.erase(std::unique(named.begin(), named.end()), named.end());
}

Points Skin::points(const double* data, int64_t count, const int64_t* stride, bool finite,
                    std::string_view argument) const {
  require_count(count, node_count, argument);
  return {data, count, stride, argument, named, finite};
}

Points Skin::points(const float* data, int64_t count, const int64_t* stride, std::vector<double>& copy,
                    std::string_view argument) const {
  require_count(count, node_count, argument);
  const Stride given = stride_of(stride, count, argument);
  needed(data, argument);
  copy.resize(3 * static_cast<std::size_t>(count));
  for (const int i : named)
    for (int k = 0; k < 3; ++k)
      copy[static_cast<std::size_t>(3 * i + k)] =
          static_cast<double>(data[i * given.row + k * given.component]);
  return {copy.data(), count, nullptr, argument, named, true};
}

void write_counters(const jet::VisibilityCounters& from, gasjet_visibility* to) {
  if (to == nullptr) return;
  *to = {static_cast<int64_t>(from.candidates), static_cast<int64_t>(from.lit),
         static_cast<int64_t>(from.hidden), static_cast<int64_t>(from.facing_away)};
}

double bound_of(double displacement_bound) {
  if (displacement_bound < 0.0 || std::isinf(displacement_bound))
    refuse("displacement_bound", "is " + shown(displacement_bound) + ", allowed: 0 or more, NaN for unknown");
  return displacement_bound;
}

}  // namespace border
