// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>
#include <vector>

#include "gas/thermo.hpp"
#include "tank_test/reading_error.hpp"
#include "tank_test/smoothing_spline.hpp"

/// Inverse analysis of a tank test: an inflator fires into a closed rigid adiabatic tank that holds gas of
/// its own; from the measured pressures, the mass flow and the temperature of what came in.
///   V p' cv/R = mdot (h_i(T_s) - u_i(T) + cv T R_i/R), p V = sum(m_k R_k) T                          (G.33)
/// cv, R of the tank's gas, i the inflator's. One gas of constant cp: mdot T_s = K = V p'/(gamma R).  (G.34)
/// Pressures are smoothed by SmoothingSpline. The curve's flow is zero outside the burn: from the last K <= 0
/// before K first stands clear of threshold and noise to the first K <= 0 after it last does. Its integral is
/// the known total mass, all of which is in the tank at the end of the record or, if the pressure has fallen
/// since by more than noise explains, where it is highest.
namespace gas {

/// What is known of the test.
struct TankTest {
  Thermo thermo;                           // species of both gases
  double volume;                           // [m3] > 0
  double initial_temperature;              // [K] of the tank's own gas
  std::vector<double> tank_fractions;      // [-] by mass, one per species, sum 1: the tank's own gas
  std::vector<double> inflator_fractions;  // [-] by mass: what the inflator delivers
  double total_mass;                       // [kg] > 0 delivered by the inflator
};

/// Readings at times [s] that rise strictly; pressures [Pa] absolute; the tank's above 0, and the
/// chamber's too where noise is a share of the reading.
struct TankReadings {
  std::span<const double> times;    // [s]
  std::span<const double> tank;     // [Pa] one per time
  std::span<const double> chamber;  // [Pa] one per time; empty for the average-temperature method
};

/// Resolution of the result and of its bands.
struct IdentifyOptions {
  int points = 501;                 // times of the result, equally spaced over the record; 20 to 10000
  double threshold = 0.05;          // of the largest K: below it a point is masked; 0.001 to 0.9
  int draws = 400;                  // from the splines' posterior, for the bands; 40 to 2000
  Noise noise = Noise::of_reading;  // of both gauges
};

/// 95 % band: the 2.5 and 97.5 percentiles over draws of the pressures, which are smoothed less than the
/// estimate so that noise, not bias, is the error. Noise biases Cd A once more in each draw: the draws are
/// shifted so that their median is the estimate. V, M, T0 and the gases count as exact.
struct Band {
  double low;   // unit of what it belongs to
  double high;  // >= low
};

/// The result at one time.
struct IdentifiedPoint {
  double time;              // [s]
  double tank_pressure;     // [Pa] smoothed
  double chamber_pressure;  // [Pa] smoothed; 0 without chamber readings
  double enthalpy_flow;     // K [kg K/s] with gamma and R of the inflator's gas at the mean temperature
  double mass_flow;         // [kg/s] >= 0
  double temperature;       // [K] T_s, stagnation; where masked, that of the nearest point which is not
  Band mass_flow_band;      // [kg/s]
  Band temperature_band;    // [K]
  double amplification;  // relative standard deviation of K over the tank's noise; masked: at the threshold
  bool masked;  // K below its threshold or 4 of its standard deviations, or the chamber's pressure does not
                // exceed the tank's
  bool band_claimed = false;  // the bands hold: not masked, no bend so sharp that smoothing rounds it, and 30
                              // readings or more in the burn
};

/// What SmoothingSpline made of one series.
struct Smoothing {
  double parameter;           // lambda of (G.30)
  double degrees_of_freedom;  // of the fit
  double noise;               // [-] standard deviation of one reading as a fraction of it
};

/// Curves and figures of one test.
struct Identified {
  std::vector<IdentifiedPoint> points;  // IdentifyOptions::points of them
  double mean_temperature;              // [K] the constant T_s that gives the total mass
  Band mean_temperature_band;           // [K]
  double effective_area = 0.0;          // [m2] Cd A of the inflator's outlet; 0 for average temperature
  Band effective_area_band{};           // [m2]
  double threshold;                     // of |K| [kg K/s]
  int misfits = 0;     // draws that leave the range of temperatures; the bands are those of the others
  bool bands = false;  // claimed: misfits are a tenth of the draws at most
  double forward_error =
      0.0;         // largest relative miss of the smoothed tank pressure by a model run with these curves
  Smoothing tank;  // of the tank's pressure
  Smoothing chamber{};  // of the chamber's; zero without its readings
};

/// Average temperature: T_s constant, such that the mass is M: its enthalpy is what the tank's energy gained,
/// over M. Exact for K, hence for mdot T_s of one gas; mdot alone is off by the factor T_s/T_mean locally,
/// which no band here contains.                                                                     (G.35)
/// Dual pressure (chamber readings given): the outlet is an orifice of effective area Cd A between chamber
/// and tank, mdot = Cd A p_c psi(T_s, p_t/p_c), sonic or subsonic (G.6), which with (G.33) gives T_s and mdot
/// at every point; Cd A gives the mass M. Singular as K -> 0. (G.36) Errors: ReadingError, or another
/// std::invalid_argument naming what is out of range; DomainError when the tank pressure does not rise above
/// its noise, a temperature of the record itself leaves the species' range, or the iteration for Cd A does
/// not settle. Draws that leave the range are counted in `misfits`.
Identified identify(const TankTest& test, const TankReadings& readings, const IdentifyOptions& options = {});

}  // namespace gas
