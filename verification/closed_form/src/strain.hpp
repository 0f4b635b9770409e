// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace closed_form {

/// (stretch^2 - 1)/2, without cancellation near 1.
inline double green_lagrange(double stretch) {
  return 0.5 * (stretch - 1.0) * (stretch + 1.0);
}

}  // namespace closed_form
