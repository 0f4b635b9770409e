// SPDX-License-Identifier: Apache-2.0
// SAE J211-1 / ISO 6487 channel frequency classes: what a crash laboratory does to a measured signal.
#pragma once

#include <span>
#include <vector>

namespace driver {

/// Class of an impactor's acceleration: 49 CFR 572.200 (g)(5).
inline constexpr double impactor_channel_class = 180.0;

/// (K.22) Four-pole phaseless Butterworth low-pass of SAE J211-1, appendix C: a two-pole filter run forward
/// and backward. `channel_class` [Hz] is the CFC, the gain is 0.707 near 1.65 CFC and |H| = 1/(1 + (f/f_c)^4)
/// with f_c = 2.0775 CFC. Samples every `interval` [s], at least 10 CFC a second; the ends are held. Throws
/// std::invalid_argument.
std::vector<double> channel_filter(std::span<const double> samples, double interval, double channel_class);

/// A signal of two components at uneven, increasing times [s].
struct PlanarSignal {
  std::vector<double> time, first, second;
};

/// Largest resultant of the filtered components, resampled linearly to 100 kHz; 0 for fewer than two samples.
double filtered_peak(const PlanarSignal& signal, double channel_class);

}  // namespace driver
