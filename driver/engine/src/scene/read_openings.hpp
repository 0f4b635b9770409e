// SPDX-License-Identifier: Apache-2.0
// Where gas and heat leave: [[vent]], [tank], [gas.heat_loss].
#pragma once

#include "scene/read_triggers.hpp"

namespace driver {

/// [[vent]]
void read_vents(TableReader& root, TriggerNames& names, gas::ControlVolumeModel& model);
/// [tank]
void read_tank(TableReader& root, Scene& scene);
/// [gas.heat_loss]
void read_heat_loss(TableReader& gas_table, Scene& scene);
/// `velocity` of a fabric with leak_law = "table"
gas::Curve read_leak_velocity(TableReader& table);
/// Warns of the leak law "screen" in the table `fabric`.
void warn_of_screen(const std::string& fabric, LeakLaw law, Scene& scene);

}  // namespace driver
