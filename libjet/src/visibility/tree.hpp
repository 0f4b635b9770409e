// SPDX-License-Identifier: Apache-2.0
// Reference route through CGAL's AABB tree.
#pragma once

#include <memory>

#include "visibility/blocking.hpp"
#include "visibility/predicates.hpp"

namespace jet {

/// AABB tree over the elements of one surface at one instant. It tests rays by the shared rule.
class ElementTree {
 public:
  explicit ElementTree(const Surface& surface);
  ~ElementTree();
  ElementTree(const ElementTree&) = delete;
  ElementTree& operator=(const ElementTree&) = delete;

  bool source_on_surface(exact::Kernel& kernel, const blocking::Ray& ray) const;
  bool blocked(exact::Kernel& kernel, const blocking::Ray& ray, int target_element) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace jet
