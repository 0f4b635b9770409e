// SPDX-License-Identifier: Apache-2.0
#include "coupling/impactor.hpp"

#include "bodies.hpp"
#include "check.hpp"

namespace coupling {
namespace {

void require_valid_shape(const Sphere& sphere) {
  detail::require_positive("impactor.radius", sphere.radius);
}

}  // namespace

void require_valid(const Impactor& impactor) {
  std::visit([](const auto& shape) { require_valid_shape(shape); }, impactor);
}

double size_of(const Impactor& impactor) {
  return std::visit([](const auto& shape) { return detail::body_of(shape).size(); }, impactor);
}

double reach_of(const Impactor& impactor) {
  return std::visit([](const auto& shape) { return detail::body_of(shape).reach(); }, impactor);
}

double section_of(const Impactor& impactor) {
  return std::visit([](const auto& shape) { return detail::body_of(shape).section(); }, impactor);
}

}  // namespace coupling
