// SPDX-License-Identifier: Apache-2.0
// Wrong calls that change a jet or ask for a part of it: not GASJET_OK, a text that begins with the
// argument's name, outputs as they were.
#include "bad_calls.hpp"

using namespace border_test;
using bad_calls = BadCalls;

namespace {

/// Arguments of gasjet_jet_pressure_of and its kin, all good; a test makes one bad.
template <class Number>
struct PressureOf {
  gasjet_handle jet;
  const Number* nodes;
  int64_t node_count;
  const int64_t* stride = nullptr;
  const Number* velocities = nullptr;
  const int64_t* velocity_stride = nullptr;
  double velocity = 1.0, density = 1.0, bound = kNan;
  const int32_t* elements = nullptr;
  int64_t element_count = 0;
  double* overpressure = nullptr;
  int64_t overpressure_count = 0;
  double* force = nullptr;
  double* power = nullptr;

  int operator()() const {
    const auto function = [] {
      if constexpr (std::is_same_v<Number, float>)
        return gasjet_jet_pressure_float;
      else
        return gasjet_jet_pressure_of;
    }();
    return function(jet, nodes, node_count, stride, velocities, velocity_stride, velocity, density, 1, bound,
                    elements, element_count, overpressure, overpressure_count, force, power, nullptr);
  }
};

TEST_F(bad_calls, jet_place_and_switches) {
  const double centre[] = {0.1, 0.0, 0.0}, axis[] = {1.0, 0.0, 0.0}, zero[] = {0.0, 0.0, 0.0};
  gasjet_jet_model wide = model;
  wide.radius = kNan, wide.short_side = 0.01, wide.long_side = 0.02;
  for (int i = 0; i < 3; ++i) wide.long_direction[i] = i == 1 ? 1.0 : 0.0;
  Handle slot;
  ASSERT_OK(gasjet_jet_create(&wide, t(), m(), nullptr, n(), nullptr, 0, nullptr, 0, &slot.value));
  refused(gasjet_jet_place(jet.value, nullptr, axis, nullptr), "centre");
  refused(gasjet_jet_place(jet.value, centre, nullptr, nullptr), "axis");
  refused(gasjet_jet_place(jet.value, centre, zero, nullptr), "axis");
  refused(gasjet_jet_place(slot.value, centre, axis, axis), "long_direction");
  refused(gasjet_jet_place(slot.value, centre, axis, zero), "long_direction");
  for (const double bad : kNotFinite) {
    const double wrong[] = {0.0, bad, 0.0};
    refused(gasjet_jet_place(jet.value, wrong, axis, nullptr), "centre");
    refused(gasjet_jet_place(jet.value, centre, wrong, nullptr), "axis");
    refused(gasjet_jet_place(slot.value, centre, axis, wrong), "long_direction");
  }
  refused(gasjet_jet_set_elements(jet.value, nullptr, m()), "on");
  each(std::vector<int64_t>{0, -1, m() - 1, m() + 1, INT64_MAX, INT64_MIN}, "on",
       [&](int64_t c) { return gasjet_jet_set_elements(jet.value, lit.data(), c); });
  each(std::vector<int>{0, -1, 65, INT32_MAX, INT32_MIN}, "n",
       [&](int pieces) { return gasjet_jet_subdivide(jet.value, pieces); });
  each_bad_handle("jet", surface.value,
                  [&](gasjet_handle h) { return gasjet_jet_place(h, centre, axis, nullptr); });
  each_bad_handle("jet", surface.value,
                  [&](gasjet_handle h) { return gasjet_jet_set_elements(h, lit.data(), m()); });
  each_bad_handle("jet", surface.value, [&](gasjet_handle h) { return gasjet_jet_subdivide(h, 2); });
  each_bad_handle("jet", surface.value, [&](gasjet_handle h) { return gasjet_jet_relative_to_skin(h, 1); });
}

template <class Number>
void pressure_of(BadCalls& test) {
  const std::vector<Number> x(test.mesh.nodes.begin(), test.mesh.nodes.end());
  double force[3] = {7.0, 7.0, 7.0}, power = 7.0;
  PressureOf<Number> good{test.jet.value, x.data(), test.n()};
  good.overpressure = test.values.data(), good.overpressure_count = test.m(), good.force = force;
  const auto bad = [&](const std::string& name, auto&& change) {
    PressureOf<Number> changed = good;
    change(changed);
    test.refused(changed(), name);
  };
  bad("nodes", [](auto& a) { a.nodes = nullptr; });
  bad("nodes", [](auto& a) { a.node_count -= 1; });
  const int64_t rows[] = {0, 1};
  bad("velocities", [&](auto& a) { a.velocities = x.data(), a.velocity_stride = rows; });
  bad("velocities", [](auto& a) { a.velocities = reinterpret_cast<const Number*>(1); });
  for (const int64_t stride : {int64_t{0}, INT64_MAX, INT64_MIN}) {
    const int64_t wrong[] = {3, stride};
    bad("nodes", [&](auto& a) { a.stride = wrong; });
  }
  for (const double number : kNotFinite) {
    std::vector<Number> wrong = x;
    wrong[4] = static_cast<Number>(number);
    bad("nodes", [&](auto& a) { a.nodes = wrong.data(); });
    bad("velocities", [&](auto& a) { a.velocities = wrong.data(); });
    bad("velocity", [&](auto& a) { a.velocity = number; });
    bad("density", [&](auto& a) { a.density = number; });
  }
  bad("displacement_bound", [](auto& a) { a.bound = -1.0; });
  for (const int32_t number : {-1, INT32_MIN, INT32_MAX, static_cast<int32_t>(test.m())}) {
    const int32_t list[] = {0, number};
    bad("elements", [&](auto& a) { a.elements = list, a.element_count = 2, a.overpressure_count = 2; });
  }
  const int32_t twice[] = {1, 5, 1};
  bad("elements", [&](auto& a) { a.elements = twice, a.element_count = 3, a.overpressure_count = 3; });
  bad("elements", [](auto& a) { a.element_count = 1; });
  for (const int64_t count : {int64_t{-1}, INT64_MAX, INT64_MIN})
    bad("element_count", [&](auto& a) { a.elements = twice, a.element_count = count; });
  bad("overpressure", [&](auto& a) { a.elements = twice, a.element_count = 2; });
  bad("overpressure", [](auto& a) { a.overpressure = nullptr; });
  bad("force", [](auto& a) { a.force = nullptr; });
  bad("power", [&](auto& a) { a.power = &power; });
  ASSERT_OK(gasjet_jet_relative_to_skin(test.jet.value, 1));
  bad("velocities", [](auto&) {});
  test.refused(gasjet_jet_pressure(test.jet.value, test.x(), test.n(), nullptr, 1, 1, 1, kNan,
                                   test.values.data(), test.m(), force, nullptr),
               "velocities");
  test.each_bad_handle("jet", test.surface.value, [&](gasjet_handle h) {
    PressureOf<Number> changed = good;
    changed.jet = h;
    return changed();
  });
  EXPECT_EQ(force[0], 7.0);
  EXPECT_EQ(power, 7.0);
  for (const double v : test.values) EXPECT_EQ(v, 7.0);
}

TEST_F(bad_calls, jet_pressure_of) {
  pressure_of<double>(*this);
}

TEST_F(bad_calls, jet_pressure_float) {
  pressure_of<float>(*this);
}

}  // namespace
