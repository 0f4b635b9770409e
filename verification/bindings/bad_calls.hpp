// SPDX-License-Identifier: Apache-2.0
// What the tests of bad calls share: one good object of each kind, and what a refusal is.
#pragma once

#include <gasjet_exact.h>

#include <cstdio>

#include "meshes.hpp"

namespace border_test {

inline constexpr double kNotFinite[] = {kNan, kInfinity, -kInfinity};
inline constexpr double kNotPositive[] = {kNan, kInfinity, -kInfinity, 0.0, -1.0};
inline constexpr double kNotCounted[] = {kNan, kInfinity, -kInfinity, -1.0};  // neither 0 nor above

/// Counts its refusals.
struct BadCalls : testing::Test {
  void refused(int status, const char* text, const std::string& argument) {
    ++calls;
    EXPECT_EQ(status, GASJET_BAD_INPUT) << argument << ": " << text;
    EXPECT_EQ(std::string(text).rfind(argument, 0), 0u)
        << "'" << text << "' does not begin with " << argument;
  }
  void refused(int status, const std::string& argument) { refused(status, gasjet_last_error(), argument); }

  /// Every bad value of one argument.
  template <class Values, class Call>
  void each(const Values& bad_values, const std::string& argument, Call&& call) {
    for (const auto value : bad_values) {
      SCOPED_TRACE(argument + " = " + std::to_string(value));
      refused(call(value), argument);
    }
  }

  /// Handles that are none of the wanted kind.
  template <class Call>
  void each_bad_handle(const std::string& argument, gasjet_handle of_another_kind, Call&& call) {
    gasjet_handle freed = 0;
    ASSERT_OK(gasjet_gas_create("N2=1", 0.0, &freed));
    ASSERT_OK(gasjet_free(freed));
    for (const gasjet_handle handle :
         {gasjet_handle{0}, gasjet_handle{-1}, INT64_MAX, INT64_MIN, freed, of_another_kind})
      refused(call(handle), argument);
  }

  void TearDown() override {
    RecordProperty("bad_calls", calls);
    std::printf("%d bad calls\n", calls);
  }
  void SetUp() override {
    ASSERT_OK(gasjet_gas_create("N2=1", 0.0, &gas.value));
    ASSERT_OK(gasjet_tank_create(gas.value, 2e5, 300.0, 0.1, 1e5, 1e-8, &tank.value));
    ASSERT_OK(gasjet_surface_create(t(), m(), nullptr, n(), nullptr, 0, nullptr, 0, &surface.value));
    ASSERT_OK(gasjet_jet_create(&model, t(), m(), nullptr, n(), nullptr, 0, nullptr, 0, &jet.value));
    ASSERT_OK(gasjet_membrane_create(x(), n(), nullptr, t(), m(), nullptr, &fabric, nullptr, 0, nullptr, 0,
                                     &bag.value));
    ASSERT_OK(gasjet_contact_create(x(), n(), nullptr, t(), m(), nullptr, mass.data(), 1.0, 0.2, 1e5, 0.1,
                                    &contact.value));
  }
  const double* x() const { return mesh.nodes.data(); }
  const int32_t* t() const { return mesh.triangles.data(); }
  int64_t n() const { return mesh.node_count(); }
  int64_t m() const { return mesh.triangle_count(); }

  Mesh mesh = box(2, 1.0, -0.5);
  gasjet_jet_model model = round_jet();
  gasjet_fabric_model fabric{4e-4, 800.0, 3e8, 0.3, 0, GASJET_SAINT_VENANT_KIRCHHOFF};
  gasjet_source source{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 0.1};
  std::vector<double> mass = std::vector<double>(static_cast<std::size_t>(mesh.node_count()), 1e-3);
  std::vector<double> values = std::vector<double>(200, 7.0);
  std::vector<uint8_t> lit = std::vector<uint8_t>(100, 7);
  Handle gas, tank, surface, jet, bag, contact;
  int calls = 0;
};

}  // namespace border_test
