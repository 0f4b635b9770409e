// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "gas/integrator.hpp"
#include "stepper.hpp"

namespace gas {

/// Adds the first gas of an evacuated volume with walls, from time t to b at most [s]. That gas has no heat
/// capacity, so it cannot be stepped. It is in balance with the walls,
///   sum mdot_i (h_i - u_i(T)) = h A (T - T_ext),
/// until a share of the segment's inflow, the tolerance, has come in (or for one fixed sub-step). The gas is
/// added to the ledger, with `y` as its unknowns. Returns the time reached; t if nothing flows in. Throws
/// DomainError if the balance is out of the temperature range.
double fill_first(System& system, const IntegratorOptions& options, Vector& y, double t, double b);

}  // namespace gas
