// SPDX-License-Identifier: Apache-2.0
// One scene out of all installed libraries: a sphere of fabric is filled while its shape is held, lit from
// its centre, beside a pendulum. Returns 0 if the libraries agree with the closed forms and with each other.
#include <closed_form/gas.hpp>
#include <cmath>
#include <coupling/pendulum.hpp>
#include <cstdio>
#include <gas/integrator.hpp>
#include <jet/visibility.hpp>
#include <mesh/icosphere.hpp>
#include <numeric>
#include <tank_test/smoothing_spline.hpp>

namespace {

// Pressure [Pa] in `volume` [m3] of nitrogen after 10 ms of 1 kg/s at 700 K.
double filled_pressure(double volume) {
  const gas::Thermo thermo({gas::constant_cp_species("N2", 296.8, 1038.8)});
  gas::ControlVolumeModel model{thermo, {101325.0, 293.15}, {}, {}};
  model.inflows.push_back({{1.0}, gas::Curve::constant(1.0), gas::Curve::constant(700.0)});
  auto state = gas::make_state(thermo, model.inflows[0].mass_fractions, 101325.0, 293.15, volume);
  gas::GasIntegrator(model).advance(state, 0.0, 0.01, {volume, volume, 0.0, 0.0});
  return gas::evaluate(model, state, volume, 0.0, 0.01).pressure;
}

// At `time`, of the line 1 + t read 40 times.
double spline_of_a_line(double time) {
  std::vector<double> times(40), readings(40);
  std::iota(times.begin(), times.end(), 0.0);
  std::iota(readings.begin(), readings.end(), 1.0);
  const gas::SmoothingSpline spline(times, readings);
  return gas::evaluate(spline.basis(time), spline.coefficients()).value;
}

bool holds(const char* what, double computed, double expected, double tolerance) {
  const bool is_near = std::abs(computed - expected) <= tolerance;
  std::printf("%s: %.12g, expected %.12g: %s\n", what, computed, expected, is_near ? "holds" : "differs");
  return is_near;
}

}  // namespace

int main() {
  const mesh::Mesh mesh = mesh::icosphere(0.3, 3);
  const double volume = mesh::enclosed_volume(mesh.nodes, mesh.elements);
  const double pressure = closed_form::tank_fill({{}, volume, 101325.0, 293.15, 1.0, 700.0}, 0.01).pressure;
  const auto lit = jet::visible(mesh.nodes, mesh.elements, jet::RaySource{});
  const coupling::PendulumModel rod({{0, 0, 0}, {0, -1, 0}, {0, 0, -1}, 3.0, 0.25, 0.5, 1.0, 0.05});
  bool all = holds("pressure", filled_pressure(volume), pressure,
                   1e-9 * pressure);  // the gas integration's tolerance
  all &= holds("lit", std::accumulate(lit.begin(), lit.end(), 0.0), mesh.element_count(), 0.0);
  all &= holds("inertia of a rod", rod.axis_inertia(), 3.0 / 3.0, 1e-15);  // m L^2 / 3, in three operations
  // A straight line has no third derivative to smooth; what is left is the linear solver's.
  all &= holds("spline", spline_of_a_line(4.5), 5.5, 1e-9);
  return all ? 0 : 1;
}
