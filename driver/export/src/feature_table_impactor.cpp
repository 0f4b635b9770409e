// SPDX-License-Identifier: Apache-2.0
// The table of how decks represent impactors, their contact, and gravity.
#include "feature_outcomes.hpp"

namespace driver {
namespace {

using outcomes::in_deck, outcomes::own_penalty, outcomes::same;
constexpr Outcome triangles{Mapping::approximated, "a surface of flat triangles, by the size below"};
constexpr Outcome by_penalty{Mapping::approximated, "joint by a penalty"};
constexpr Outcome undamped{Mapping::none, "the stop is a spring alone: it throws back without loss", true};

}  // namespace

const std::vector<Feature>& features_of_impactors() {
  static const std::vector<Feature> table{
      {"scene.gravity",
       {Mapping::exact, "/GRAV along each axis, of the bag and the impactor"},
       {Mapping::exact, "*LOAD_BODY along each axis"}},
      {"pendulum.pivot", by_penalty, by_penalty},
      {"pendulum.axis", same, same},
      {"pendulum.rest_direction", same, same},
      {"pendulum.mass", same, same},
      {"pendulum.inertia_cg", same, same},
      {"pendulum.cg_distance", same, same},
      {"pendulum.impactor_distance", same, same},
      {"pendulum.impactor_radius", triangles, triangles},
      {"pendulum.initial_angle", same, same},
      {"pendulum.initial_angular_velocity", same, same},
      {"pendulum.driving_moment",
       {Mapping::exact, "/CLOAD about the axis"},
       {Mapping::exact, "*LOAD_RIGID_BODY about the axis"}},
      {"impactor.centre", same, same},
      {"impactor.axis", same, same},
      {"impactor.second_axis", same, same},
      {"impactor.shape", triangles, triangles},
      {"impactor.motion.type", in_deck, in_deck},
      {"impactor.motion.pivot", by_penalty, by_penalty},
      {"impactor.motion.axis", same, same},
      {"impactor.motion.rest_direction", same, same},
      {"impactor.motion.mass", same, same},
      {"impactor.motion.inertia_cg", same, same},
      {"impactor.motion.cg_distance", same, same},
      {"impactor.motion.impactor_distance", same, same},
      {"impactor.motion.initial_angle", same, same},
      {"impactor.motion.initial_angular_velocity", same, same},
      {"impactor.motion.driving_moment",
       {Mapping::exact, "/CLOAD about the axis"},
       {Mapping::exact, "*LOAD_RIGID_BODY about the axis"}},
      {"impactor.motion.direction",
       {Mapping::exact, "/BCS in axes of the rail"},
       {Mapping::exact, "CMO of *MAT_RIGID in axes of the rail"}},
      {"impactor.motion.velocity", same, same},
      {"impactor.motion.angular_velocity", same, same},
      {"impactor.motion.inertia",
       {Mapping::exact, "in the axes of space, at the start"},
       {Mapping::exact, "in the axes of space, at the start"}},
      {"impactor.motion.force",
       {Mapping::exact, "/CLOAD along the rail"},
       {Mapping::exact, "*LOAD_RIGID_BODY along the rail"}},
      {"impactor.motion.spring",
       {Mapping::exact, "spring by a curve, with a linear damper"},
       {Mapping::exact, "spring by a curve, and a linear damper"}},
      {"impactor.motion.stop",
       {Mapping::exact, "spring by a curve: no force before the stop"},
       {Mapping::exact, "spring by a curve: no force before the stop"}},
      {"impactor.motion.stop.damping", undamped, undamped},
      {"contact.stiffness", own_penalty, own_penalty},
      {"contact.stiffness_share", own_penalty, own_penalty},
      {"contact.friction", same, same},
  };
  return table;
}

}  // namespace driver
