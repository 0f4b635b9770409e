// SPDX-License-Identifier: Apache-2.0
// Finer meshes of the square airbag.
#include <gtest/gtest.h>

#include "claim.hpp"
#include "square_airbag.hpp"

using membrane::Compression;
using mesh::Diagonals;

// Height 0.217 +- 0.0015 m and volume 0.125 +- 0.0005 m3 on finer meshes too, whatever the diagonals.
TEST(StaticsLong, square_airbag_is_in_the_published_range) {
  for (const auto diagonals : {Diagonals::uniform, Diagonals::union_jack}) {
    for (const int divisions : {32, 64}) {
      const auto bag = scenes::square_airbag(divisions, diagonals, Compression::none, 1e-3);
      const char* why = "spread of the published converged values";
      claim::expect_near({"M.3", "square airbag, up to 64 x 64: height [m]", why}, bag.height, 0.217, 0.0015);
      claim::expect_near({"M.3", "square airbag, up to 64 x 64: volume [m3]", why}, bag.volume, 0.125,
                         0.0005);
    }
  }
}
