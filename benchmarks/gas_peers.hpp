// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "second_route.hpp"

// The tank by another package's integrator.
namespace peers {

/// States at the tank's stops by SUNDIALS CVODE (BDF, dense Newton, Jacobian by differences), restarted at
/// each, with the relative tolerance given. Throws std::runtime_error if it fails.
std::vector<gas::ControlVolumeState> cvode(const second_route::Tank& tank, double tolerance);

}  // namespace peers
