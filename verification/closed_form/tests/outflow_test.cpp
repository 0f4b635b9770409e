// SPDX-License-Identifier: Apache-2.0
// Reference numbers: 40-digit arithmetic (mpmath), rounded to 17 digits: the law as printed, with differences
// of powers, which 40 digits bear.
#include "check.hpp"
#include "closed_form/orifice.hpp"

namespace {

using namespace closed_form;
using test::expect_refused;
using test::expect_relative;
using test::kAlgebra;

constexpr double kAmbient = 101325.0;

Orifice figure_hole(double overpressure) {
  return {{}, 0.085, 1.0, kAmbient + overpressure, 673.0, kAmbient};
}

PorousFabric figure_fabric(double overpressure, double porosity) {
  return {{}, porosity, 0.085, PorosityLaw::printed, kAmbient + overpressure, 673.0, kAmbient};
}

TEST(ClosedFormOutflow, critical_ratio_and_flux_eq_reference) {
  struct Row {
    double gamma, ratio, flux;
  };
  for (const Row& r : {Row{1.4, 0.52828178771717411, 0.68473145637727038},
                       Row{5.0 / 3.0, 0.48713928962874674, 0.72618437741389067},
                       Row{1.3, 0.54572773381406477, 0.66726235124086157},
                       Row{9.0 / 7.0, 0.54832271640894978, 0.66466750465953704},
                       Row{1.25, 0.55492895730664363, 0.65806479175174931}}) {
    expect_relative(critical_pressure_ratio(r.gamma), r.ratio, kAlgebra);
    expect_relative(choked_flux_coefficient(r.gamma), r.flux, kAlgebra);
  }
}

TEST(ClosedFormOutflow, figure_3_of_the_paper_eq_reference) {
  struct Row {
    double overpressure, hole, fabric;
  };
  for (const Row& r : {Row{1000.0, 2.7064475900556699, 2.7207292132678412},
                       Row{10000.0, 8.5313799909347156, 8.9740977350059896},
                       Row{50000.0, 18.814024071255214, 23.395632272130098},
                       Row{90000.0, 24.915511113589478, 35.294055058449866},
                       Row{100000.0, 26.217871633212788, 38.163069391616205}}) {
    // 1/(dp/p) = 100 at 1 kPa: the overpressure given as a difference loses two digits.
    expect_relative(orifice_mass_flow(figure_hole(r.overpressure)), r.hole, 1e-13);
    expect_relative(porous_mass_flow(figure_fabric(r.overpressure, 1.0)), r.fabric, 1e-13);
    expect_relative(porous_mass_flow(figure_fabric(r.overpressure, 0.05)), 0.0025 * r.fabric, 1e-13);
  }
  expect_relative(choking_overpressure(1.4, kAmbient), 90476.047009113065, kAlgebra);
}

TEST(ClosedFormOutflow, flux_is_continuous_with_zero_slope_at_the_critical_ratio) {
  for (const double gamma : {1.25, 1.4, 5.0 / 3.0}) {
    const double p = 4e5;
    const double critical = critical_pressure_ratio(gamma) * p;
    const auto flow = [&](double ambient) {
      return orifice_mass_flow({{296.8, gamma}, 1e-3, 0.8, p, 500.0, ambient});
    };
    const double choked = flow(0.0);
    expect_relative(flow(critical * (1 + 1e-15)), choked, kAlgebra);
    // Quadratic departure: (1e-4)^2 times a coefficient below 10.
    EXPECT_LT(flow(critical * 1.0001), choked);
    expect_relative(flow(critical * 1.0001), choked, 1e-7);
    expect_relative(flow(critical * 0.5), choked, kAlgebra);
  }
}

TEST(ClosedFormOutflow, flow_scales_with_area_coefficient_pressure_temperature) {
  const Orifice base{{}, 1e-3, 0.6, 2e5, 500.0, kAmbient};
  const double flow = orifice_mass_flow(base);
  Orifice scaled = base;
  scaled.area = 2e-3;
  scaled.discharge_coefficient = 0.3;
  expect_relative(orifice_mass_flow(scaled), flow, kAlgebra);
  scaled = base;
  scaled.temperature = 2000.0;
  expect_relative(orifice_mass_flow(scaled), flow / 2.0, kAlgebra);
  scaled = base;
  scaled.pressure *= 3.0;
  scaled.ambient_pressure *= 3.0;
  expect_relative(orifice_mass_flow(scaled), 3.0 * flow, kAlgebra);
  scaled = base;
  scaled.ambient_pressure = 2e5;
  EXPECT_EQ(orifice_mass_flow(scaled), 0.0);
}

TEST(ClosedFormOutflow, bernoulli_ratio_eq_reference_down_to_round_off) {
  struct Row {
    double epsilon, ratio;
  };
  // The last three are where a plain difference of powers gives 1.0000000000, 1.0001 and 0.88.
  for (const Row& r :
       {Row{0.1, 0.94491953748905229}, Row{0.01, 0.99462843764706682}, Row{1e-4, 0.99994642713641},
        Row{1e-6, 0.99999946428557079}, Row{1e-8, 0.99999999464285716}, Row{1e-12, 0.99999999999946432},
        Row{1e-15, 0.99999999999999933}})
    expect_relative(bernoulli_ratio(1.4, r.epsilon), r.ratio, kAlgebra);
}

TEST(ClosedFormOutflow, bernoulli_series_remainder_is_third_order) {
  for (const double gamma : {1.25, 1.4, 5.0 / 3.0}) {
    const auto remainder = [gamma](double e) {
      return std::abs(bernoulli_ratio(gamma, e) - bernoulli_ratio_series(gamma, e));
    };
    for (const double e : {0.04, 0.02, 0.01}) {
      const double order = std::log2(remainder(2 * e) / remainder(e));
      EXPECT_GT(order, 2.9);
      EXPECT_LT(order, 3.2);  // the fourth-order term adds about e to the order
    }
  }
}

TEST(ClosedFormOutflow, porosity_laws_differ_by_eta) {
  expect_relative(leak_area(0.05, 1.5), 0.00375, kAlgebra);
  expect_relative(leak_area(0.05, 1.5, PorosityLaw::screen), 0.075, kAlgebra);
  PorousFabric fabric = figure_fabric(3000.0, 0.1);
  const double printed = porous_mass_flow(fabric);
  fabric.law = PorosityLaw::screen;
  expect_relative(porous_mass_flow(fabric), 10.0 * printed, kAlgebra);
  EXPECT_EQ(porous_mass_flow(figure_fabric(0.0, 0.05)), 0.0);
}

TEST(ClosedFormOutflow, bad_parameters_are_refused_by_name) {
  expect_refused([] { critical_pressure_ratio(1.0); }, "heat_capacity_ratio");
  expect_refused([] { bernoulli_ratio(1.4, 0.6); }, "epsilon");
  expect_refused([] { leak_area(1.1, 1.0); }, "porosity");
  Orifice hole = figure_hole(1000.0);
  hole.discharge_coefficient = 1.5;
  expect_refused([&] { orifice_mass_flow(hole); }, "discharge_coefficient");
}

}  // namespace
