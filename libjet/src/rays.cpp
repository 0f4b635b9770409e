// SPDX-License-Identifier: Apache-2.0
#include "rays.hpp"

#include <cmath>

namespace jet {
namespace {

constexpr double kMargin = 1e-11;   // relative to the coordinates' size: 1e5 roundings
constexpr double kShortest = 1e-6;  // a ray shorter than this along w has no safe slope
constexpr double kWayLength =
    0.02;  // the way's ray is at least so long, that its far point is within 300 sizes

}  // namespace

void RayBundle::reserve(std::size_t count) {
  rays.reserve(count);
}

void RayBundle::build(const Surface& surface, const RaySource& source, std::span<const int> candidates,
                      double size) {
  rays.resize(candidates.size());
  for (std::size_t k = 0; k < rays.size(); ++k) rays[k] = blocking::make_ray(surface, candidates[k], source);
  source.axis.cwiseAbs().maxCoeff(&funnel.w);
  funnel.u = (funnel.w + 1) % 3;
  funnel.v = (funnel.w + 2) % 3;
  funnel.sign = source.axis[funnel.w] < 0.0 ? -1.0 : 1.0;
  funnel.bounded = bound_slopes(size);
  if (!funnel.bounded) return;
  bound(source, size);
  set_way(size);
}

// The steepest slopes of all rays, and the longest ray as the way.
bool RayBundle::bound_slopes(double size) {
  double longest = 0.0;
  for (int i = 0; i < 2; ++i) funnel.slope_low[i] = HUGE_VAL, funnel.slope_high[i] = -HUGE_VAL;
  for (std::size_t k = 0; k < rays.size(); ++k) {
    const double *s = rays[k].source, *g = rays[k].target;
    const double dw = funnel.sign * (g[funnel.w] - s[funnel.w]);
    if (!(dw > kShortest * size)) return false;
    const double inverse = 1.0 / dw;
    const double slope[2] = {(g[funnel.u] - s[funnel.u]) * inverse, (g[funnel.v] - s[funnel.v]) * inverse};
    for (int i = 0; i < 2; ++i) {
      funnel.slope_low[i] = std::min(funnel.slope_low[i], slope[i]);
      funnel.slope_high[i] = std::max(funnel.slope_high[i], slope[i]);
    }
    if (dw > longest) {
      longest = dw;
      way = k;
      for (int i = 0; i < 2; ++i) funnel.way_slope[i] = slope[i];
    }
  }
  return longest > kWayLength * size;
}

// All sources lie between the two ends of the outlet: the bounds hold there, so they hold in between.
void RayBundle::bound(const RaySource& source, double size) {
  funnel.low_w = HUGE_VAL;
  for (int i = 0; i < 2; ++i) funnel.low[i] = HUGE_VAL, funnel.high[i] = -HUGE_VAL;
  for (const double t : {-source.half_long, source.half_long}) {
    const Eigen::Vector3d end =
        t == 0.0 ? source.centre : Eigen::Vector3d(source.centre + t * source.long_direction);
    const double w = funnel.sign * end[funnel.w];
    funnel.low_w = std::min(funnel.low_w, w - kMargin * size);
    for (int i = 0; i < 2; ++i) {
      const double x = end[i == 0 ? funnel.u : funnel.v];
      const double margin =
          kMargin * size * (1.0 + std::abs(funnel.slope_low[i]) + std::abs(funnel.slope_high[i]));
      funnel.low[i] = std::min(funnel.low[i], x - funnel.slope_low[i] * w - margin);
      funnel.high[i] = std::max(funnel.high[i], x - funnel.slope_high[i] * w + margin);
    }
  }
}

void RayBundle::set_way(double size) {
  way_ray = rays[way];
  way_ray.moved = true;
  const double* s = rays[way].source;
  const double sw = funnel.sign * s[funnel.w];
  const double reach = 4.0 * size;
  way_ray.target[funnel.w] = s[funnel.w] + funnel.sign * reach;
  for (int i = 0; i < 2; ++i) {
    const int axis = i == 0 ? funnel.u : funnel.v;
    way_ray.target[axis] = s[axis] + funnel.way_slope[i] * reach;
    funnel.way_offset[i] = s[axis] - funnel.way_slope[i] * sw;
    funnel.way_margin[i] = kMargin * size * (1.0 + std::abs(funnel.way_slope[i]));
  }
}

}  // namespace jet
