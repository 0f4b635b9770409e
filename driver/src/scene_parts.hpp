// SPDX-License-Identifier: Apache-2.0
// How each table of a case becomes a part of the scene; one file per library.
#pragma once

#include "driver/scene.hpp"

namespace driver {

/// [gas], [[gas.species]], [tank], [[inflator]] (its gas), [[vent]]. `inflators` are read but not finished:
/// the jets are read from them later.
void read_gas(TableReader& root, std::vector<TableReader>& inflators, Scene& scene);
/// [membrane], [fabric]
void read_bag(TableReader& root, Scene& scene);
/// [fabric]: properties of each element, compression and leak law; bag.elements are set.
void read_fabric(TableReader& root, const membrane::Mesh& mesh, membrane::BagDescription& bag, LeakLaw& law);
/// Least mass per area of a bag's fabric [kg/m2]; infinite if all of it is null.
double lightest_fabric(const membrane::BagDescription& bag);
/// [target]
void read_target(TableReader& root, Scene& scene);
/// [inflator.jet] of inflator `index`
void read_jet(TableReader& inflator, std::size_t index, Scene& scene);
/// [pendulum], [contact]
void read_pendulum(TableReader& root, Scene& scene);

/// A curve of a case as libgas takes it: a constant, or zero (mass flow) or held (temperature) outside the
/// knots.
gas::Curve to_gas_curve(const CurveData& data, gas::Outside outside);

}  // namespace driver
