// SPDX-License-Identifier: Apache-2.0
// Functions of time over spans with breaks.
#include "time_function.hpp"

#include "known.hpp"

namespace {

using namespace test;
using enclosure::Balls;
using enclosure::Mode;
using enclosure::Piecewise;
using enclosure::Span;

Ball range(const Piecewise& f, double begin, double end) {
  Ball value;
  f.series({Ball(begin), Ball(end)}, Mode::across, value.get(), 1);
  return value;
}

// A jump from 2 to 5 at 1 s, from 5 to 3 within a second, then 3.
TEST(time_function, range_and_mean_over_breaks) {
  const Piecewise f({{0.0, 2.0}, {1.0, 2.0}, {1.0, 5.0}, {2.0, 3.0}}, Ball(0.0), false);
  for (const double v : {2.0, 5.0, 4.0}) EXPECT_TRUE(range(f, 0.5, 1.5).contains(Ball(v))) << v;
  EXPECT_TRUE(range(f, 1.0, 1.0).contains(Ball(5.0)));
  EXPECT_TRUE(range(f, 2.0, 2.0).contains(Ball(3.0)));
  EXPECT_FALSE(range(f, 1.0, 2.0).contains(Ball(2.9)));
  EXPECT_TRUE(f.mean({Ball(1.0), Ball(1.5)}).contains(Ball(4.5)));
  EXPECT_LT(f.mean({Ball(1.0), Ball(1.5)}).radius(), 1e-30);
  for (const double v : {2.0, 5.0}) EXPECT_TRUE(f.mean({Ball(0.9), Ball(1.1)}).contains(Ball(v))) << v;
}

// Its slope too: a volume's growth over a knot.
TEST(time_function, slopes_over_a_knot) {
  const Piecewise f({{0.0, 1.0}, {1.0, 3.0}, {2.0, 2.0}}, Ball(0.0), false);
  const arb_ptr c = _arb_vec_init(2);
  f.series({Ball(0.5), Ball(1.5)}, Mode::across, c, 2);
  Ball slope;
  arb_set(slope.get(), c + 1);
  _arb_vec_clear(c, 2);
  EXPECT_TRUE(slope.contains(Ball(2.0)));
  EXPECT_TRUE(slope.contains(Ball(-1.0)));
}

// Open from 1 to 2 s and from 4 s on: its curve, a jump from 2 to 5 after a second and a half, begins anew.
TEST(time_function, curve_that_begins_anew) {
  const Piecewise f = Piecewise::switched({{0.0, 1.0}, {1.0, 2.0}, {1.5, 2.0}, {1.5, 5.0}}, {1.0, 2.0, 4.0});
  for (const auto& [time, value] : std::vector<std::pair<double, double>>{
           {0.5, 0.0}, {1.5, 1.5}, {2.25, 0.0}, {4.5, 1.5}, {5.25, 2.0}, {6.0, 5.0}})
    EXPECT_TRUE(range(f, time, time).contains(Ball(value))) << time;
  EXPECT_EQ(f.breaks().size(), 5U);  // of the knots that it reaches
  for (const double v : {0.0, 1.0, 1.5}) EXPECT_TRUE(range(f, 3.5, 4.5).contains(Ball(v))) << v;
}

// T rises from 900 to 1200 K and falls back: h = 3 T up to 1000 K, 7 T - 4000 above.
TEST(time_function, composition_with_two_ranges) {
  const Piecewise t({{0.0, 900.0}, {1.0, 1200.0}, {2.0, 900.0}}, Ball(0.0), false);
  const Piecewise h = t.through({Ball(0.0), Ball(3.0)}, {Ball(-4000.0), Ball(7.0)}, 1000.0);
  for (const double time : {0.0, 0.1, 0.3, 0.4, 0.9, 1.0, 1.3, 1.6, 1.7, 1.9, 2.0, 3.0}) {
    const double temperature = time < 2.0 ? 1200.0 - 300.0 * std::abs(time - 1.0) : 900.0;
    const double exact = temperature <= 1000.0 ? 3.0 * temperature : 7.0 * temperature - 4000.0;
    EXPECT_NEAR(range(h, time, time).middle(), exact, 1e-9) << time;
  }
}

}  // namespace
