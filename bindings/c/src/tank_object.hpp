// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gasjet/gas.h>

#include <memory>
#include <vector>

#include "gas/integrator.hpp"
#include "gas_object.hpp"

/// Parts of a tank, as given by calls.
struct TankParts {
  struct Flow {
    std::shared_ptr<const Gas> gas;
    gas::Curve mass_flow, temperature;
    double start_time;
  };

  std::shared_ptr<const Gas> gas;
  double pressure, temperature, volume;
  gas::Ambient ambient;
  gas::IntegratorOptions options;
  std::vector<Flow> inflows{};
  std::vector<gas::Vent> vents{};        // without triggers
  std::vector<double> opens_at{};        // [Pa] opening pressure of each
  double leak_area = 0.0;                // [m2]
  std::shared_ptr<const Gas> outside{};  // of vents with backflow
  gas::HeatLoss heat_loss{};
};

/// A tank with its parts, model, state and sums.
struct Tank : border::Object {
  explicit Tank(TankParts given);
  static constexpr const char* name = "a tank";
  static constexpr bool shared = false;

  double mass() const;
  gasjet_tank_balance balance() const;
  void advance(double to, double new_volume);
  /// Goes on with other parts of the same gases. If they are refused, the tank is unchanged.
  void change(TankParts to);
  /// Begins anew with other parts.
  void rebuild(TankParts to);

  TankParts parts;
  gas::ControlVolumeModel model;
  gas::GasIntegrator integrator;
  gas::ControlVolumeState state;
  double volume, first_mass, first_energy;
  double time = 0.0;
  bool started = false;
  gasjet_tank_balance sums{};
};
