// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>

#include "plain_gas.hpp"
#include "radau.hpp"

namespace random_tanks {

/// A straight line in time.
struct Line {
  double value = 0.0, slope = 0.0;
  double at(double t) const { return value + slope * t; }
};

/// What holds between two break points, against the time since the first: of each pulse flow and temperature,
/// of each hole its area.
struct Stretch {
  std::vector<Line> flows, temperatures;  // [kg/s], [K]
  std::vector<Line> areas;                // [m2] effective; 1 times Cd where the overpressure gives it
  Line leak;                              // [m2]
  Line volume;                            // [m3] of the chord ...
  double bulge = 0.0, since = 0.0, length = 1.0;  // ... and the parabola of the call, begun `since` before
};

/// The gas where its energy is known.
template <class Real>
struct PlainState {
  Real mass, temperature, gas_constant_sum, cp_sum;  // [kg], [K], [J/K], [J/K]
  PlainPlace<Real> place;
};

/// (G.8) to (G.12), (G.18), (G.19), (G.22) of a tank, unknowns m_k and U, or U + W where the volume follows
/// the pressure.
class PlainRates : public Ode {
 public:
  PlainRates(const Tank& tank, const std::string& csv);

  std::size_t size() const override { return species_.size() + 1; }
  bool rates(double t, std::span<const double> y, std::span<double> dydt) const override;
  bool jacobian(double t, std::span<const double> y, std::span<double> dydt,
                std::span<double> jacobian) const override;
  void sizes(double t, std::span<const double> y, std::span<double> size) const override;

  /// Where one of them changes its sign the rates have a corner: knots of tables against overpressure, p_a,
  /// the sonic switch either way, and 1000 K, where energies jump. In units of the gas's own pressure or
  /// energy.
  std::vector<double> levels(double t, std::span<const double> y) const;

  /// The state at the start, with every mass and the thermal energy `perturbation` of it larger.
  std::vector<double> start(double perturbation) const;
  /// False if no temperature fits.
  bool locate(double t, std::span<const double> y, PlainState<double>& state) const;
  const std::vector<PlainSpecies>& species() const { return species_; }
  double minimum() const { return minimum_; }  // [K] of all species
  double maximum() const { return maximum_; }

  Stretch stretch;  // to be set before each stretch

 private:
  template <class Real>
  bool find(double t, std::span<const Real> y, PlainState<Real>& state) const;
  template <class Real>
  bool evaluate(double t, std::span<const Real> y, std::span<Real> dydt) const;
  template <class Real>
  Real outflow(double t, const PlainState<Real>& gas) const;
  template <class Real>
  Real backflow(double t, const PlainState<Real>& gas) const;
  double enthalpy(std::span<const double> masses, double temperature) const;
  Coefficients sum(bool upper, std::span<const double> masses) const;
  /// Energy (G.4), (G.19) of the gas above `energy`, and its slope by T.
  std::pair<double, double> excess(const Coefficients& a, double gas_constant_sum, double energy,
                                   double t) const;
  double solve(const Coefficients& lower, const Coefficients& upper, double gas_constant_sum,
               double energy) const;

  const Tank& tank_;
  std::vector<PlainSpecies> species_;
  double minimum_ = 0.0, maximum_ = HUGE_VAL;
  double laminar_;             // [Pa] d of (G.22)
  std::vector<double> knots_;  // [Pa] of tables against overpressure
  double ambient_constant_ = 0.0, ambient_gamma_ = 0.0, ambient_enthalpy_ = 0.0;  // of the gas outside
  mutable double guess_ = 300.0;                                                  // [K], for speed
};

}  // namespace random_tanks
