// SPDX-License-Identifier: Apache-2.0
// The side of an element that the sources of a query see. Exact arithmetic decides if rounding leaves it
// open.
#pragma once

#include <optional>

#include "visibility/filter.hpp"
#include "visibility/rays.hpp"
#include "visibility/surface.hpp"

namespace jet {

/// The sources of one query and the surface.
class SourceView {
 public:
  /// Predicates. They determine whether a ray's source is moved when the rule needs it.
  struct Kernel : filter::Kernel {
    SourceView* view = nullptr;
    bool moved(const blocking::Ray& ray) {
      if (ray.moved == blocking::Moved::unknown) ray.moved = blocking::moved_if(view->source_on_surface(ray));
      return ray.moved == blocking::Moved::yes;
    }
  };

  void begin(const Surface& surface, const RaySource& source) {
    surface_ = surface;
    source_ = &source;
    point_moved_.reset();
    kernel_.calls = 0;
    kernel_.view = this;
  }
  Kernel& kernel() { return kernel_; }

  /// True unless the element certainly faces all sources. `size`: see RayBundle.
  bool may_face_away(int element, double size);
  /// True unless all sources, moved by eps, are certainly on one side of the element's plane.
  bool between_sources(int element, const RayBundle& rays);

 private:
  bool same_side(int element, const RayBundle& rays);
  bool source_on_surface(const blocking::Ray& ray);

  Surface surface_;
  const RaySource* source_ = nullptr;
  std::optional<bool> point_moved_;  // whether a point source is moved, once known
  Kernel kernel_;
};

}  // namespace jet
