// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "gas/integrator.hpp"
#include "stepper.hpp"

namespace gas {

/// The first gas of an evacuated volume with walls, from time t at most to b. It has no heat capacity to be
/// stepped with: it is at its balance with them, sum mdot_i (h_i - u_i(T)) = h A (T - T_ext), until a share
/// of the tolerance of the segment's gas is there (or for one fixed sub-step). Books it, `y` being its
/// unknowns; returns the time reached, t if nothing flows in.
double fill_first(System& system, const IntegratorOptions& options, Vector& y, double t, double b);

}  // namespace gas
