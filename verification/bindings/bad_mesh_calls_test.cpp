// SPDX-License-Identifier: Apache-2.0
// Wrong calls: not GASJET_OK, a text that begins with the argument's name, outputs as they were.
#include <atomic>
#include <functional>
#include <thread>

#include "bad_calls.hpp"

using namespace border_test;
using bad_calls = BadCalls;

namespace {

TEST_F(bad_calls, surface) {
  gasjet_handle out = 0;
  const auto create = [&](const int32_t* triangles, int64_t count, int64_t nodes,
                          const int32_t* null = nullptr, int64_t nulls = 0) {
    return gasjet_surface_create(triangles, count, nullptr, nodes, null, nulls, nullptr, 0, &out);
  };
  refused(create(nullptr, m(), n()), "triangles");
  each(std::vector<int64_t>{0, -1, INT64_MAX, INT64_MIN}, "triangle_count",
       [&](int64_t c) { return create(t(), c, n()); });
  each(std::vector<int64_t>{0, -1, INT64_MAX, 3 * m() + 20000001, INT32_MAX - 4}, "node_count",
       [&](int64_t c) { return create(t(), m(), c); });
  refused(create(t(), m(), n() - 1), "triangles");
  const int32_t wrong[] = {0, 1, -1}, element[] = {99}, before[] = {-1};
  refused(create(wrong, 1, n()), "triangles");
  refused(create(t(), m(), n(), element, 1), "null_elements");
  refused(create(t(), m(), n(), before, 1), "null_elements");
  refused(create(t(), m(), n(), nullptr, 1), "null_elements");
  refused(create(t(), m(), n(), element, -1), "null_elements");
  for (const int64_t bad : {int64_t{0}, INT64_MAX, INT64_MIN}) {
    const int64_t stride[] = {3, bad}, rows[] = {bad, 1};
    refused(gasjet_surface_create(t(), m(), stride, n(), nullptr, 0, nullptr, 0, &out), "triangles");
    refused(gasjet_surface_create(t(), m(), rows, n(), nullptr, 0, nullptr, 0, &out), "triangles");
    refused(gasjet_surface_visible(surface.value, x(), n(), stride, &source, nullptr, 0, kNan, lit.data(),
                                   m(), nullptr),
            "nodes");
  }
  EXPECT_EQ(out, 0);
  const auto ask = [&](const double* nodes, int64_t count, const gasjet_source* from, const int32_t* some,
                       int64_t somes, uint8_t* mask, int64_t masks, double bound = kNan) {
    return gasjet_surface_visible(surface.value, nodes, count, nullptr, from, some, somes, bound, mask, masks,
                                  nullptr);
  };
  refused(ask(nullptr, n(), &source, nullptr, 0, lit.data(), m()), "nodes");
  each(std::vector<int64_t>{0, -1, 1, n() + 1, INT64_MAX}, "nodes",
       [&](int64_t c) { return ask(x(), c, &source, nullptr, 0, lit.data(), m()); });
  const auto* between = reinterpret_cast<const double*>(reinterpret_cast<const char*>(x()) + 4);
  refused(ask(between, n(), &source, nullptr, 0, lit.data(), m()), "nodes");
  refused(ask(x(), n(), nullptr, nullptr, 0, lit.data(), m()), "source");
  refused(ask(x(), n(), &source, nullptr, 0, nullptr, m()), "lit");
  each(std::vector<int64_t>{0, -1, m() - 1, INT64_MAX}, "lit",
       [&](int64_t c) { return ask(x(), n(), &source, nullptr, 0, lit.data(), c); });
  refused(ask(x(), n(), &source, element, 1, lit.data(), 1), "candidates");
  refused(ask(x(), n(), &source, before, 1, lit.data(), 1), "candidates");
  refused(ask(x(), n(), &source, element, -1, lit.data(), 1), "candidate_count");
  for (const double bad : {-1.0, kInfinity, -kInfinity})
    refused(ask(x(), n(), &source, nullptr, 0, lit.data(), m(), bad), "displacement_bound");
  for (const double bad : kNotFinite) {
    gasjet_source moved = source;
    moved.centre[1] = bad;
    refused(ask(x(), n(), &moved, nullptr, 0, lit.data(), m()), "source.centre");
    moved = source, moved.axis[2] = bad;
    refused(ask(x(), n(), &moved, nullptr, 0, lit.data(), m()), "source.axis");
    moved = source, moved.half_long = bad;
    refused(ask(x(), n(), &moved, nullptr, 0, lit.data(), m()), "source.half_long");
    auto nodes = mesh.nodes;
    nodes[4] = bad;
    EXPECT_EQ(ask(nodes.data(), n(), &source, nullptr, 0, lit.data(), m()), GASJET_BAD_INPUT);
    EXPECT_STRNE(gasjet_last_error(), "");
    ++calls;
  }
  each_bad_handle("surface", jet.value, [&](gasjet_handle h) {
    return gasjet_surface_visible(h, x(), n(), nullptr, &source, nullptr, 0, kNan, lit.data(), m(), nullptr);
  });
  for (const uint8_t byte : lit) EXPECT_EQ(byte, 7);
}

TEST_F(bad_calls, jet) {
  gasjet_handle out = 0;
  const auto create = [&](const gasjet_jet_model* given) {
    return gasjet_jet_create(given, t(), m(), nullptr, n(), nullptr, 0, nullptr, 0, &out);
  };
  refused(create(nullptr), "model");
  refused(gasjet_jet_defaults(nullptr), "model");
  const auto with = [&](const std::function<void(gasjet_jet_model&)>& change) {
    gasjet_jet_model changed = model;
    change(changed);
    ++calls;
    EXPECT_EQ(create(&changed), GASJET_BAD_INPUT);
    return std::string(gasjet_last_error());
  };
  for (const double bad : kNotFinite) {
    EXPECT_NE(with([&](auto& j) { j.centre[0] = bad; }).find("centre"), std::string::npos);
    EXPECT_NE(with([&](auto& j) { j.axis[1] = bad; }).find("axis"), std::string::npos);
    EXPECT_NE(with([&](auto& j) { j.decay_coefficient = bad; }).find("decay_coefficient"), std::string::npos);
    EXPECT_NE(with([&](auto& j) { j.restitution = bad; }).find("restitution"), std::string::npos);
    EXPECT_NE(with([&](auto& j) { j.cut_off = bad; }).find("cut_off"), std::string::npos);
    EXPECT_NE(with([&](auto& j) { j.radius = std::isnan(bad) ? 0.0 : bad; }).find("radius"),
              std::string::npos);
  }
  EXPECT_NE(with([](auto& j) { j.radius = kNan; }).find("side"), std::string::npos);
  EXPECT_NE(with([](auto& j) { j.axis[0] = 0.0; }).find("axis"), std::string::npos);
  EXPECT_EQ(with([](auto& j) { j.long_side = 0.1; }).find("radius: is given with"), 0u);
  EXPECT_EQ(with([](auto& j) { j.cone_half_angle = 0.1; }).find("cone_half_angle: is given without"), 0u);
  EXPECT_EQ(out, 0);
  double force[3] = {7.0, 7.0, 7.0};
  const auto press = [&](const double* nodes, int64_t count, double v, double d, double bound, double* p,
                         int64_t ps, double* f) {
    return gasjet_jet_pressure(jet.value, nodes, count, nullptr, v, d, 1, bound, p, ps, f, nullptr);
  };
  double* p = values.data();
  refused(press(nullptr, n(), 1, 1, kNan, p, m(), force), "nodes");
  each(std::vector<int64_t>{0, -1, n() - 1}, "nodes",
       [&](int64_t c) { return press(x(), c, 1, 1, kNan, p, m(), force); });
  each(kNotCounted, "velocity", [&](double v) { return press(x(), n(), v, 1, kNan, p, m(), force); });
  each(kNotCounted, "density", [&](double d) { return press(x(), n(), 1, d, kNan, p, m(), force); });
  each(kNotPositive, "area_ratio", [&](double a) { return gasjet_jet_expansion(jet.value, a, 1, 1); });
  each(kNotPositive, "reflected", [&](double r) { return gasjet_jet_expansion(jet.value, 1, r, 1); });
  refused(gasjet_jet_expansion(jet.value, 1, 1.0001, 1), "reflected");
  for (const double bad : {-0.51, 4.01, kInfinity, -kInfinity})
    refused(gasjet_jet_expansion(jet.value, 1, 1, bad), "restitution");
  each_bad_handle("jet", surface.value, [&](gasjet_handle h) { return gasjet_jet_expansion(h, 1, 1, 1); });
  refused(press(x(), n(), 1, 1, -1.0, p, m(), force), "displacement_bound");
  refused(press(x(), n(), 1, 1, kNan, nullptr, m(), force), "overpressure");
  refused(press(x(), n(), 1, 1, kNan, p, m() + 1, force), "overpressure");
  refused(press(x(), n(), 1, 1, kNan, p, m(), nullptr), "force");
  for (const double bad : kNotFinite) {
    auto nodes = mesh.nodes;
    nodes[0] = bad;
    refused(press(nodes.data(), n(), 1, 1, kNan, p, m(), force), "nodes");
  }
  each_bad_handle("jet", surface.value, [&](gasjet_handle h) {
    return gasjet_jet_pressure(h, x(), n(), nullptr, 1, 1, 1, kNan, p, m(), force, nullptr);
  });
  refused(gasjet_jet_velocity(&model, nullptr, 1, nullptr, p, 3), "points");
  refused(gasjet_jet_velocity(&model, x(), 2, nullptr, p, 3), "velocity");
  refused(gasjet_jet_velocity(&model, x(), -1, nullptr, p, 3), "points");
  EXPECT_EQ(force[0], 7.0);
  for (const double v : values) EXPECT_EQ(v, 7.0);
}

TEST_F(bad_calls, membrane_and_contact) {
  gasjet_handle out = 0;
  const auto create = [&](const gasjet_fabric_model* f, const double* nodes) {
    return gasjet_membrane_create(nodes, n(), nullptr, t(), m(), nullptr, f, nullptr, 0, nullptr, 0, &out);
  };
  refused(create(nullptr, x()), "fabric");
  refused(create(&fabric, nullptr), "reference");
  for (const double bad : kNotPositive)
    for (double gasjet_fabric_model::*member :
         {&gasjet_fabric_model::thickness, &gasjet_fabric_model::density,
          &gasjet_fabric_model::young_modulus}) {
      gasjet_fabric_model changed = fabric;
      changed.*member = bad;
      EXPECT_EQ(create(&changed, x()), GASJET_BAD_INPUT);
      EXPECT_STRNE(gasjet_last_error(), "");
      ++calls;
    }
  for (const int64_t law : {int64_t{-1}, int64_t{2}, INT64_MAX}) {
    gasjet_fabric_model changed = fabric;
    changed.law = law;
    refused(create(&changed, x()), "fabric.law");
  }
  gasjet_fabric_model stiff_in_compression = fabric;
  stiff_in_compression.law = GASJET_HENCKY;
  refused(create(&stiff_in_compression, x()), "fabric.wrinkles");
  EXPECT_EQ(out, 0);
  gasjet_membrane_sums sums;
  double* f = values.data();
  const auto evaluate = [&](const double* nodes, int64_t count, double gamma, double p, double* force,
                            int64_t forces, gasjet_membrane_sums* s) {
    return gasjet_membrane_evaluate(bag.value, nodes, count, nullptr, gamma, p, force, nullptr, forces, s);
  };
  refused(evaluate(nullptr, n(), 1.4, 1e5, f, 3 * n(), &sums), "nodes");
  refused(evaluate(x(), n() + 1, 1.4, 1e5, f, 3 * n(), &sums), "nodes");
  each(kNotCounted, "gamma", [&](double g) { return evaluate(x(), n(), g, 1e5, f, 3 * n(), &sums); });
  each(kNotCounted, "pressure", [&](double p) { return evaluate(x(), n(), 1.4, p, f, 3 * n(), &sums); });
  each(std::vector<int64_t>{0, -1, n(), 3 * n() + 1}, "force",
       [&](int64_t c) { return evaluate(x(), n(), 1.4, 1e5, f, c, &sums); });
  refused(evaluate(x(), n(), 1.4, 1e5, f, 3 * n(), nullptr), "sums");
  refused(gasjet_membrane_masses(bag.value, nullptr, n()), "mass");
  refused(gasjet_membrane_masses(bag.value, f, n() - 1), "mass");
  each_bad_handle("membrane", contact.value,
                  [&](gasjet_handle h) { return gasjet_membrane_masses(h, f, n()); });
  const double far[] = {0.0, 0.0, 5.0};
  gasjet_contact_sums touch;
  const auto meet = [&](const double* nodes, const double* centre, double* force, int64_t forces,
                        gasjet_contact_sums* s) {
    return gasjet_contact_evaluate(contact.value, nodes, n(), nullptr, centre, nullptr, force, forces, s);
  };
  refused(meet(nullptr, far, f, 3 * n(), &touch), "nodes");
  refused(meet(x(), nullptr, f, 3 * n(), &touch), "centre");
  refused(meet(x(), far, nullptr, 3 * n(), &touch), "force");
  refused(meet(x(), far, f, n(), &touch), "force");
  refused(meet(x(), far, f, 3 * n(), nullptr), "sums");
  for (const double bad : kNotFinite) {
    const double centre[] = {bad, 0.0, 5.0};
    refused(meet(x(), centre, f, 3 * n(), &touch), "centre");
  }
  for (const double v : values) EXPECT_EQ(v, 7.0);
}

TEST_F(bad_calls, run_compare_and_exact) {
  gasjet_handle run = 0;
  const auto go = [&](const char* file, const char* text, const char* overrides, int threads,
                      gasjet_handle* out) {
    return gasjet_run(file, text, overrides, nullptr, threads, nullptr, nullptr, out);
  };
  refused(go(nullptr, nullptr, nullptr, 1, &run), "case_file");
  refused(go("", nullptr, nullptr, 1, &run), "case_file");
  refused(gasjet_run("mine.toml", "[scene]", nullptr, "", 1, nullptr, nullptr, &run), "out");
  refused(go("absent.toml", nullptr, nullptr, 1, &run), "absent.toml");
  refused(go("mine.toml", "not toml", nullptr, 1, &run), "mine.toml:1:");
  refused(go("mine.toml", "", nullptr, 1, &run), "mine.toml:");
  refused(go("mine.toml", "[scene]", "no equals sign", 1, &run), "--set no equals sign");
  refused(go("mine.toml", "[scene]", nullptr, 1, nullptr), "run");
  each(std::vector<int>{0, -1, 1025}, "threads",
       [&](int threads) { return go("mine.toml", "[scene]", nullptr, threads, &run); });
  EXPECT_EQ(run, 0);
  int64_t columns = 0, rows = 0;
  each_bad_handle("run", gas.value, [&](gasjet_handle h) { return gasjet_run_size(h, 0, &columns, &rows); });
  int verdict = 7;
  refused(gasjet_compare(nullptr, "b.csv", nullptr, nullptr, 0.0, &verdict, nullptr, 0, &rows), "mine");
  refused(gasjet_compare("a.csv", nullptr, nullptr, nullptr, 0.0, &verdict, nullptr, 0, &rows), "reference");
  refused(gasjet_compare("", "b.csv", nullptr, nullptr, 0.0, &verdict, nullptr, 0, &rows), "mine");
  refused(gasjet_compare("a.csv", "b.csv", "", nullptr, 0.0, &verdict, nullptr, 0, &rows), "map");
  refused(gasjet_compare("a.csv", "b.csv", nullptr, nullptr, 0.0, &verdict, nullptr, 0, &rows), "b.csv");
  each(kNotCounted, "tolerance", [&](double e) {
    return gasjet_compare("a.csv", "b.csv", nullptr, nullptr, e, &verdict, nullptr, 0, &rows);
  });
  EXPECT_EQ(verdict, 7);
  gasjet_handle table = 0;
  const auto exact = [&](const char* name, const char* parameters, const double* times, int64_t count,
                         const char* argument) {
    refused(gasjet_exact_create(name, parameters, times, count, &table), gasjet_exact_last_error(), argument);
  };
  const double nan[] = {kNan};
  exact(nullptr, nullptr, nullptr, 0, "name");
  exact("blowdown", "volume", nullptr, 0, "parameters");
  exact("blowdown", "volume=x", nullptr, 0, "parameters");
  exact("blowdown", "volume=nan", nullptr, 0, "parameters");
  exact("blowdown", "volume=1\nvolume=1", nullptr, 0, "parameters");
  exact("blowdown", nullptr, nullptr, 1, "times");
  exact("blowdown", nullptr, nan, 1, "times");
  exact("blowdown", nullptr, nan, -1, "count");
  exact("no_such_form", nullptr, nullptr, 0, "name");
  ++calls;
  EXPECT_EQ(gasjet_exact_create("blowdown", "volume=-1", nullptr, 0, &table), GASJET_BAD_INPUT);
  EXPECT_EQ(table, 0);
  refused(gasjet_exact_free(99), gasjet_exact_last_error(), "handle");
  ASSERT_EQ(gasjet_exact_create("blowdown", nullptr, nullptr, 0, &table), GASJET_OK);
  refused(gasjet_free(table), "handle");  // each library has its own
  refused(gasjet_exact_size(gas.value, &columns, &rows), gasjet_exact_last_error(), "table");
  EXPECT_EQ(gasjet_exact_free(table), GASJET_OK);
}

TEST_F(bad_calls, a_handle_serves_one_thread_at_a_time) {
  Mesh large = box(40, 1.0, -0.5);
  Handle shared;
  ASSERT_OK(gasjet_surface_create(large.triangles.data(), large.triangle_count(), nullptr, large.node_count(),
                                  nullptr, 0, nullptr, 0, &shared.value));
  std::atomic<int> busy = 0, other = 0, finished = 0;
  const auto work = [&] {
    std::vector<uint8_t> seen(static_cast<std::size_t>(large.triangle_count()));
    for (int i = 0; i < 200 && busy == 0; ++i) {
      const int status =
          gasjet_surface_visible(shared.value, large.nodes.data(), large.node_count(), nullptr, &source,
                                 nullptr, 0, kNan, seen.data(), large.triangle_count(), nullptr);
      if (status == GASJET_BUSY) {
        ++busy;
        EXPECT_EQ(std::string(gasjet_last_error()).rfind("surface: is used by another thread", 0), 0u);
      } else if (status != GASJET_OK) {
        ++other;
      }
    }
    ++finished;
  };
  std::thread first(work), second(work);
  first.join();
  second.join();
  EXPECT_EQ(finished, 2);
  EXPECT_GE(busy, 1);
  EXPECT_EQ(other, 0);
  calls += busy;
}

TEST_F(bad_calls, handles_are_freed_once) {
  gasjet_handle one = 0;
  ASSERT_OK(gasjet_gas_create("N2=1", 0.0, &one));
  ASSERT_OK(gasjet_free(one));
  refused(gasjet_free(one), "handle: was freed");
  refused(gasjet_free(0), "handle: is not a handle");
  EXPECT_OK(gasjet_gas_create("N2=1", 0.0, &one));
  EXPECT_STREQ(gasjet_last_error(), "");
  EXPECT_OK(gasjet_free(one));
}

}  // namespace
