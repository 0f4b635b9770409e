// SPDX-License-Identifier: Apache-2.0
// On any triangles the fast route gives the mask of brute force with exact predicates.
#include "jet/visibility.hpp"

#include <stdexcept>
#include <vector>

#include "bytes.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Bytes bytes(data, size);
  const int node_count = bytes.integer(3, 12), element_count = bytes.integer(1, 16);
  Eigen::Matrix3Xd nodes(3, node_count);
  for (int n = 0; n < node_count; ++n)
    for (int c = 0; c < 3; ++c) nodes(c, n) = bytes.number();
  Eigen::Matrix3Xi triangles(3, element_count);
  for (int e = 0; e < element_count; ++e)
    for (int a = 0; a < 3; ++a) triangles(a, e) = bytes.integer(0, node_count - 1);
  jet::RaySource source;
  for (int c = 0; c < 3; ++c) source.centre(c) = bytes.number();
  for (int c = 0; c < 3; ++c) source.axis(c) = bytes.number();
  try {
    const auto fast = jet::visible(nodes, triangles, source);
    fuzz::require(fast == jet::visible(nodes, triangles, source, jet::VisibilityRoute::brute_force),
                  "fast = brute force");
    fuzz::require(fast == jet::visible(nodes, triangles, source, jet::VisibilityRoute::cgal_tree),
                  "fast = tree");
  } catch (const std::invalid_argument&) {
    // coordinates out of range, or an axis of zero
  }
  return 0;
}
