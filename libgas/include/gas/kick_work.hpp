// SPDX-License-Identifier: Apache-2.0
// Work that the gas does on a moving body, known kick by kick of a central difference.
#pragma once

#include "gas/control_volume.hpp"

namespace gas {

/// Takes such work out of the gas, beside the p dV of its volume. The kick at level n works from n-1/2 to
/// n+1/2, the gas steps from n to n+1. So the part of the next kick before n+1 is taken at this kick's rate,
/// and settled a step later. The energy of the gas at n+1 is then of second order, and balances exactly.
class KickWork {
 public:
  /// Takes the `work` [J] of the kick at n out of the gas at n+1. `dt_before` and `dt_after` [s] are the
  /// steps before and after n. Precondition: dt_before >= 0, dt_after > 0.
  void take(double work, double dt_before, double dt_after, ControlVolumeState& state);

  /// Work of the next kick that has been taken out already [J].
  double ahead() const { return ahead_; }

 private:
  double ahead_ = 0.0;
};

}  // namespace gas
