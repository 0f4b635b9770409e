// SPDX-License-Identifier: Apache-2.0
#include "gas/kick_work.hpp"

namespace gas {

void KickWork::take(double work, double dt_before, double dt_after, ControlVolumeState& state) {
  const double ahead = work * dt_after / (dt_before + dt_after);
  state.internal_energy -= work - ahead_ + ahead;
  ahead_ = ahead;
}

}  // namespace gas
