// SPDX-License-Identifier: Apache-2.0
// Channel frequency classes of SAE J211-1 / ISO 6487, by which crash laboratories filter measured signals.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

namespace driver {

/// Channel class of an impactor's acceleration [Hz]: 49 CFR 572.200 (g)(5).
inline constexpr double impactor_channel_class = 180.0;

/// Classes [Hz] of SAE J211-1, by which columns of acceleration may be filtered.
inline constexpr std::array channel_classes{60, 180, 600, 1000};
/// Those that every ensemble has beside the acceleration of the centre of gravity.
inline constexpr std::array ensemble_channel_classes{60, 180};
/// Widest interval [s] between samples that a class lets pass: ten times its frequency.
constexpr double widest_interval(double channel_class) {
  return 0.1 / channel_class;
}
/// Name of such a column [m/s2]: of a pendulum's centre of gravity, or of another impactor.
std::string filtered_column(int channel_class, bool of_pendulum = true);

/// Filtered samples (K.22): four-pole phaseless Butterworth low-pass of SAE J211-1, appendix C, a two-pole
/// filter run forward and backward. `channel_class` [Hz] is the CFC. The gain is 0.707 near 1.65 CFC, and
/// |H| = 1/(1 + (f/f_c)^4) with f_c = 2.0775 CFC. `interval` [s] lies between samples; at least 10 CFC
/// samples a second are needed. Beyond its ends the signal is held. Throws std::invalid_argument.
std::vector<double> channel_filter(std::span<const double> samples, double interval, double channel_class);

/// A signal with two components or three, at increasing times [s] of any spacing.
struct VectorSignal {
  std::vector<double> time, first, second, third{};
};

/// Resultant of the filtered components at the times of the signal, of at least two samples. In between it is
/// resampled linearly to 100 kHz. Throws std::invalid_argument.
std::vector<double> filtered_resultant(const VectorSignal& signal, double channel_class);

/// Largest resultant of the filtered components, after linear resampling to 100 kHz; 0 for fewer than two
/// samples.
double filtered_peak(const VectorSignal& signal, double channel_class);

/// Head injury criterion [-] of an acceleration [m/s2], filtered by class 1000: the largest (t2 - t1) (mean
/// acceleration / g)^2.5 over intervals of up to `window` [s], 0.015 or 0.036 (49 CFR 571.208). Intervals
/// begin and end at multiples of 0.1 ms (K.58). 0 for fewer than two samples.
double head_injury_criterion(const VectorSignal& signal, double window);

}  // namespace driver
