// SPDX-License-Identifier: Apache-2.0
// How the skin lies on itself at the start.
#pragma once

#include "engine/state.hpp"

namespace driver {

/// Contact of the skin with itself, before the first step.
struct SelfContactStart {
  int limited_nodes = 0;      // nodes closer to a layer than the thickness
  double smallest_gap = 0.0;  // [m] smallest distance of such a node; the thickness without one
  double share = 0.0;  // [-] what the contact may add to omega^2, over the fabric's in the design shape
  double critical_step = 0.0;  // [s] of the contact alone
};

/// Precondition: the scene has the contact. Throws coupling::ContactError for layers that meet.
SelfContactStart self_contact_start(const Scene& scene);

}  // namespace driver
