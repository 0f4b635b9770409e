// SPDX-License-Identifier: Apache-2.0
// What the functions of controls.hpp have in common.
#pragma once

#include <fmt/format.h>

#include <Eigen/Core>
#include <stdexcept>
#include <string>

#include "engine/simulation.hpp"

namespace driver {

namespace control {

[[noreturn]] inline void refuse(const std::string& text) {
  throw std::invalid_argument(text);
}

inline void require_number(std::size_t number, std::size_t count, const char* name) {
  if (number < count) return;
  refuse(count == 0 ? fmt::format("{}: is {}, but the scene has none", name, number)
                    : fmt::format("{}: is {}, allowed: 0 to {}", name, number, count - 1));
}

inline void require(bool good, const char* name, double value, const char* allowed) {
  if (!good) refuse(fmt::format("{}: is {:.6g}, allowed: {}", name, value, allowed));
}

inline void require_finite(const Eigen::Ref<const Eigen::MatrixXd>& values, const char* name) {
  if (!values.allFinite())
    refuse(fmt::format("{}: has a number that is not finite, allowed: finite ones", name));
}

}  // namespace control

/// set_outlet() without a look at the bag.
void place_outlet(Simulation& simulation, std::size_t jet, const Eigen::Vector3d& centre,
                  const Eigen::Vector3d& axis);

}  // namespace driver
