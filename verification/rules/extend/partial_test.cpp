// SPDX-License-Identifier: Apache-2.0
// A strip of the law `partial`, pressed along one axis and free across: its stress is the share of Hooke's.
#include <gtest/gtest.h>

#include "scenes.hpp"

TEST(Partial, pressed_strip_keeps_its_share) {
  const auto mesh = mesh::rectangle(1, 1, 0.1, 0.1, mesh::Diagonals::uniform);
  for (const double kept : {0.0, 0.25, 1.0}) {
    auto d = scenes::describe(mesh, membrane::Compression::none);
    d.law = "partial";
    for (auto& p : d.properties) p.law_constants = {kept};
    const auto model = make_model(d);
    const double strain = -0.05;  // Green-Lagrange, and -0.3 times that across
    Eigen::Matrix3Xd x = mesh.nodes;
    x.row(0) *= std::sqrt(1.0 + 2.0 * strain);
    x.row(1) *= std::sqrt(1.0 - 0.6 * strain);
    const auto r = element_response(model, scenes::evaluated(model, x), 0).response;
    // The wide axis is in tension: without compression it alone has stress, of its own strain.
    const double across = (1.0 - kept) * 60e6 * -0.3 * strain;
    const double tolerance = 60e6 * 100 * scenes::kEps;
    EXPECT_NEAR(r.s11, kept * 60e6 * strain, tolerance);
    EXPECT_NEAR(r.s22, across, tolerance);
  }
}
