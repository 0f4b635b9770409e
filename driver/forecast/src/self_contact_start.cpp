// SPDX-License-Identifier: Apache-2.0
#include "forecast/self_contact_start.hpp"

#include <cmath>

namespace driver {

SelfContactStart self_contact_start(const Scene& scene) {
  const coupling::SkinContactModel& contact = *scene.skin_contact;
  auto search = contact.make_state();
  const auto& position = scene.bag->initial_position;
  Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Zero(3, position.cols());
  contact.evaluate(search, position, forces);
  const double most = contact.full_omega_squared();
  return {search.limited_nodes(), search.smallest_limit(), most / scene.bag->model.fabric_frequency,
          2.0 / std::sqrt(most)};
}

}  // namespace driver
