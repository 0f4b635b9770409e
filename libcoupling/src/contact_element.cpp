// SPDX-License-Identifier: Apache-2.0
#include "contact_element.hpp"

#include <limits>

namespace coupling::detail {

const Bristle* find_bristle(Grip& grip, int number) {
  for (; grip.passed < grip.before.size(); ++grip.passed) {
    const Bristle& b = grip.before[grip.passed];
    if (b.element > grip.element || (b.element == grip.element && b.point > number)) return nullptr;
    if (b.element == grip.element && b.point == number) return &grip.before[grip.passed++];
    grip.loss += 0.5 * b.weight * b.stretch.squaredNorm();
  }
  return nullptr;
}

double release_rest(Grip& grip) {
  grip.element = std::numeric_limits<int>::max();
  find_bristle(grip, 0);
  return grip.loss;
}

}  // namespace coupling::detail
