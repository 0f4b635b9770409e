// SPDX-License-Identifier: Apache-2.0
#include <gasjet/jet.h>

#include <numeric>

#include "skin_object.hpp"

using namespace border;

namespace {

jet::RaySource source_of(const gasjet_source* pointer) {
  const gasjet_source& given = needed(pointer, "source");
  jet::RaySource source;
  source.centre = vector_of(given.centre, "source.centre");
  source.axis = vector_of(given.axis, "source.axis");
  source.half_long = number(given.half_long, "source.half_long", 0.0);
  if (source.half_long > 0.0)
    source.long_direction = vector_of(given.long_direction, "source.long_direction");
  return source;
}

struct Surface : Object {
  explicit Surface(Skin given)
      : skin(std::move(given)),
        query(skin.triangles, static_cast<int>(skin.node_count), skin.roles),
        all(static_cast<std::size_t>(skin.triangles.cols())) {
    std::iota(all.begin(), all.end(), 0);
  }
  static constexpr const char* name = "a surface";
  static constexpr bool shared = false;

  Skin skin;
  jet::VisibilityQuery query;
  std::vector<int> all;  // all elements
};

/// Numbers of candidates of a call, or all elements.
std::span<const int> candidates_of(const Surface& surface, const int32_t* candidates, int64_t count) {
  static_assert(std::is_same_v<int32_t, int>);
  if (candidates == nullptr) return surface.all;
  const std::span<const int> asked(candidates, static_cast<std::size_t>(count_of(count, "candidate_count")));
  const auto last = static_cast<int>(surface.all.size()) - 1;
  for (const int element : asked)
    if (element < 0 || element > last)
      refuse("candidates",
             "has the number " + std::to_string(element) + ", allowed: 0 to " + std::to_string(last));
  return asked;
}

}  // namespace

int gasjet_surface_create(const int32_t triangles[], int64_t triangle_count, const int64_t triangle_stride[],
                          int64_t node_count, const int32_t null_elements[], int64_t null_count,
                          const int32_t attachment_elements[], int64_t attachment_count,
                          gasjet_handle* surface) {
  return call([&] {
    needed(surface, "surface");
    *surface = keep(
        std::make_shared<Surface>(Skin(triangles, triangle_count, triangle_stride, node_count, null_elements,
                                       null_count, attachment_elements, attachment_count)));
  });
}

int gasjet_surface_visible(gasjet_handle surface, const double nodes[], int64_t node_count,
                           const int64_t node_stride[], const gasjet_source* source,
                           const int32_t candidates[], int64_t candidate_count, double displacement_bound,
                           uint8_t lit[], int64_t lit_count, gasjet_visibility* counters) {
  return call([&] {
    const Use<Surface> use(surface, "surface");
    const Points points =
        use->skin.points(nodes, node_count, node_stride, false);  // the query checks the nodes that it needs
    const auto from = source_of(source);
    const auto asked = candidates_of(*use, candidates, candidate_count);
    const auto out = output(lit, lit_count, static_cast<int64_t>(asked.size()), "lit");
    write_counters(use->query.query(jet::VisibilityRoute::fast, points.view(), from, asked, out,
                                    bound_of(displacement_bound)),
                   counters);
  });
}
