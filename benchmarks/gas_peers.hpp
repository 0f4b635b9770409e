// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "second_route.hpp"

// The tank by another package's integrator.
namespace peers {

/// State at second_route::kEnd by SUNDIALS CVODE (BDF, dense Newton, Jacobian by differences), with the relative
/// tolerance given; restarted at the end of the inflow. Throws std::runtime_error if it fails.
gas::ControlVolumeState cvode(const second_route::VentedTank& tank, double tolerance);

}  // namespace peers
