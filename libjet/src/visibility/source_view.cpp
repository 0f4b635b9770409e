// SPDX-License-Identifier: Apache-2.0
#include "visibility/source_view.hpp"

#include "visibility/sides.hpp"

namespace jet {

// An element counts as facing away if rounding or the outlet's length leaves its side open.
bool SourceView::may_face_away(int element, double size) {
  int side = common_side(surface_, element, *source_, size);
  if (side != 0) return side < 0;
  const bool flat = in_one_coordinate_plane(surface_, element, *source_);
  if (!flat && source_->half_long > 0.0) return true;
  const double *a = surface_.corner(element, 0), *b = surface_.corner(element, 1),
               *c = surface_.corner(element, 2);
  if (!flat) side = kernel_.orientation(source_->centre.data(), a, b, c);
  if (side == 0) side = -kernel_.slope(source_->axis.data(), a, b, c);
  return side < 0;
}

// True unless all sources, moved by eps, are certainly on one side of the element's plane.
bool SourceView::between_sources(int element, const RayBundle& rays) {
  if (source_->half_long == 0.0 || common_side(surface_, element, *source_, rays.projection().size) != 0)
    return false;
  if (!in_one_coordinate_plane(surface_, element, *source_)) return !same_side(element, rays);
  return kernel_.slope(source_->axis.data(), surface_.corner(element, 0), surface_.corner(element, 1),
                       surface_.corner(element, 2)) == 0;
}

// True if no segment between two sources crosses the element's plane.
bool SourceView::same_side(int element, const RayBundle& rays) {
  int common = 0;
  for (const int place : rays.asked().places()) {
    blocking::Ray ray = rays.asked().ray(place);
    ray.moved = blocking::Moved::yes;
    const int side = blocking::facing(kernel_, ray, surface_, element);
    if (side == 0 || side == -common) return false;
    common = side;
  }
  return true;
}

bool SourceView::source_on_surface(const blocking::Ray& ray) {
  if (source_->half_long == 0.0 && point_moved_) return *point_moved_;
  bool on = false;
  for (int e = 0; e < surface_.count && !on; ++e)
    on = Box(surface_, e).holds(ray.source) && blocking::source_on(kernel_, ray, surface_, e);
  point_moved_ = on;
  return on;
}

}  // namespace jet
