// SPDX-License-Identifier: Apache-2.0
#include <gasjet/jet.h>

#include "border.hpp"
#include "jet/outlet.hpp"

using namespace border;

int gasjet_outlet(int law, double area, double mass_flow, double temperature, double cp, double gas_constant,
                  double bag_pressure, gasjet_outlet_state* state) {
  return call([&] {
    if (law < GASJET_SONIC_STATIC || law > GASJET_EXPANDED)
      refuse("law", "is " + std::to_string(law) + ", allowed: a gasjet_outlet_law, 0 to 3");
    jet::OutletModel model;
    if (law == GASJET_PRESSURE_MATCHED) model.law = jet::OutletLaw::pressure_matched;
    if (law == GASJET_EXPANDED) model.law = jet::OutletLaw::expanded;
    model.temperature = law == GASJET_SONIC_STATIC ? jet::OutletTemperature::static_value
                                                   : jet::OutletTemperature::stagnation;
    model.area = positive(area, "area");
    number(mass_flow, "mass_flow", 0.0);
    positive(temperature, "temperature");
    positive(gas_constant, "gas_constant");
    if (!(number(cp, "cp") > gas_constant))
      refuse("cp", "is " + shown(cp) + ", allowed: above gas_constant, " + shown(gas_constant));
    if (model.law != jet::OutletLaw::sonic) positive(bag_pressure, "bag_pressure");
    jet::validate(model);
    const auto out = jet::outlet_state(model, {mass_flow, temperature, cp, gas_constant, bag_pressure});
    const gasjet_outlet_state all{out.velocity, out.density, out.pressure, out.temperature};
    needed(state, "state") = finite(all, "state");
  });
}
