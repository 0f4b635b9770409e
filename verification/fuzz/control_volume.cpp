// SPDX-License-Identifier: Apache-2.0
// For any finite parameters the integrator refuses, or its balance of mass closes.
#include "gas/control_volume.hpp"

#include <cmath>
#include <stdexcept>
#include <vector>

#include "bytes.hpp"
#include "gas/error.hpp"
#include "gas/integrator.hpp"

namespace {

double mass_of(const gas::ControlVolumeState& state) {
  double sum = 0.0;
  for (const double m : state.masses) sum += m;
  return sum;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Bytes bytes(data, size);
  try {
    gas::ControlVolumeModel model{
        gas::Thermo({gas::nasa7_species("N2")}), {bytes.number(), bytes.number()}, {}, {}};
    const gas::Curve flow({{0.0, bytes.number()}, {bytes.number(), bytes.number()}}, gas::Outside::zero);
    model.inflows.push_back({{1.0}, flow, gas::Curve::constant(bytes.number()), 0.0});
    model.vents.push_back({bytes.number(), bytes.number()});
    gas::IntegratorOptions options;
    options.method = static_cast<gas::Method>(bytes.integer(0, 4));
    options.maximum_steps = 1000;
    const double volume = bytes.number(), end = bytes.number(), leak = bytes.number();
    const std::vector<double> pure{1.0};
    auto state = gas::make_state(model, pure, bytes.number(), bytes.number(), volume);
    gas::GasIntegrator integrator(model, options);
    const double before = mass_of(state);
    const gas::StepFluxes fluxes = integrator.advance(state, 0.0, end, {volume, volume, leak, leak});
    const double in = fluxes.mass_in, out = fluxes.vent_mass_out + fluxes.fabric_mass_out;
    const double after = mass_of(state);
    fuzz::require(std::isfinite(after) && after >= 0.0, "the mass is finite and not negative");
    fuzz::require(std::abs(before + in - out - after) <= 1e-6 * (before + in), "mass is kept");
  } catch (const std::invalid_argument&) {
  } catch (const gas::DomainError&) {
  }
  return 0;
}
