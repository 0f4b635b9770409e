// SPDX-License-Identifier: Apache-2.0
#include "step/mean_outlet.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace driver {
namespace {

using gas::Side;

// Gauss and Legendre's rule of eight points on [-1, 1]; those below 0 mirror these.
struct GaussPoint {
  double place, weight;
};
constexpr std::array<GaussPoint, 4> kGauss{{{0.18343464249564980494, 0.36268378337836198297},
                                            {0.52553240991632898582, 0.31370664587788728734},
                                            {0.79666647741362673959, 0.22238103445337447054},
                                            {0.96028985649753623168, 0.10122853629037625915}}};

class OutletIntegral {
 public:
  OutletIntegral(const Scene& scene, const JetPart& part, double bag_pressure)
      : scene_(scene), part_(part), bag_pressure_(bag_pressure) {}

  // From knot to knot, where both curves are linear.
  void add(double begin, double end) {
    const gas::Inflow& inflow = scene_.gas->model.inflows[part_.inflator];
    for (double a = begin; a < end;) {
      const double b = std::min({end, inflow.mass_flow.next_knot(a), inflow.temperature.next_knot(a)});
      if (inflow.mass_flow.value(a) > 0.0 || inflow.mass_flow.value(b, Side::before) > 0.0) add_piece(a, b);
      a = b;
    }
  }

  // Over a kick of `length` [s] after which the inflator has burnt for `since` [s].
  jet::OutletState mean(double length, double since) const {
    if (!(mass_ > 0.0)) return at_rest(since);
    const double velocity = thrust_ / mass_, area_ratio = area_ratio_ / mass_;
    return {velocity,          mass_ / (length * part_.outlet.area * velocity * area_ratio),
            pressure_ / mass_, temperature_ / mass_,
            area_ratio,        reflected_ / thrust_};
  }

  jet::OutletState at(double since, Side side = Side::after) const { return state(point(since, side)); }

 private:
  gas::InflatorPoint point(double since, Side side = Side::after) const {
    gas::InflatorPoint gas = gas::inflator_point_since_firing(scene_.gas->model, part_.inflator, since, side);
    gas.mass_flow *= part_.share;
    return gas;
  }

  jet::OutletState state(const jet::OutletModel& outlet, const gas::InflatorPoint& gas) const {
    return jet::outlet_state(outlet,
                             {gas.mass_flow, gas.temperature, gas.cp, gas.gas_constant, bag_pressure_});
  }
  jet::OutletState state(const gas::InflatorPoint& gas) const { return state(part_.outlet, gas); }

  jet::OutletState at_rest(double since) const {
    gas::InflatorPoint gas = point(since);
    gas.mass_flow = 0.0;
    return state(gas);
  }

  bool choked(double since, Side side = Side::after) const {
    jet::OutletModel sonic = part_.outlet;
    sonic.law = jet::OutletLaw::sonic;
    return state(sonic, point(since, side)).pressure > bag_pressure_;
  }

  // Where an outlet that matches the bag's pressure chokes or unchokes, its velocity has a corner.
  void add_piece(double a, double b) {
    if (part_.outlet.law == jet::OutletLaw::sonic || choked(a) == choked(b, Side::before))
      return add_smooth(a, b);
    const bool first = choked(a);
    double low = a, high = b;
    for (double middle = 0.5 * (a + b); low < middle && middle < high; middle = 0.5 * (low + high))
      (choked(middle) == first ? low : high) = middle;
    add_smooth(a, low);
    add_smooth(low, b);
  }

  // V0 goes with the root u of the temperature: in u, the integrals are those of polynomials.
  void add_smooth(double a, double b) {
    const auto& temperature = scene_.gas->model.inflows[part_.inflator].temperature;
    const double first = std::sqrt(temperature.value(a)),
                 rise = std::sqrt(temperature.value(b, Side::before)) - first, sum = 2.0 * first + rise;
    const auto sample = [&](double s, double weight) {
      const double u = first + s * rise;
      add_sample(a + (b - a) * s * (first + u) / sum, (b - a) * weight * 2.0 * u / sum);
    };
    if (rise == 0.0 && part_.outlet.law == jet::OutletLaw::sonic) return sample(0.5, 1.0);
    for (const auto& [place, weight] : kGauss) {
      sample(0.5 * (1.0 - place), 0.5 * weight);
      sample(0.5 * (1.0 + place), 0.5 * weight);
    }
  }

  void add_sample(double since, double weight) {
    const gas::InflatorPoint gas = point(since);
    const jet::OutletState outlet = state(gas);
    const double mass = weight * gas.mass_flow;
    mass_ += mass;
    thrust_ += mass * outlet.velocity;
    pressure_ += mass * outlet.pressure;
    temperature_ += mass * outlet.temperature;
    area_ratio_ += mass * outlet.area_ratio;
    reflected_ += mass * outlet.velocity * outlet.reflected;
  }

  const Scene& scene_;
  const JetPart& part_;
  double bag_pressure_;
  double mass_ = 0.0, area_ratio_ = 0.0;       // [kg]
  double thrust_ = 0.0, reflected_ = 0.0;      // [N s]
  double pressure_ = 0.0, temperature_ = 0.0;  // [kg Pa], [kg K]
};

}  // namespace

jet::OutletState mean_outlet(const Scene& scene, const JetPart& part, const BlowInterval& interval,
                             double bag_pressure) {
  OutletIntegral integral(scene, part, bag_pressure);
  if (!(interval.length > 0.0)) return integral.at(interval.end);
  integral.add(std::max(interval.begin, 0.0), interval.end);
  return integral.mean(interval.length, interval.end);
}

}  // namespace driver
