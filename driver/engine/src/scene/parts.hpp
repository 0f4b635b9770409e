// SPDX-License-Identifier: Apache-2.0
// How each table of a case becomes a part of the scene; one file per library.
#pragma once

#include <set>

#include "engine/scene.hpp"

namespace driver {

/// [gas], [[gas.species]], [[inflator]] (its gas), and the tables of the functions below. `ambient` and
/// `inflators` are read but not finished: the jets are read from the latter later.
void read_gas(TableReader& root, std::optional<TableReader>& ambient, std::vector<TableReader>& inflators,
              Scene& scene);

/// Sensors and triggers by their names: nodes of gas::TriggerModel.
class TriggerNames {
 public:
  void add(TableReader& table);
  /// Node called `name`; the error names `key` of `table`.
  std::size_t node(const TableReader& table, const std::string& key, const std::string& name) const;
  /// Node that the optional key "trigger" names.
  std::optional<std::size_t> optional_node(TableReader& table);
  void use(const std::vector<std::size_t>& nodes) { used_.insert(nodes.begin(), nodes.end()); }
  void warn_of_idle(Scene& scene) const;

 private:
  std::vector<std::string> names_;
  std::set<std::size_t> used_;
};

/// [[sensor]], [[trigger]]
TriggerNames read_triggers(TableReader& root, gas::TriggerModel& model);
/// [[vent]]
void read_vents(TableReader& root, TriggerNames& names, gas::ControlVolumeModel& model);
/// [tank]
void read_tank(TableReader& root, Scene& scene);
/// Of gas that the vents, a shrinking tank or an inflator would take out of its range of temperatures.
void warn_of_range(Scene& scene);
/// Of numbers that are likely to be in another unit; the scene may be read in part.
void warn_of_units(Scene& scene);
/// Of parts that are likely to miss what they are there for.
void warn_of_slips(Scene& scene);
/// Of the leak law "screen" in the table `fabric`.
void warn_of_screen(const std::string& fabric, LeakLaw law, Scene& scene);
/// [gas.heat_loss]
void read_heat_loss(TableReader& gas_table, Scene& scene);
/// `velocity` of a fabric with leak_law = "table"
gas::Curve read_leak_velocity(TableReader& table);
/// [membrane], [fabric]
void read_bag(TableReader& root, const MeshReader& read_mesh, Scene& scene);
/// [fabric]: properties of each element, compression and leak law (returned; its table goes to `model`,
/// which is null without gas); bag.elements are set.
LeakLaw read_fabric(TableReader& root, const mesh::Mesh& mesh, const std::vector<std::string>& null_panels,
                    membrane::BagDescription& bag, gas::ControlVolumeModel* model);
/// Least mass per area of a bag's fabric [kg/m2]; infinite if all of it is null.
double lightest_fabric(const membrane::BagDescription& bag);
/// [target]
void read_target(TableReader& root, Scene& scene);
/// [inflator.jet] of inflator `index`
void read_jet(TableReader& inflator, std::size_t index, Scene& scene);
/// Throws std::invalid_argument for an outlet that is not inside the bag, nor flat on its skin with the axis
/// inwards; the message says where along its axis it would be.
void require_outlet_inside(const jet::JetModel& model, const BagPart& bag);
/// [pendulum], [contact]
void read_pendulum(TableReader& root, Scene& scene);

/// A curve of a case as libgas takes it: a constant, or zero (mass flow) or held (temperature) outside the
/// knots.
gas::Curve to_gas_curve(const CurveData& data, gas::Outside outside);

}  // namespace driver
