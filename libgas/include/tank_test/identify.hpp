// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "gas/thermo.hpp"
#include "tank_test/reading_error.hpp"
#include "tank_test/smoothing_spline.hpp"

/// Inverse analysis of a tank test. An inflator fires into a closed rigid tank that holds gas of its own. The
/// mass flow and the temperature of the inflow follow from the measured pressures:
///   V p' cv/R = mdot (h_i(T_s) - u_i(T) + cv T R_i/R), p V = sum(m_k R_k) T                          (G.33)
/// with cv, R of the gas in the tank and i for the inflator's gas. A loss of heat to the walls, h A (T -
/// T_w), adds to the left side (G.39). For one gas of constant cp without it:
///   mdot T_s = K = V p'/(gamma R)                                                                    (G.34)
/// SmoothingSpline smooths the pressures. The curve's flow is zero outside the burn. The burn spans all
/// points where K exceeds threshold and noise, extended on both sides to where K <= 0. The pressure before
/// firing is the mean of the flat readings at the start. (G.38) The curve's integral is the known total mass.
/// The tank holds all of it at the end of the record, or already at the pressure's peak if the pressure then
/// falls by more than the noise.
namespace gas {

/// Known data of the test.
struct TankTest {
  Thermo thermo;                           // species of both gases
  double volume;                           // [m3] > 0
  double initial_temperature;              // [K] of the tank's own gas
  std::vector<double> tank_fractions;      // [-] by mass, one per species, sum 1, of the tank's own gas
  std::vector<double> inflator_fractions;  // [-] by mass, one per species, sum 1, of the inflator's gas
  double total_mass;                       // [kg] > 0 delivered by the inflator
};

/// Readings. Times rise strictly. Pressures are absolute. The tank's are above 0; so are the chamber's if the
/// noise is a share of the reading.
struct TankReadings {
  std::span<const double> times;    // [s]
  std::span<const double> tank;     // [Pa] one per time
  std::span<const double> chamber;  // [Pa] one per time; empty for the average-temperature method
};

/// Resolution of the result and of its bands.
struct IdentifyOptions {
  int points = 501;  // times of the result, equally spaced over the record; 20 to 10000
  /// [-] 0.001 to 0.9: points with K below this share of the largest K are masked.
  double threshold = 0.05;
  /// Draws from the posterior of the splines, for the bands; 40 to 2000.
  int draws = 400;
  Noise noise = Noise::of_reading;  // noise of both gauges
  /// [W/K] >= 0: h A of the walls, which stay at the initial temperature.
  double heat_loss = 0.0;
  /// Fits h A to the fall of the tank's pressure after the flow instead.
  bool fit_heat_loss = false;
};

/// 95 % band: the 2.5 and 97.5 percentiles over draws of the pressures. The draws are smoothed less than the
/// estimate, so that noise, not bias, makes the error. Noise biases Cd A a second time in each draw;
/// therefore the draws are shifted until their median is the estimate. V, M, T0 and the gases are taken as
/// exact.
struct Band {
  double low;   // unit of the quantity
  double high;  // >= low
};

/// The result at one time.
struct IdentifiedPoint {
  double time;              // [s]
  double tank_pressure;     // [Pa] smoothed
  double chamber_pressure;  // [Pa] smoothed; 0 without chamber readings
  /// K [kg K/s], with gamma and R of the inflator's gas at the mean temperature.
  double enthalpy_flow;
  double mass_flow;  // [kg/s] >= 0
  /// [K] T_s, stagnation temperature; at a masked point the value of the nearest point that is not masked.
  double temperature;
  Band mass_flow_band;    // [kg/s]
  Band temperature_band;  // [K]
  /// [-] Standard deviation of K over K, divided by the noise of the tank's readings. At a masked point K is
  /// replaced by the threshold if that is larger.
  double amplification;
  /// True if K is below its threshold or 4 standard deviations, the burn has ended, the chamber's pressure
  /// does not exceed the tank's, or the chamber gauge is cut off.
  bool masked;
  /// True if the bands can be trusted: Identified::bands is true, the point is not masked, the burn has at
  /// least 30 readings, smoothing can follow the pressure's bends, and the temperature's band lies inside the
  /// range of the gases.
  bool band_claimed = false;
};

/// Result of the SmoothingSpline of one series.
struct Smoothing {
  double parameter;           // lambda of (G.30)
  double degrees_of_freedom;  // degrees of freedom of the fit
  double noise;  // [-] standard deviation of a reading over the reading (full scale: over the largest)
};

/// Where a gauge is cut off at the end of its range.
struct Clipping {
  double pressure;       // [Pa] largest reading
  double first;          // [s] first reading that equals it
  double last;           // [s] last reading that equals it
  std::ptrdiff_t count;  // number of readings that equal it
};

/// Result of one test.
struct Identified {
  std::vector<IdentifiedPoint> points;  // [IdentifyOptions::points]
  double mean_temperature;              // [K] the constant T_s that gives the total mass
  Band mean_temperature_band;           // [K]
  double effective_area = 0.0;          // [m2] Cd A of the inflator's outlet; 0 for average temperature
  Band effective_area_band{};           // [m2]
  /// [kg K/s] masking threshold of K.
  double threshold;
  /// Draws whose inversion fails, for example because a temperature leaves its range. The bands use the
  /// others.
  int misfits = 0;
  /// True if bands are given: at most a tenth of the draws are misfits, the model fits the record, and no
  /// gauge is cut off. A cut-off gauge spoils the whole record, because the total mass is known only at its
  /// end.
  bool bands = false;
  std::optional<Clipping> tank_clipping{};     // empty if the gauge is not cut off
  std::optional<Clipping> chamber_clipping{};  // as tank_clipping
  double initial_pressure = 0.0;               // [Pa] before firing
  double heat_loss = 0.0;                      // [W/K] h A of the walls, as given or fitted
  Band heat_loss_band{};                       // [W/K] of a fitted one
  double tail_start = 0.0;                     // [s] of the readings that a fitted one rests on
  /// [-] Largest relative difference between the smoothed tank pressure and that of a control-volume run with
  /// these curves.
  double forward_error = 0.0;
  double forward_noise = 0.0;  // [-] error that noise explains: 5 standard deviations of a reading
  /// True if noise and spacing of the points explain forward_error. Otherwise the model does not describe the
  /// tank (it may lose more heat to its walls), and no bands are given.
  bool fits = false;
  Smoothing tank;       // the tank's pressure
  Smoothing chamber{};  // the chamber's pressure; zeros without its readings
};

/// Identifies mass flow and temperature.
///
/// Without chamber readings: average temperature. T_s is constant and such that the mass is M. (G.35) The
/// inflow's specific enthalpy is the energy gained by the tank, divided by M. K is exact; so is mdot T_s for
/// one gas. mdot alone is locally wrong by the factor T_s/T_mean, which the bands do not contain.
///
/// With chamber readings: dual pressure. The outlet is an orifice of effective area Cd A between chamber and
/// tank, mdot = Cd A p_c psi(T_s, p_t/p_c), sonic or subsonic (G.6). With (G.33) this gives T_s and mdot at
/// every point; Cd A follows from the mass M. Singular as K -> 0.                                   (G.36)
///
/// Bands include the error of a fitted heat loss. The total mass is in the tank where the tail starts.
///
/// Throws ReadingError for a bad reading, and another std::invalid_argument naming what else is out of range.
/// Throws DomainError
/// - if the tank pressure does not rise above its noise,
/// - if a temperature of the record itself leaves the species' range (draws that do so are `misfits`),
/// - if the iteration for Cd A does not settle.
Identified identify(const TankTest& test, const TankReadings& readings, const IdentifyOptions& options = {});

}  // namespace gas
