// SPDX-License-Identifier: Apache-2.0
// Units by name, as files from elsewhere have them: curves of a case, readings of `identify`, maps of
// `compare`.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace driver {

/// What a pressure counts from.
enum class PressureZero {
  none,     // a stress: it counts from nothing
  vacuum,   // an absolute pressure
  ambient,  // an overpressure
};

/// Numbers in a named unit -> SI units. Rounded by one multiplication or division, so that 35 ms is the
/// number 0.035; by both for degF, in2, deg and deg/s; and by a sum if there is an offset.
struct NamedUnit {
  double factor = 1.0;
  double divisor = 1.0;
  double offset = 0.0;  // in SI units

  double to_si(double number) const {
    const double scaled = number * factor / divisor;
    return offset == 0.0 ? scaled : scaled + offset;
  }
};

/// The unit called `name` of a quantity whose SI unit is `si` ("kg/s"; "" for a strain). "°C", "degC", "m²"
/// and "m2" are all known. The SI unit itself is always known.
///
/// Pressures may end in " gauge" or " absolute" (also psig, psia, barg, bara). Where that is not what the
/// quantity counts from, `zero`, the ambient pressure [Pa] is added or subtracted.
///
/// Throws std::invalid_argument, which says what is allowed, for an unknown name, and where the ambient
/// pressure is needed but absent.
NamedUnit unit_named(const std::string& name, std::string_view si, PressureZero zero = PressureZero::none,
                     std::optional<double> ambient_pressure = {});

}  // namespace driver
